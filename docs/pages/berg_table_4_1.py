"""Table 4.1 of Berg 2021 repeated

Lengths are compared on each room with `berg` in its default order with `trim = none`, so no unit of the source is
needed. A path that
breaks the tether's limit is shown with its figures; the breach stands beside it and is counted.
"""
from results import by_problem, escaped, fixed, groups, least, median, table

INTRODUCTION = """\
Berg, *A Geometric Algorithm for Online Tethered Navigation* (Lund 2021), table 4.1, one rectangular room:

| | Shnaps and Rimon's | Berg's | ratio |
|---|---:|---:|---:|
| Coverage | 98 % | 94.1 % | |
| Path length (no unit) | 4743.68 | 380.27 | 12.5 |

The source gives neither the room's size nor the tool's width. What is repeated here is the order of coverage and the
ratio of lengths, on several rooms with a tool of 0.4 m; the ratio grows with the room. `shnaps-rimon` in the order of
distance is the planner that Berg compares with; `order = split` and the banded variant improve on it. Its cells are
0.25 m, and the rooms are such that cells fit from wall to wall if the robot starts in the corner. Coverage is the area
that the tool sweeps, as a share of what the tether lets it reach; the source does not say how it measures coverage. A
path that pulls the tether over its limit is invalid, and shown with its figures nevertheless: `berg` as published
(`joins = shortest`) does not check the tether while it joins its laps. The tether is 1.1 times as long as the farthest
point needs.
"""


def times_berg(row, problem):
    reference = next((r for r in problem if r["variant"] == "berg[trim=none]"), None)
    own, berg = row.number("path_m"), reference and reference.number("path_m")
    return own / berg if own is not None and berg else None


def percent(value):
    return None if value is None else 100 * value


def room_table(problem):
    rows = []
    for row in problem:
        over = row.over_limit()
        rows.append([escaped(row["variant"]), row["outcome"], fixed(percent(row.number("coverage")), 2),
                     fixed(row.number("path_m"), 1), fixed(times_berg(row, problem), 2),
                     fixed(row.number("length_ratio"), 2), fixed(over, 2) if over else "",
                     fixed(row.number("tether_crossings"), 0),
                     "" if row["outcome"] == "ok" else escaped(row["reason"])])
    return table("llrrrrrrl", ["planner", "outcome", "coverage %", "path_m", "times berg", "length_ratio",
                               "over limit m", "crossings", "reason"], rows)


def summary(rows, problems):
    problem_of = {id(row): problem for problem in problems.values() for row in problem}
    lines = []
    for variant, own in groups(rows, lambda row: row["variant"]).items():
        coverage = [percent(row.number("coverage")) for row in own]
        lines.append([escaped(variant), str(len(own)), fixed(median(coverage), 2), fixed(least(coverage), 2),
                      fixed(median(times_berg(row, problem_of[id(row)]) for row in own), 2),
                      fixed(median(row.number("length_ratio") for row in own), 2),
                      str(sum((row.over_limit() or 0) > 0 for row in own)),
                      str(sum(row["outcome"] == "invalid" for row in own))])
    return table("lrrrrrrr", ["planner", "rooms", "coverage %", "least", "times berg", "length_ratio", "over limit",
                              "invalid"], lines)


def page(rows):
    problems = by_problem(rows)
    text = INTRODUCTION + ("\n## All rooms\n\nMedians; `least`: of coverage; `times berg`: length over that of "
                           "`berg[trim=none]` in the same room;\n`over limit`: runs that pull the tether "
                           "over its limit.\n\n")
    text += summary(rows, problems)
    for title, problem in problems.items():
        text += f"\n## {escaped(title)}\n\n{room_table(problem)}"
    return text

"""What a tether does to ordinary planners, and what it costs to respect it

The price is metres driven for each square metre covered, `leashed` over unaware: lengths alone do not compare where the
tether reaches only part of the map. An unaware path does not depend on the tether, so it is scored once for each limit;
what it covers is taken from the row with the largest target. Only pairs of two measured runs have a price.
"""
from results import by_problem, escaped, fixed, greatest, groups, least, median, table

INTRODUCTION = """\
Ordinary planners on a tethered robot. Unaware (`ignore_tether = true`): the planner knows nothing of the tether and its
path is scored as driven, so the tether is pulled as far as the path leads. Leashed (`leashed`, `planner = NAME`): the
same planner in the space cut open along the anchor's cut locus, and back home at the end.

`over limit m`: metres by which the tether is pulled over its limit. `crossings`: times the robot drives over its own
tether. `entangled`: whether the tether ends wound about something. `coverage`: share of what the tether lets the robot
reach. `price`: metres driven for each square metre covered, leashed over unaware, the way home included.

## All maps

`kept`: leashed runs with a valid path that stay within the limit and never cross their own tether; crossings and price
are medians.
"""


def covered_m2(row):
    share, target = row.number("coverage"), row.number("target_m2")
    return None if share is None or target is None else share * target


def price(unaware, leashed, rows):
    if unaware is None or leashed is None:
        return None
    same = [row for row in rows if row["path_sha256"] and row["path_sha256"] == unaware["path_sha256"]
            and row["map_sha256"] == unaware["map_sha256"]]
    widest, own = greatest(covered_m2(row) for row in same + [unaware]), covered_m2(leashed)
    lengths = unaware.number("path_m"), leashed.number("path_m")
    if not widest or not own or None in lengths or not lengths[0]:
        return None
    return lengths[1] / own / (lengths[0] / widest)


def pairs_of(rows):
    """(problem, robot, planner, unaware row, leashed row, price), in the order of the rows."""
    result = []
    for title, problem in by_problem(rows).items():
        pairs = {}
        for row in problem:
            if row["planner"] == "leashed":
                pairs.setdefault(row.settings().get("planner", "boustrophedon"), {})["leashed"] = row
            elif row.settings().get("ignore_tether") == "true":
                pairs.setdefault(row["planner"], {})["unaware"] = row
        for planner, pair in pairs.items():
            unaware, leashed = pair.get("unaware"), pair.get("leashed")
            result.append((title, problem[0]["robot"], planner, unaware, leashed, price(unaware, leashed, rows)))
    return result


def number(row, column, digits):
    return fixed(row.number(column), digits) if row else ""


def map_table(pairs):
    lines = []
    for _, _, planner, unaware, leashed, cost in pairs:
        failed = "; ".join(f"{row['outcome']}: {row['reason']}" for row in (unaware, leashed) if row and not row.valid)
        entangled = {None: "", True: "yes", False: "no"}[unaware.entangled() if unaware else None]
        lines.append([planner, number(unaware, "path_m", 1), number(unaware, "coverage", 4),
                      fixed(unaware.over_limit(), 2) if unaware else "", number(unaware, "tether_crossings", 0),
                      entangled,
                      number(leashed, "path_m", 1), number(leashed, "coverage", 4), fixed(cost, 3), escaped(failed)])
    return table("lrrrrlrrrl", ["planner", "path_m", "coverage", "over limit m", "crossings", "entangled",
                                "leashed path_m", "leashed coverage", "price", "what failed"], lines)


def kept(row):
    return row.valid and row.over_limit() == 0 and row.number("tether_crossings") == 0


def summary(pairs):
    lines = []
    for (planner, robot), own in groups(pairs, lambda pair: (pair[2], pair[1])).items():
        unaware = [pair[3] for pair in own if pair[3]]
        leashed = [pair[4] for pair in own if pair[4]]
        prices = [pair[5] for pair in own]
        lines.append([planner, escaped(robot), f"{sum((row.over_limit() or 0) > 0 for row in unaware)} of {len(own)}",
                      fixed(median(row.number("tether_crossings") for row in unaware), 0),
                      f"{sum(bool(row.entangled()) for row in unaware)} of {len(own)}",
                      f"{sum(kept(row) for row in leashed)} of {len(leashed)}",
                      fixed(least(row.number("coverage") or 0 for row in leashed), 4),
                      fixed(median(prices), 3), fixed(greatest(prices), 3)])
    return table("llrrrrrrr", ["planner", "robot", "over limit", "crossings", "entangled", "leashed: kept",
                               "least coverage", "price", "highest"], lines)


def page(rows):
    pairs = pairs_of(rows)
    text = INTRODUCTION + "\n" + summary(pairs)
    for title, own in groups(pairs, lambda pair: pair[0]).items():
        text += f"\n## {escaped(title)}\n\n{map_table(own)}"
    return text

"""How short `shortest` and `polished` make paths, and what each part contributes

Figures are geometric means over the maps of the suite; a variant that leaves a map without a valid path has none.
"""
import math

from results import fixed, groups, least, table

INTRODUCTION = """\
`shortest` starts from several paths and anneals them (algorithms/improve/improve.hpp); `polished` does the same to the
path of one planner, `planner = NAME`. The budget is a number of moves, so the same settings give the same path.

`length ratio`: path length over the shortest that could cover as much. `least coverage`: certified, on the worst map.
`processor s`: for planning, on one core. Geometric means over the maps.
"""


def mean(rows, column):
    values = [row.number(column) for row in rows]
    if not values or any(value is None or value <= 0 for value in values):
        return None
    return math.exp(sum(map(math.log, values)) / len(values))


def row_of(title, rows):
    return [title, fixed(mean(rows, "length_ratio"), 3), fixed(least(row.number("coverage_lower") for row in rows), 5),
            fixed(mean(rows, "mission_s"), 0), fixed(mean(rows, "plan_cpu_s"), 2)]


HEAD = ["length ratio", "least coverage", "mission s", "processor s"]


def by_budget(rows):
    chosen = [row for row in rows if row["planner"] == "shortest"
              and not {"temperature", "objective"} & set(row.settings())]
    cells = groups(chosen, lambda row: (row.settings().get("coverage", "1"), int(row.settings()["moves"])))
    return table("lrrrr", ["coverage, moves"] + HEAD,
                 [row_of(f"{coverage}, {moves}", cells[coverage, moves]) for coverage, moves in sorted(cells)])


def is_ablation(row):
    own = row.settings()
    if row["planner"] == "shortest":
        return own["moves"] == "300000" and own.get("coverage") == "0.99"
    return True


def ablation(rows):
    variants = groups([row for row in rows if is_ablation(row)], lambda row: row["variant"])
    return table("lrrrr", ["variant"] + HEAD, [row_of(f"`{name}`", members) for name, members in variants.items()])


def page(rows):
    maps = groups([row for row in rows if row["planner"] == "shortest" and row.settings()["moves"] == "2000000"],
                  lambda row: row["map"])
    each = [[name] + [fixed(row.number("length_ratio"), 3) for row in
                      sorted(members, key=lambda row: float(row.settings().get("coverage", "1")))]
            for name, members in maps.items()]
    return "\n".join([INTRODUCTION, "## By budget and coverage\n", by_budget(rows),
                      "\n## By start, temperature and objective\n",
                      "Coverage 0.99 and 300,000 moves, but for `boustrophedon`, which is what others start from.\n",
                      ablation(rows), "\n## Length ratio by map, 2,000,000 moves\n",
                      table("lrrr", ["map", "0.99", "0.9999", "1"], each)]) + "\n"

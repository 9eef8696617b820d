"""Short paths: how far annealing gets, by budget, coverage and start

Figures are geometric means over the maps of the suite; a variant that leaves a map without a valid path has none.
"""
from results import escaped, fixed, geometric_mean, groups, least, table

INTRODUCTION = """\
`shortest` starts from several short paths and anneals them; `polished` does the same to the path of one planner,
`planner = NAME`. Both then add detours until the coverage asked for is reached. The budget is a number of moves
(`moves`), so the same settings give the same path on every machine.

`length ratio`: path length over the shortest that could cover as much, by its area alone. `gap`: path length over the
best certified lower bound, less 1. `coverage`: certified, on the worst map. `seconds`: of one processor, for planning.
Maps are 10 x 8 m (fields 24 x 16 m), the robot has radius 0.2 m and a tool as wide as itself.
"""
HEAD = ["length ratio", "gap", "coverage", "seconds"]


def row_of(title, rows):
    ratio = geometric_mean(row.number("length_ratio") if row.valid else None for row in rows)
    gaps = [row.number("gap") for row in rows]
    gap = geometric_mean(1 + value if value is not None else None for value in gaps)
    return [title, fixed(ratio, 3), fixed(None if gap is None else gap - 1, 3),
            fixed(least(row.number("coverage_lower") for row in rows), 5),
            fixed(geometric_mean(row.number("plan_cpu_s") for row in rows), 2)]


def is_budget(row):
    return row["planner"] == "shortest" and "temperature" not in row.settings()


def by_budget(rows):
    cells = groups([row for row in rows if is_budget(row)],
                   lambda row: (row.settings().get("coverage", "1"), int(row.settings()["moves"])))
    return table("lrrrr", ["coverage, moves"] + HEAD,
                 [row_of(f"{coverage}, {moves:,}", cells[coverage, moves]) for coverage, moves in sorted(cells)])


def is_part(row):
    own = row.settings()
    return row["planner"] != "shortest" or (own["moves"] == "300000" and own.get("coverage") == "0.99")


def by_part(rows):
    variants = groups([row for row in rows if is_part(row)], lambda row: row["variant"])
    return table("lrrrr", ["variant"] + HEAD, [row_of(escaped(name), runs) for name, runs in variants.items()])


def by_map(rows):
    longest = [row for row in rows if is_budget(row) and row.settings()["moves"] == "2000000"]
    at = {(row["map"], row.settings().get("coverage", "1")): row.number("length_ratio") for row in longest}
    base = {row["map"]: row.number("length_ratio") for row in rows if row["variant"] == "boustrophedon"}
    coverages = sorted({coverage for _, coverage in at})
    lines = [[name, fixed(base.get(name), 3)] + [fixed(at.get((name, coverage)), 3) for coverage in coverages]
             for name in dict.fromkeys(row["map"] for row in longest)]
    return table("lr" + "r" * len(coverages), ["map", "boustrophedon"] + coverages, lines)


def page(rows):
    return "\n".join([INTRODUCTION, "## By coverage and budget\n", by_budget(rows),
                      "\n## By start and temperature\n",
                      "Coverage 0.99 and 300,000 moves; `boustrophedon`, from which most start, for comparison.\n",
                      by_part(rows), "\n## Length ratio on each map, 2,000,000 moves, by coverage\n", by_map(rows)])

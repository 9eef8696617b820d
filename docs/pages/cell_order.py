"""Orders of boustrophedon cells: generalised tour, postman, and the plain order

Ratios are taken on the same map over `boustrophedon` with its defaults.
"""
from results import escaped, fixed, greatest, groups, least, median, table

BASE = "boustrophedon"

INTRODUCTION = """\
How `boustrophedon` orders its cells, over its default on the same map. The default: `cells = slab`, runs of lanes of
one direction, ordered by local search. `cells=slab;order=gtsp`: the same runs, ordered by the tour solver.
`cells=exact`: the cells of the plane sweep, each with lanes of its own, in the same direction. `order=gtsp`: those
cells, each in its own direction, all chosen by one generalised tour (Bähnemann et al. 2019), which makes length or time
(`objective`) least. `order=postman`: a closed tour of the Reeb graph, for which cells are divided (Mannadiar and
Rekleitis 2010). `planning`: processor time; rounded, because it differs from machine to machine.
"""


def ratios(runs, bases, column):
    pairs = [(row.number(column), bases[row["map"]].number(column)) for row in runs
             if row.valid and row["map"] in bases and bases[row["map"]].valid]
    return [value / base for value, base in pairs if value is not None and base]


def rounded(value):
    """To one significant figure."""
    return "" if value is None else f"{float(f'{value:.0e}'):g}"


def summary(rows, bases):
    lines = []
    for variant, runs in groups(rows, lambda row: row["variant"]).items():
        length, time = ratios(runs, bases, "path_m"), ratios(runs, bases, "mission_s")
        lines.append([escaped(variant), f"{sum(row.valid for row in runs)} of {len(runs)}",
                      fixed(least(row.number("coverage") for row in runs if row.valid), 4),
                      fixed(median(length), 3), fixed(least(length), 3), fixed(greatest(length), 3),
                      fixed(median(time), 3), fixed(least(time), 3), fixed(greatest(time), 3),
                      rounded(median(ratios(runs, bases, "plan_cpu_s")))])
    return table("lrrrrrrrrr", ["variant", "valid", "least coverage", "length", "least", "greatest", "time", "least",
                                "greatest", "planning"], lines)


def by_family(rows, bases, column):
    families = groups(rows, lambda row: row["map_family"])
    lines = []
    for variant, runs in groups(rows, lambda row: row["variant"]).items():
        of_family = groups(runs, lambda row: row["map_family"])
        lines.append([escaped(variant)] + [fixed(median(ratios(of_family.get(f, []), bases, column)), 3)
                                           for f in families])
    return table("l" + "r" * len(families), ["variant"] + list(families), lines)


def page(rows):
    bases = {row["map"]: row for row in rows if row["variant"] == BASE}
    return (INTRODUCTION + "\n" + summary(rows, bases) + "\n## Length by kind of map\n\nMedians.\n\n"
            + by_family(rows, bases, "path_m") + "\n## Time by kind of map\n\nMedians.\n\n"
            + by_family(rows, bases, "mission_s"))

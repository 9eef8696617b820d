"""Car-like robots: fields driven by a tractor that cannot turn on the spot

Ratios are taken on the same map with the same planner; the robot that turns on the spot is the base.
"""
from results import by_problem, escaped, fixed, greatest, groups, least, median, table

INTRODUCTION = """\
A tractor of radius 1 m with a tool 3 m wide and a least turning radius of 4 m (`tractor`), the same with a reverse
gear (`reverse`), and one that turns on the spot (`spot`), on the same fields with the same planners. All three drive
the lanes that the planner lays out; the first two by the shared step that makes any path drivable: lanes in an order
that leaves room for turns, Dubins or Reeds-Shepp curves between them, the tool lifted where they cover nothing new.
`length`, `time`: over those of `spot` on the same map. `coverage`: of the target; what cannot be reached without a
reverse gear stays uncovered. `violations`: bends sharper than the robot can drive.
"""


def ratios(rows, bases, column):
    pairs = [(row, bases.get((row["map"], row["variant"]))) for row in rows]
    return [row.number(column) / base.number(column) for row, base in pairs if row.valid and base and base.valid]


def summary(rows):
    bases = {(row["map"], row["variant"]): row for row in rows if row["robot"] == "spot"}
    lines = []
    for (variant, robot), runs in groups(rows, lambda row: (row["variant"], row["robot"])).items():
        valid = [row for row in runs if row.valid]
        coverage = [row.number("coverage") for row in valid]
        lines.append([escaped(variant), robot, f"{len(valid)} of {len(runs)}",
                      fixed(median(ratios(runs, bases, "path_m")), 3),
                      fixed(median(ratios(runs, bases, "mission_s")), 3),
                      fixed(median(coverage), 4), fixed(least(coverage), 4),
                      fixed(greatest(row.number("curvature_violations") for row in valid), 0),
                      fixed(median(row.number("cusps") for row in valid), 0)])
    return table("llrrrrrrr", ["planner", "robot", "valid", "length", "time", "coverage", "least", "violations",
                                "cusps"], lines)


def outcomes(rows):
    lines = []
    for title, problem in by_problem(rows).items():
        for row in problem:
            if row["robot"] == "spot":
                continue
            lines.append([escaped(title), escaped(row["variant"]), row["outcome"], fixed(row.number("path_m"), 0),
                          fixed(row.number("transit_m"), 0), fixed(row.number("mission_s"), 0),
                          fixed(row.number("coverage"), 4), escaped(row["reason"])])
    return table("lllrrrrl", ["map", "planner", "outcome", "path m", "transit m", "time s", "coverage", "reason"],
                 lines)


def page(rows):
    return INTRODUCTION + "\n" + summary(rows) + "\n## Each run\n\n" + outcomes(rows)

"""Loops round obstacles: coverage next to walls

The published form is the variant that says so in full: no fill, the source's epsilon on this robot, every loop driven
there and back. A run without a valid path has no figures; its outcome is shown instead.
"""
from results import by_problem, escaped, fixed, least, median, table

COLUMNS = [("stc", "stc"), ("stc-loops[close_loops=false;epsilon=0.05;fill=none]", "published"),
           ("stc-loops[fill=none]", "fill=none"), ("stc-loops[fill=cells]", "fill=cells"), ("stc-loops", "stc-loops")]

INTRODUCTION = """\
What `stc` leaves uncovered next to walls, and what loops round the obstacles add. `published`: the loops as the
source has them (`fill = none`, `epsilon = 0.05`, which is 0.01 m on this robot, `close_loops = false`).
`fill=none`: the same a fifth as far off the walls, unbroken loops driven round once. `fill=cells`: uncovered sub-cells
attached to the tree as well. `stc-loops`: the default, `fill = spots`, uncovered spots as well.
"""

STEPS = """
## Step by step

Made by `scripts/stages` in a room of its own; two pillars are too near to each other and one to the wall.

| | |
|---|---|
| ![stc](pictures/stc-loops/1-stc.svg) | ![bisectors](pictures/stc-loops/2-bisectors.svg) |
| `stc`: uncovered areas around obstacles and along the boundary | bisectors |
| ![nodes](pictures/stc-loops/3-nodes.svg) | ![loops](pictures/stc-loops/4-loops.svg) |
| nodes along the edges | nodes connected to loops; the invalid ones stand out |
| ![broken loops](pictures/stc-loops/5-broken-loops.svg) | ![merged tree](pictures/stc-loops/6-merged-tree.svg) |
| broken loops: connected components | merged spanning tree |
| ![published](pictures/stc-loops/7-published.svg) | ![filled](pictures/stc-loops/8-filled.svg) |
| the path round it, as published | the default: uncovered spots as branches |
"""


def variant(problem, name):
    return next((row for row in problem if row["variant"] == name), None)


def figure(row, column, digits):
    if row is None:
        return ""
    return fixed(row.number(column), digits) if row.valid else row["outcome"]


def figures(problems, column, digits):
    rows = [[escaped(title)] + [figure(variant(problem, name), column, digits) for name, _ in COLUMNS]
            for title, problem in problems.items()]
    return table("l" + "r" * len(COLUMNS), ["map"] + [title for _, title in COLUMNS], rows)


def summary(problems):
    lines = []
    for name, title in COLUMNS:
        pairs = [(variant(problem, name), variant(problem, "stc")) for problem in problems.values()]
        pairs = [(row, stc) for row, stc in pairs if row]
        valid = [(row.number("coverage"), stc and stc.number("coverage"), row) for row, stc in pairs if row.valid]
        coverage = [share for share, _, _ in valid]
        above = sum(stc is None or share > stc for share, stc, _ in valid)
        lines.append([escaped(title), f"{len(valid)} of {len(pairs)}", fixed(least(coverage), 4),
                      fixed(median(coverage), 4), f"{sum(share >= 0.99 for share in coverage)} of {len(pairs)}",
                      f"{above} of {len(pairs)}", fixed(median(row.number("length_ratio") for _, _, row in valid), 3)])
    return table("lrrrrrr", ["variant", "valid", "least coverage", "median", "0.99 or more", "above stc",
                             "length ratio"], lines)


def page(rows):
    problems = by_problem(rows)
    return (INTRODUCTION + "\n" + summary(problems) + STEPS + "\n## Coverage\n\n" + figures(problems, "coverage", 4)
            + "\n## Length of the path, m\n\n" + figures(problems, "path_m", 1))

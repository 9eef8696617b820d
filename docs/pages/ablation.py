"""Ablation: what each part of `shortest` is worth

Figures are geometric means over the maps of the suite; a variant that leaves a map without a valid path has none.
"""
from results import fixed, geometric_mean, groups, least, table

INTRODUCTION = """\
`shortest` with one of its parts left out (`without = PART`), the same budget of 300,000 moves and the same seed. A
part that is worth something makes the path longer where it is missing.

`length ratio`: path length over the shortest that could cover as much, by its area alone. `longer`: than with all
parts, per cent. `coverage`: certified, on the worst map. `seconds`: of one processor, for planning. Maps are 10 x 8 m
(fields 24 x 16 m and 70 x 24 m), the robot has radius 0.2 m and a tool as wide as itself. One seed: differences below
half a per cent on a single map are chance.
"""
WITHOUT = {
    "none": "nothing: all parts",
    "starts": "starts: only `boustrophedon` in its own direction",
    "heat": "heat: moves that make the path worse",
    "windows": "windows: large paths annealed as a whole",
    "reordering": "moves that reorder the path (2-opt, Or-opt)",
    "covering": "moves that cover an uncovered point",
    "walls": "following walls",
    "focus": "focus of closing on what is uncovered",
    "closing": "closing in rounds: its moves are made before",
    "strokes": "strokes along walls as detours",
    "detours": "short detours: all by the general repair",
}


def part(row):
    return row.settings().get("without", "none")


def by_part(rows):
    runs = groups(rows, part)
    ratio = {name: geometric_mean(row.number("length_ratio") if row.valid else None for row in of)
             for name, of in runs.items()}

    def line(name):
        longer = ratio[name] / ratio["none"] - 1 if ratio[name] and ratio.get("none") else None
        return [WITHOUT[name], fixed(ratio[name], 3), fixed(None if longer is None else 100 * longer, 2),
                fixed(least(row.number("coverage_lower") for row in runs[name]), 5),
                fixed(geometric_mean(row.number("plan_cpu_s") for row in runs[name]), 2)]

    return table("lrrrr", ["left out", "length ratio", "longer", "coverage", "seconds"],
                 [line(name) for name in WITHOUT if name in runs])


def by_map(rows):
    at = {(row["map"], part(row)): row.number("length_ratio") for row in rows if row.valid}
    names = [name for name in WITHOUT if name != "none" and any(part(row) == name for row in rows)]

    def longer(on, name):
        whole, without = at.get((on, "none")), at.get((on, name))
        return fixed(None if not whole or not without else 100 * (without / whole - 1), 2)

    return table("l" + "r" * len(names), ["map"] + names,
                 [[on] + [longer(on, name) for name in names] for on in dict.fromkeys(row["map"] for row in rows)])


def page(rows):
    text = [INTRODUCTION]
    for coverage, runs in groups(rows, lambda row: row.settings()["coverage"]).items():
        text += [f"## Coverage {coverage}\n", by_part(runs), "\nLonger without the part, per cent, on each map:\n",
                 by_map(runs)]
    return "\n".join(text)

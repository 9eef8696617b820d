"""Anytime: how short `shortest` and `polished` get by their budget, on twenty maps

Figures are geometric means over the maps of the suite; a budget that leaves a map without a valid path has none.
"""
import math

from chart import Line, Panel, chart
from results import fixed, geometric_mean, groups, least, table

START = "boustrophedon"
COLOURS = {"shortest": "#0a63b8", "polished": "#d2521f"}
STEP = 0.1  # of the height axis
ROUNDING = 1e-9

INTRODUCTION = """\
![length ratio over the number of moves, at two coverages](pictures/anytime.svg)

`length ratio`: path length over the shortest that could cover as much, by its area alone. Thick lines are geometric
means over the maps, thin ones single maps with `shortest`. `start` is the path of `boustrophedon`, from which
`polished` starts; `shortest` starts from four paths, of which this is one. The seconds, of one processor for planning,
are those of `shortest` on an average map. Maps are 10 x 8 m or a little smaller (fields 24 x 16 m), the robot has
radius 0.2 m and a tool as wide as itself; all settings but `coverage` and `moves` are the defaults.
"""
PROMISES = """\
A budget is a number of moves: the same budget gives the same path, for any number of `threads`. The first path that
counts is the start with detours for what it lacks of the coverage, and only shorter ones take its position: at any
budget the result is never longer than that, and while a run goes on its paths only become shorter. Runs with different
budgets are different runs from their first move on, because the temperature falls over the whole budget: more moves
give shorter paths on average, but not on every map.
"""


def budget(row):
    return row["planner"], row.settings()["coverage"], int(row.settings()["moves"])


def annealed(rows):
    return [row for row in rows if row["planner"] in COLOURS]


def ratio(row):
    return row.number("length_ratio") if row.valid else None


def lengths(rows):
    """{map: metres} of the valid paths."""
    return {row["map"]: row.number("path_m") for row in rows if row.valid}


def longer(rows, than):
    """On how many maps, of those in both, paths are longer."""
    mine, theirs = lengths(rows), lengths(than)
    both = [name for name in mine if name in theirs]
    return f"{sum(mine[name] > (1 + ROUNDING) * theirs[name] for name in both)} of {len(both)}"


def by_budget(rows):
    start = [row for row in rows if row["planner"] == START]
    cells = groups(annealed(rows), budget)
    lines = [[START, "", "", fixed(geometric_mean(map(ratio, start)), 3),
              fixed(least(row.number("coverage_lower") for row in start), 5),
              fixed(geometric_mean(row.number("plan_cpu_s") for row in start), 3), "", ""]]
    before = None
    for planner, coverage, moves in sorted(cells, key=lambda cell: (cell[1], -list(COLOURS).index(cell[0]), cell[2])):
        mine = cells[planner, coverage, moves]
        again = cells[before] if before and before[:2] == (planner, coverage) else None
        lines.append([planner, coverage, f"{moves:,}", fixed(geometric_mean(map(ratio, mine)), 3),
                      fixed(least(row.number("coverage_lower") for row in mine), 5),
                      fixed(geometric_mean(row.number("plan_cpu_s") for row in mine), 2), longer(mine, start),
                      longer(mine, again) if again else ""])
        before = planner, coverage, moves
    return table("lrrrrrrr", ["planner", "coverage", "moves", "length ratio", "covered at least", "seconds",
                              "longer than start", "longer than with fewer moves"], lines)


def by_map(rows, coverage):
    at = {(row["map"], budget(row)): ratio(row) for row in annealed(rows)}
    budgets = sorted({moves for _, (_, share, moves) in at if share == coverage})
    lines = [[row["map"], fixed(ratio(row), 3)]
             + [fixed(at.get((row["map"], ("shortest", coverage, moves))), 3) for moves in budgets]
             for row in rows if row["planner"] == START]
    return table("lr" + "r" * len(budgets), ["map", "start"] + [f"{moves:,}" for moves in budgets], lines)


def curve(start, cells, planner, coverage, budgets):
    """[(tick, mean)]: the start is at 0, budgets follow; without those that have no mean."""
    means = [geometric_mean(map(ratio, start))]
    means += [geometric_mean(map(ratio, cells.get((planner, coverage, moves), []))) for moves in budgets]
    return [(k, value) for k, value in enumerate(means) if value is not None]


def panel(rows, coverage, budgets):
    start = [row for row in rows if row["planner"] == START]
    lines = []
    for name, runs in groups(annealed(rows), lambda row: row["map"]).items():
        own = [row for row in start if row["map"] == name]
        lines.append(Line(curve(own, groups(runs, budget), "shortest", coverage, budgets), COLOURS["shortest"],
                          0.8, 0.4))
    cells = groups(annealed(rows), budget)
    for planner, colour in reversed(COLOURS.items()):
        lines.append(Line(curve(start, cells, planner, coverage, budgets), colour, 3, name=planner))
    seconds = [geometric_mean(row.number("plan_cpu_s") for row in cells.get(("shortest", coverage, moves), []))
               for moves in budgets]
    ticks = [("start", "")] + [(f"{moves:,}", f"{fixed(value, 2)} s" if value else "")
                               for moves, value in zip(budgets, seconds)]
    return Panel(f"coverage {coverage}", lines, ticks)


def picture(rows):
    cells = groups(annealed(rows), budget)
    budgets = sorted({moves for _, _, moves in cells})
    panels = [panel(rows, coverage, budgets) for coverage in sorted({coverage for _, coverage, _ in cells})]
    highest = max(y for one in panels for line in one.lines for _, y in line.points)
    top = math.ceil(round((highest - 1) / STEP, 6))
    return chart("length ratio", panels, [(1 + STEP * k, f"{1 + STEP * k:.1f}") for k in range(top + 1)],
                 "moves, and processor seconds of shortest; thin lines: single maps with shortest")


def seen(rows, coverage):
    """One sentence: how much of what the greatest budget gains the smaller ones gain."""
    cells = groups(annealed(rows), budget)
    budgets = sorted({moves for planner, share, moves in cells if (planner, share) == ("shortest", coverage)})
    points = curve([row for row in rows if row["planner"] == START], cells, "shortest", coverage, budgets)
    gains = {budgets[k - 1]: points[0][1] - value for k, value in points if k > 0 and points[0][0] == 0}
    if len(gains) < 2 or gains[max(gains)] <= 0:
        return ""
    shares = [f"{moves:,}: {100 * gain / gains[max(gains)]:.0f} %" for moves, gain in sorted(gains.items())]
    return (f"- Coverage {coverage}: {max(gains):,} moves of `shortest` make the start "
            f"{100 * gains[max(gains)] / points[0][1]:.0f} % shorter.\n  Of this, fewer moves reach "
            f"({', '.join(shares[:-1])}).\n")


def page(rows):
    coverages = sorted({row.settings()["coverage"] for row in annealed(rows)})
    text = INTRODUCTION + "\n" + PROMISES + "".join(["\n"] + [seen(rows, coverage) for coverage in coverages])
    text += "\n## By budget\n\n" + by_budget(rows)
    for coverage in coverages:
        text += f"\n## Length ratio of `shortest` on each map, coverage {coverage}, by moves\n\n"
        text += by_map(rows, coverage)
    return text

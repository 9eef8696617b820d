"""Growth: processor seconds and memory by the size of the map

A map's size is counted in cells, squares of side tool width / sqrt 2. The order is the slope of a straight line through
log seconds over log cells; n log n has about 1.09 between 10^4 and 10^6 cells. Runs of less than 5 ms are left out of
it: they measure the clock.
"""
import math

from results import escaped, fixed, groups, table

LEAST_SECONDS = 0.005
N_LOG_N = 1.15   # 1.09, and some room for caches and noise
MOST_SECONDS = 20

INTRODUCTION = """\
Planning alone, on one core, with each planner's defaults; planners for tethered robots with a tether of 1.2 times the
distance of the farthest point. What most planners of a table need is made once for each problem and is not in the
figures: the triangulation of configuration space in which they look for shortest paths, or for tethered robots the cut
locus of the anchor. A size is the number of squares of side tool width / sqrt 2 in free space. Order: the slope of log
seconds over log cells; n log n has 1.09. MB: the greatest of the sizes, beyond what the problem takes. A run without a
path shows its outcome: `timeout` is more than 20 s of processor time; an empty field was not run. The figures are those
of one machine: orders carry over, seconds do not.

Planners whose time is a budget of moves, `shortest` and `polished`, are not in the tables: [anytime](anytime.md) shows
what they make of it.

Three published orders must grow faster than n log n among scattered obstacles, because the paths that their sources
describe do: `shnaps-rimon` visits the cells by their distance from the anchor, `shnaps-rimon-banded` by distance and
by the direction from the last bend, and `berg` goes from area to area by distance, along boundaries that overlap behind
every obstacle. What follows one another lies anywhere at the same distance, so each path there is about as long as the
map is wide, and the whole path grows as n^1.5. The figures below are those of the defaults, which finish one side of an
obstacle before the other and, for `berg`, drive each boundary only where no other path to it is shorter; `variant =
published` is what the source says. A run that ends in `timeout` has published its path so far, and a suite that
scores shows its figures.
"""


def cells(row):
    return row.number("map_area_m2") / (row.number("tool_width_m") ** 2 / 2)


def decade(row):
    return round(math.log10(cells(row)))


def order(rows):
    """The slope of log seconds over log cells; None for fewer than two sizes."""
    points = [(math.log(cells(row)), math.log(row.number("plan_cpu_s"))) for row in rows
              if row.valid and row.number("plan_cpu_s") >= LEAST_SECONDS]
    if len(points) < 2:
        return None
    x0, y0 = (sum(values) / len(points) for values in zip(*points))
    return sum((x - x0) * (y - y0) for x, y in points) / sum((x - x0) ** 2 for x, _ in points)


def seconds(row):
    if row is None:
        return ""
    return fixed(row.number("plan_cpu_s"), 3) if row.valid else row["outcome"]


def growth(rows):
    decades = sorted({decade(row) for row in rows})
    lines = []
    for variant, mine in groups(rows, lambda row: row["variant"]).items():
        at = {decade(row): row for row in mine}
        peak = max((row.number("peak_rss_bytes") for row in mine if row.valid), default=None)
        lines.append([escaped(variant)] + [seconds(at.get(d)) for d in decades]
                     + [fixed(order(mine), 2), fixed(peak and peak / 1e6, 0)])
    return table("l" + "r" * (len(decades) + 2), ["planner"] + [f"10^{d}" for d in decades] + ["order", "MB"], lines)


def offenders(rows):
    lines = []
    for (variant, family), mine in groups(rows, lambda row: (row["variant"], row["map_family"])).items():
        slope = order(mine)
        slowest = max((row.number("plan_cpu_s") for row in mine if row.valid), default=0)
        ended = next((row["outcome"] for row in mine if not row.valid), "")
        if (slope or 0) > N_LOG_N or slowest > MOST_SECONDS or ended:
            lines.append([escaped(variant), family, fixed(slope, 2), fixed(slowest, 1), ended])
    if not lines:
        return "None.\n"
    return table("llrrl", ["planner", "map", "order", "s", "ended in"], lines)


def page(rows):
    rows = [row for row in rows if row["outcome"] not in ("unsupported", "cancelled")]
    text = INTRODUCTION
    for family, mine in groups(rows, lambda row: row["map_family"]).items():
        text += f"\n## {family}\n\n" + growth(mine)
    return text + "\n## Above n log n, above 20 s, or without a path\n\n" + offenders(rows)

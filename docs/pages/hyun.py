"""Hyun's sweeping planner in its own world

The first map is the paper's world, the others are the same with the obstacles moved.
"""
from results import by_problem, fixed, least, median, table

VARIANTS = [("hyun", "default"), ("hyun[nearest=path]", "`nearest = path`"),
            ("hyun[transit=visibility]", "`transit = visibility`"),
            ("hyun[outline=false;separation_by=robot]", "`separation_by = robot`, `outline = false`"),
            ("hyun[outline=false;passes=alternate;separation_by=robot]", "the same with `passes = alternate`"),
            ("hyun[outline=false;rules=published;separation_by=robot]", "the same with `rules = published`"),
            ("hyun[variant=published]", "`variant = published`"), ("boustrophedon", "`boustrophedon`, to compare")]

INTRODUCTION = """\
`hyun` follows W. K. Hyun, "A heuristic sweeping algorithm for autonomous smearing robot". Its world is a generator:
50 m x 50 m with five obstacles, polygons and circles (the paper's figure was not available, so shapes and positions are
ours). The robot is an octagon 1 m wide with a tool as wide.

```
oxturn map hyun -o world.geojson
oxturn plan hyun world.geojson --robot footprint=octagon:1,tool_width=1 --svg world.svg
```

The command also prints what the planner counts: `tracking_points`; `links_planned`, the links for which a path had to
be searched (the paper has 5 in its world); `links_crossing`, those driven with the tool on that cross others (none, by
construction and counted); `transits_crossing`; `tlppa_failed`.
"""

REMARKS = """
- By default lanes are one tool width apart and the boundary of configuration space is driven as well: the floor is
  covered once and nothing is left. Transits lead over covered floor, because an obstacle encloses what lies beside it.
- The separation of lanes is half the robot's width, as printed, with `separation_by = robot`: everything is covered
  about twice, and a narrow robot with a wide tool covers it many times.
- Taken literally, the rules leave nearly half of the world uncovered: from the contact with an obstacle they look for
  another contact on the same side of the same obstacle, so lanes between wall and obstacle are skipped.
- What remains uncovered without `outline` lies between the last lane and a level or slanted wall, up to one separation
  wide.
- "Nearest of all" is the straight-line distance, also through walls. `nearest = path` measures along paths, which does
  not pay here, but between thin walls: `oxturn plan hyun maze:3 --set nearest=path` drives less than a quarter as far
  with the tool off.
- TLPPA sees cells of half a separation and misses passages hardly wider than the robot. The shortest path is taken
  there, and `tlppa_failed` counts it.
"""


def cells(runs):
    valid = [row for row in runs if row.valid]
    return [fixed(least(row.number("coverage") for row in valid), 3),
            fixed(median(row.number("path_m") for row in valid), 0),
            fixed(median(row.number("transit_m") for row in valid), 0),
            fixed(median(row.number("overlap") for row in valid), 2),
            fixed(median(row.number("turns") for row in valid), 0)]


def figures(rows):
    lines = []
    for variant, title in VARIANTS:
        runs = [row for row in rows if row["variant"] == variant]
        if runs:
            lines.append([title, f"{sum(row.valid for row in runs)} of {len(runs)}"] + cells(runs))
    return table("lrrrrrr", ["variant", "valid", "coverage", "path m", "tool off m", "overlap", "turns"], lines)


def page(rows):
    worlds = list(by_problem(rows).values())
    others = [row for world in worlds[1:] for row in world]
    return (INTRODUCTION + "\n## The world of the paper\n\n" + figures(worlds[0])
            + "\n## The same with the obstacles moved\n\nEight worlds: least coverage, else medians.\n\n"
            + figures(others) + "\n## Remarks\n" + REMARKS)

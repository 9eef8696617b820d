"""Tethered planners by lidar only

Pairs are rows that differ in `sensing` only. Ratios and losses are of pairs with two valid paths. The coverage promised
is that of the run with the map: `loss` is how much less is covered online.
"""
from results import by_problem, escaped, fixed, greatest, least, median, table

INTRODUCTION = """\
Each planner twice: with the map given, and on a robot that begins with no map and sees by lidar (`sensing = lidar`:
survey what can be seen, return home along the tether, plan on what is believed, drive that, then cover what has become
known since). The length by lidar includes the survey and the way home.

Coverage is the lower bound, of what the tether lets the robot reach on the true map. `loss`: coverage with the map less
that by lidar. `ratio`: path by lidar over path with the map.

## All maps

Loss and ratio are medians.
"""


def pairs_of(rows):
    """{planner: [(problem, offline row, online row, ratio, loss)]}"""
    result = {}
    for title, problem in by_problem(rows).items():
        for online in problem:
            settings = online.settings()
            if settings.pop("sensing", "") != "lidar":
                continue
            offline = next((row for row in problem if row["planner"] == online["planner"]
                            and row.settings() == settings), None)
            ratio = loss = None
            if offline and offline.valid and online.valid:
                ratio = online.number("path_m") / offline.number("path_m")
                loss = offline.number("coverage_lower") - online.number("coverage_lower")
            params = ";".join(f"{name}={value}" for name, value in settings.items())
            name = online["planner"] + (f"({params})" if params else "")
            result.setdefault(name, []).append((title, offline, online, ratio, loss))
    return result


def summary(planners):
    lines = []
    for name, pairs in planners.items():
        losses, ratios = [pair[4] for pair in pairs], [pair[3] for pair in pairs]
        lines.append([escaped(name), f"{sum(pair[2].valid for pair in pairs)} of {len(pairs)}",
                      fixed(least(pair[2].number("coverage_lower") for pair in pairs), 4), fixed(median(losses), 4),
                      fixed(greatest(losses), 4), fixed(median(ratios), 3), fixed(greatest(ratios), 3)])
    return table("lrrrrrr", ["planner", "valid", "least coverage", "loss", "greatest loss", "ratio", "greatest ratio"],
                 lines)


def map_table(pairs):
    lines = []
    for title, offline, online, ratio, _ in pairs:
        number = lambda row, column, digits: fixed(row.number(column), digits) if row else ""
        lines.append([escaped(title), number(offline, "coverage_lower", 4), number(online, "coverage_lower", 4),
                      number(offline, "path_m", 1), number(online, "path_m", 1), fixed(ratio, 3),
                      number(online, "tether_max_m", 2), number(online, "tether_limit_m", 2),
                      "" if online.valid else escaped(f"{online['outcome']}: {online['reason']}")])
    return table("lrrrrrrrl", ["map", "coverage", "by lidar", "path_m", "by lidar", "ratio", "tether_max_m", "limit",
                               "what failed"], lines)


def page(rows):
    planners = pairs_of(rows)
    text = INTRODUCTION + "\n" + summary(planners)
    for name, pairs in planners.items():
        text += f"\n## {escaped(name)}\n\n{map_table(pairs)}"
    return text

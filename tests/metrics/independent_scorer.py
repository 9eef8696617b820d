#!/usr/bin/python3
"""Scores paths by Shapely alone and compares with what oxturn wrote. Shares no code with oxturn.

    independent_scorer.py RESULTS_FOLDER              every row of runs.csv that has a path; exit 1 on any disagreement
    independent_scorer.py --path P --problem M        one pair; prints JSON

Target = (free space eroded by the robot, the part that holds the start) dilated by the tool, within free space.
Coverage = area(target & work legs dilated by the tool) / area(target). Shapely's arcs are chords of 1/64 of a
quarter circle, which moves coverage by far less than EPS_COVERAGE.
"""
import argparse
import csv
import json
import math
import os
import sys

from shapely.geometry import LineString, Point, box, shape
from shapely.ops import unary_union
from shapely.prepared import prep

EPS_COVERAGE = 2e-4   # for Shapely's own arcs, in target and in swath
EPS_LENGTH = 1e-9     # relative
EPS_INSIDE = 1e-6     # metres that a robot may stick into a wall by rounding
QUARTER = 64          # chords to a quarter circle
PIECE = 50            # segments of a line at once


def load(name):
    with open(name, encoding="utf-8") as f:
        return json.load(f)


def legs_of(path):
    for feature in path["features"]:
        points = feature["geometry"]["coordinates"]
        yield bool(feature["properties"]["tool"]), [tuple(map(float, p[:2])) for p in points]


def work_of(path, tool):
    """Points and width of each leg with the tool on; without a width it is all of the tool."""
    for feature, (on, points) in zip(path["features"], legs_of(path)):
        if on:
            yield points, float(feature["properties"].get("width") or tool)


def segments(points):
    """Each as a LineString, a point for legs that stand still."""
    kept = [p for i, p in enumerate(points) if i == 0 or p != points[i - 1]]
    return [LineString(pair) for pair in zip(kept, kept[1:])] or [Point(kept[0])]


def pieces(points):
    """LineStrings of at most PIECE segments, points for legs that stand still."""
    kept = [p for i, p in enumerate(points) if i == 0 or p != points[i - 1]]
    if len(kept) == 1:
        yield Point(kept[0])
    for i in range(0, len(kept) - 1, PIECE):
        yield LineString(kept[i:i + PIECE + 1])


class Task:
    """A problem: free space, configuration space, target. Cached by the caller, the erosion is the dear part."""

    def __init__(self, problem):
        self.free = shape(problem["geometry"]).buffer(0)
        robot = problem["properties"]["robot"]
        self.radius = float(robot["radius"])
        self.tool = float(robot["tool_width"])
        start = Point(problem["properties"]["start"][:2])
        room = self.free.buffer(-self.radius, resolution=QUARTER) if self.radius > 0 else self.free
        parts = list(getattr(room, "geoms", [room]))
        self.room = min(parts, key=lambda part: part.distance(start))
        self.target = self.room.buffer(self.tool / 2, resolution=QUARTER).intersection(self.free)
        self.walls = self.free.boundary

    def covered(self, path):
        # Segment by segment: GEOS simplifies longer lines by a hundredth of the distance before it buffers them, which
        # costs paths of many gentle bends up to a thousandth of their coverage.
        swath = [g.buffer(width / 2, resolution=QUARTER) for points, width in work_of(path, self.tool)
                 for g in segments(points)]
        # United cell by cell: one union of everything is far dearer, and areas add up.
        low_x, low_y, high_x, high_y = self.target.bounds
        side = max(16 * self.tool, max(high_x - low_x, high_y - low_y) / 24)
        area = 0.0
        for i in range(int((high_x - low_x) // side) + 1):
            for j in range(int((high_y - low_y) // side) + 1):
                cell = box(low_x + i * side, low_y + j * side, low_x + (i + 1) * side, low_y + (j + 1) * side)
                inside = prep(cell)
                near = [s.intersection(cell) for s in swath if inside.intersects(s)]
                if near:
                    area += self.target.intersection(cell).intersection(unary_union(near)).area
        return area

    def least_distance(self, path):
        """Distance of the centre line to the walls, negative if it is not all in free space."""
        free = prep(self.free.buffer(EPS_INSIDE))
        least = math.inf
        for _, points in legs_of(path):
            for piece in pieces(points):
                if not free.contains(piece):
                    return -1.0
                least = min(least, self.walls.distance(piece))
        return least

    def score(self, path):
        length = math.fsum(math.hypot(b[0] - a[0], b[1] - a[1]) for _, points in legs_of(path)
                           for a, b in zip(points, points[1:]))
        area = self.target.area
        return {"coverage": self.covered(path) / area, "target_m2": area, "path_m": length,
                "clearance_m": self.least_distance(path) - self.radius}


def disagreements(row, ours):
    """What the row and our own score do not agree on; one sentence each."""
    def number(column):
        return float(row[column])
    found = []
    if not number("coverage_lower") - EPS_COVERAGE <= ours["coverage"] <= number("coverage_upper") + EPS_COVERAGE:
        found.append("coverage %.6f is outside [%s, %s]" %
                     (ours["coverage"], row["coverage_lower"], row["coverage_upper"]))
    if abs(number("path_m") - ours["path_m"]) > EPS_LENGTH * max(ours["path_m"], 1e-300):
        found.append("path_m is %r, not %s" % (ours["path_m"], row["path_m"]))
    if ours["clearance_m"] < -EPS_INSIDE:
        found.append("the robot leaves free space by %.3g m" % -ours["clearance_m"])
    return found


def check_folder(folder):
    tasks = {}
    bad = checked = 0
    with open(os.path.join(folder, "runs.csv"), newline="", encoding="utf-8") as f:
        rows = list(csv.DictReader(f))
    for row in rows:
        if row["outcome"] not in ("ok", "partial", "timeout") or not row["path_file"]:
            continue
        if row["outcome"] == "timeout" and not row["coverage_lower"]:
            continue
        path = load(os.path.join(folder, row["path_file"]))
        if "problem" not in path:
            found, ours = ["%s does not name its problem" % row["path_file"]], {}
        else:
            name = os.path.join(folder, os.path.dirname(row["path_file"]), path["problem"]["file"])
            if name not in tasks:
                tasks[name] = Task(load(name))
            ours = tasks[name].score(path)
            found = disagreements(row, ours)
        checked += 1
        bad += bool(found)
        print("%s %s %s on %s: %s" % ("BAD" if found else "ok ", row["run_id"], row["variant"] or row["planner"],
                                      row["map"], "; ".join(found) or "coverage %.6f, %.3f m" %
                                      (ours["coverage"], ours["path_m"])))
    print("%d paths checked, %d disagree" % (checked, bad))
    if not checked:
        print("no row of runs.csv has a path", file=sys.stderr)
        return 1
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?")
    parser.add_argument("--path")
    parser.add_argument("--problem")
    args = parser.parse_args()
    if args.path and args.problem:
        print(json.dumps(Task(load(args.problem)).score(load(args.path))))
        return 0
    if not args.folder or args.path or args.problem:
        parser.error("give a results folder, or both --path and --problem")
    return check_folder(args.folder)


if __name__ == "__main__":
    sys.exit(main())

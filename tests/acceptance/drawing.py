#!/usr/bin/python3
"""Metrics of drawings by Shapely alone, on random paths over a drawing, against `oxturn score`.

Shares no code with oxturn.

usage: drawing.py OXTURN WORK_DIR

Also: a drawing as SVG is planned like a room, and `draw` writes the controller's text (skipped parts are said).
"""
import json
import math
import os
import random
import subprocess
import sys

from shapely.geometry import LineString, MultiPolygon, Point, shape
from shapely.ops import unary_union

NEAR, TOOL, QUARTER = 0.01, 0.42, 64
TOUCH = 1e-3  # of a width: so far inside finished work nothing counts
SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300">
<rect id="house" x="40" y="120" width="160" height="140" fill="#333"/>
<path id="roof" d="M30 120L120 40L210 120" fill="none" stroke="#000" stroke-width="5"/>
<path id="sun" d="M300 60a40 40 0 1 0 80 0a40 40 0 1 0 -80 0z" fill="none" stroke="#000" stroke-width="3"/>
<path id="grass" d="M10 280C100 240 300 320 390 270" fill="none" stroke="#000" stroke-width="1"/></svg>
"""


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(command)}: {done.stderr}")
    return done.stdout


def parts(line, width):
    """Segment by segment: GEOS simplifies longer lines before it buffers them."""
    points = list(line.coords)
    return [LineString(pair).buffer(width / 2, resolution=QUARTER) for pair in zip(points, points[1:])]


def random_path(strokes, rng):
    """Strokes whole, shifted, in part or at another width; transit between them."""
    legs, at = [], None
    for stroke in rng.sample(strokes, len(strokes)):
        points = stroke["geometry"]["coordinates"]
        if rng.random() < 0.3:
            points = points[: max(2, len(points) * 2 // 3)]
        if rng.random() < 0.3:
            shift = rng.choice([0.004, 0.03])
            points = [[x + shift, y] for x, y in points]
        width = stroke["properties"]["width"] if rng.random() < 0.7 else rng.choice([0.04, 0.16, 0.32])
        if at is not None:
            legs.append((False, [at, points[0]], 0))
        legs.append((True, points, width))
        at = points[-1]
    for _ in range(6):
        to = [rng.uniform(1, 19), rng.uniform(1, 14)]
        legs.append((rng.random() < 0.5, [at, to], rng.choice([0, 0.16])))
        at = to
    return legs


def angle_between(a, b, c, d):
    turn = abs(math.atan2(b[1] - a[1], b[0] - a[0]) - math.atan2(d[1] - c[1], d[0] - c[0])) % math.pi
    return min(turn, math.pi - turn)


def stroke_share(strokes, legs):
    drawn = total = 0
    for stroke in strokes:
        points = stroke["geometry"]["coordinates"]
        width = stroke["properties"]["width"]
        for a, b in zip(points, points[1:]):
            line = LineString([a, b])
            near = [LineString([c, d]).buffer(NEAR, resolution=QUARTER)
                    for on, work, used in legs if on and abs((used or TOOL) - width) <= 0.01 * width
                    for c, d in zip(work, work[1:])
                    if c != d and line.distance(LineString([c, d])) <= NEAR
                    and angle_between(a, b, c, d) <= math.radians(20)]
            total += line.length
            drawn += line.intersection(unary_union(near)).length if near else 0
    return drawn / total


def over_finished(legs, tool):
    total = 0
    for index, (on, points, _) in enumerate(legs):
        if on != tool:
            continue
        before = [g for o, p, w in legs[:index] if o for g in parts(LineString(p), (w or TOOL) * (1 - TOUCH))]
        ends = [Point(p).buffer(TOOL / 2 + NEAR, resolution=QUARTER) for p in (points[0], points[-1])]
        for a, b in zip(points, points[1:]):
            line = LineString([a, b])
            near = [g for g in before if g.intersects(line)]
            if near:
                total += line.intersection(unary_union(near)).difference(unary_union(ends)).length
    return total


def expected(drawing, legs):
    strokes = [f for f in drawing["features"] if f["geometry"]["type"] == "LineString"]
    areas = MultiPolygon([shape(f["geometry"]) for f in drawing["features"] if "fill" in f["properties"]])
    worked = unary_union([g for on, p, w in legs if on for g in parts(LineString(p), w or TOOL)])
    allowed = unary_union([areas] + [g for s in strokes for g in
                                     parts(shape(s["geometry"]), s["properties"]["width"] + 2 * NEAR)])
    return {
        "stroke_share": (stroke_share(strokes, legs), 2e-4),
        "fill_share": (worked.intersection(areas).area / areas.area, 1.5e-3),
        "spill_m2": (worked.difference(allowed).area, 5e-3),
        "tool_up_m": (sum(LineString(p).length for on, p, _ in legs if not on), 1e-6),
        "over_finished_m": (over_finished(legs, False), 2e-3),
        "work_over_finished_m": (over_finished(legs, True), 2e-2),
    }


def main():
    oxturn, work = sys.argv[1:3]
    os.makedirs(work, exist_ok=True)
    file = lambda name: os.path.join(work, name)
    with open(file("house.svg"), "w", encoding="utf-8") as out:
        out.write(SVG)
    run(oxturn, "map", file("house.svg"), "-o", file("house.geojson"))
    with open(file("house.geojson"), encoding="utf-8") as stream:
        drawing = json.load(stream)["drawing"]
    strokes = [f for f in drawing["features"] if f["geometry"]["type"] == "LineString"]
    failures = []
    for seed in range(8):
        legs = random_path(strokes, random.Random(seed))
        with open(file("path.geojson"), "w", encoding="utf-8") as out:
            json.dump({"type": "FeatureCollection", "features": [
                {"type": "Feature", "properties": {"tool": on, "width": width},
                 "geometry": {"type": "LineString", "coordinates": points}} for on, points, width in legs]}, out)
        score = json.loads(run(oxturn, "score", file("path.geojson"), file("house.geojson"), "--radius", "0.2",
                               "--tool-width", str(TOOL), "--json"))["metrics"]
        for name, (value, tolerance) in expected(drawing, legs).items():
            if score[name] is None or abs(score[name] - value) > tolerance:
                failures.append(f"seed {seed}: {name} is {score[name]}, Shapely says {value}")
    run(oxturn, "draw", file("house.svg"), "--planner", "boustrophedon", "--canvas", "10x8", "-o", file("p.geojson"),
        "--text", file("p.txt"), "--svg", file("p.svg"))
    with open(file("p.txt"), encoding="utf-8") as stream:
        rows = [line.split() for line in stream if line.strip()]
    steps = [math.dist(map(float, a[:2]), map(float, b[:2])) for a, b in zip(rows, rows[1:])]
    if max(steps) > 0.0501:
        failures.append(f"the controller's text has a step of {max(steps)} m")
    if {row[2] for row in rows} - {"0", "127"}:
        failures.append("the controller's text has an unknown rake")
    print("\n".join(failures) or "drawings: Shapely agrees")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

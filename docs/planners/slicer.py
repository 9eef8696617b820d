#!/usr/bin/env python3
"""An external planner for oxturn: the solid infill of a 3-D printing slicer, Slic3r 1.3 (Debian: apt install slic3r).

    oxturn plan --exec 'python3 docs/planners/slicer.py' rooms:7 --set pattern=concentric --svg slicer.svg

A printed layer covers a region with lines of one width, as a robot covers a floor. This program hands Slic3r the free
space as one layer of an extruded solid and reads the path back from the G-code. What is Slic3r's and what is not:

  perimeters, infill, their order and directions   Slic3r's
  the robot's body                                 Slic3r knows none. It gets the map and insets the middle of its lines
                                                   by the robot's radius (xy_size_compensation: radius less half a tool
                                                   width). What it covers where the robot cannot get to is left out
  moves with the tool off                          transit = slicer: Slic3r's, with avoid_crossing_perimeters; they
                                                   may cross walls, and then the path is invalid.
                                                   transit = routed: straight, and around walls in between (ours),
                                                   so that the pattern can be compared
"""
import itertools
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile

MM = 100            # slicer's millimetres in a metre: its G-code has three decimals, so 1e-5 m
CLEARANCE = 0.005   # tool widths by which lines stay farther off walls: more than the slicer and the G-code round by
TINY = 1e-9         # metres; less than that is rounding

DESCRIPTION = {
    "oxturn": 1, "name": "slicer", "title": "perimeters and solid infill of a 3-D printing slicer",
    "citation": "Slic3r 1.3 (A. Ranellucci et al.)", "guarantee": "none", "capabilities": ["holes"], "version": "1",
    "parameters": [
        {"name": "pattern", "type": "text", "default": "rectilinear",
         "choices": ["rectilinear", "concentric", "hilbertcurve", "archimedeanchords", "octagramspiral"],
         "help": "Slic3r's external_infill_pattern"},
        {"name": "perimeters", "type": "whole number", "default": 1, "least": 1, "most": 10,
         "help": "laps along the boundary before the infill (without one, the infill is not inset)"},
        {"name": "angle", "type": "number", "default": 0, "least": 0, "most": 359, "help": "of the infill, degrees"},
        {"name": "transit", "type": "text", "default": "routed", "choices": ["slicer", "routed"],
         "help": "moves with the tool off: as the slicer makes them, or around walls"}]}


def say(**message):
    print(json.dumps(message), flush=True)


# --- geometry ------------------------------------------------------------------------------------------------

def contains(rings, p):
    """By the parity of the edges to the right of p."""
    inside = False
    for ring in rings:
        for (ax, ay), (bx, by) in zip(ring, ring[1:]):
            if (ay > p[1]) != (by > p[1]) and p[0] < ax + (p[1] - ay) / (by - ay) * (bx - ax):
                inside = not inside
    return inside


def component(geometry, start):
    """The rings of the polygon that holds the start, or is nearest to it: it may be on the boundary."""
    polygons = [geometry["coordinates"]] if geometry["type"] == "Polygon" else geometry["coordinates"]
    inside = [rings for rings in polygons if contains(rings, start)]
    return (inside or [min(polygons, key=lambda rings: min(math.dist(p, start) for p in rings[0]))])[0]


class Router:
    """Paths around the walls of a polygon with holes."""

    def __init__(self, rings):
        self.rings = rings
        edges = [(tuple(a), tuple(b)) for ring in rings for a, b in zip(ring, ring[1:])]
        self.low = [min(p[axis] for p in rings[0]) for axis in (0, 1)]
        self.side = sum(math.dist(a, b) for a, b in edges) / len(edges) + math.dist(*edges[0]) / 1000
        self.cells = {}  # column and row -> edges: only those near a segment can block it
        for a, b in edges:
            columns, rows = self.bounds(a, b)
            for cell in ((i, j) for i in columns for j in rows):
                self.cells.setdefault(cell, []).append((a, b))

    def cell(self, p):
        return math.floor((p[0] - self.low[0]) / self.side), math.floor((p[1] - self.low[1]) / self.side)

    def bounds(self, p, q):
        (i, j), (k, m) = self.cell(p), self.cell(q)
        return range(min(i, k), max(i, k) + 1), range(min(j, m), max(j, m) + 1)

    def edges_near(self, p, q):
        """Edges in the cells that the segment pq meets, and in some more, piece by piece."""
        pieces = max(1, math.ceil(math.dist(p, q) / self.side))
        known = set()
        for k in range(pieces):
            a, b = (tuple(p[axis] + (q[axis] - p[axis]) * t / pieces for axis in (0, 1)) for t in (k, k + 1))
            columns, rows = self.bounds((min(a[0], b[0]) - TINY, min(a[1], b[1]) - TINY),
                                        (max(a[0], b[0]) + TINY, max(a[1], b[1]) + TINY))
            for cell in ((i, j) for i in columns for j in rows):
                for edge in self.cells.get(cell, ()):
                    if edge not in known:
                        known.add(edge)
                        yield edge

    def free(self, p, q):
        """Whether the segment pq stays inside; it may touch the boundary."""
        length = math.dist(p, q)
        if length < TINY:
            return True
        dx, dy = (q[0] - p[0]) / length, (q[1] - p[1]) / length
        touched = [0.0, length]
        for a, b in self.edges_near(p, q):
            off_a, off_b = dx * (a[1] - p[1]) - dy * (a[0] - p[0]), dx * (b[1] - p[1]) - dy * (b[0] - p[0])
            if min(abs(off_a), abs(off_b)) <= TINY:  # the line touches an end of the edge, or runs along it
                touched += [dx * (c[0] - p[0]) + dy * (c[1] - p[1])
                            for c, off in ((a, off_a), (b, off_b)) if abs(off) <= TINY]
            elif (off_a > 0) != (off_b > 0):
                t = off_a / (off_a - off_b)
                along = dx * (a[0] + t * (b[0] - a[0]) - p[0]) + dy * (a[1] + t * (b[1] - a[1]) - p[1])
                if TINY < along < length - TINY:
                    return False
        touched = sorted(t for t in touched if -TINY <= t <= length + TINY)
        return all(self.holds((p[0] + dx * (s + t) / 2, p[1] + dy * (s + t) / 2))
                   for s, t in zip(touched, touched[1:]) if t - s > 4 * TINY)

    def holds(self, p):
        return contains(self.rings, p) or any(self.distance(p, a, b) <= TINY for a, b in self.edges_near(p, p))

    @staticmethod
    def distance(p, a, b):
        dx, dy = b[0] - a[0], b[1] - a[1]
        t = max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)))
        return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)

    def path(self, start, goal):
        """Straight, around each ring in between on its shorter side, pulled taut. Not always the shortest path."""
        path, crossings = [start], self.crossings(start, goal)
        while crossings:
            _, k, entry, at = crossings[0]
            last = max(i for i, crossing in enumerate(crossings) if crossing[1] == k)
            _, _, leave, to = crossings[last]
            ring = [tuple(point) for point in self.rings[k][1:]]  # its edge i ends at its point i
            n = len(ring)
            ahead = [at] + [ring[(entry + i) % n] for i in range((leave - entry) % n)] + [to]
            back = [at] + [ring[(entry - 1 - i) % n] for i in range((entry - leave) % n)] + [to]
            path += min(ahead, back, key=length_of)
            crossings = crossings[last + 1:]
        return self.taut(self.taut(path + [goal])[::-1])[::-1]

    def crossings(self, p, q):
        """(distance, ring, edge, point) where the segment pq crosses the boundary, in order."""
        length = math.dist(p, q)
        dx, dy = (q[0] - p[0]) / length, (q[1] - p[1]) / length
        found = []
        for k, ring in enumerate(self.rings):
            for e, (a, b) in enumerate(zip(ring, ring[1:])):
                off_a, off_b = dx * (a[1] - p[1]) - dy * (a[0] - p[0]), dx * (b[1] - p[1]) - dy * (b[0] - p[0])
                if (off_a > 0) == (off_b > 0):
                    continue
                t = off_a / (off_a - off_b)
                at = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
                along = dx * (at[0] - p[0]) + dy * (at[1] - p[1])
                if 0 < along < length:
                    found.append((along, k, e, at))
        return sorted(found)

    def taut(self, path):
        kept = path[:1]
        for before, point in zip(path[1:], path[2:]):
            if not self.free(kept[-1], point):
                kept.append(before)
        return kept + path[-1:]


def length_of(path):
    return sum(math.dist(a, b) for a, b in zip(path, path[1:]))


# --- the slicer ----------------------------------------------------------------------------------------------

def write_solid(name, rings, height):
    """The extruded polygon, as binary STL. Top and bottom of each ring are fans about one point: they may overlap, but
    the solid is closed, and the slicer looks at half its height only."""
    facets = b""
    for ring in rings:
        middle = [sum(p[axis] for p in ring[1:]) / (len(ring) - 1) for axis in (0, 1)]
        for a, b in zip(ring, ring[1:]):
            for corners in (((a, 0), (b, 0), (b, height)), ((a, 0), (b, height), (a, height)),
                            ((b, 0), (a, 0), (middle, 0)), ((a, height), (b, height), (middle, height))):
                normal = struct.pack("<3f", 0, 0, 0)
                facets += normal + b"".join(struct.pack("<3f", *p, z) for p, z in corners) + b"\0\0"
    with open(name, "wb") as file:
        file.write(b"layer".ljust(80) + struct.pack("<I", len(facets) // 50) + facets)


def slice_layer(folder, rings, width, inset, settings):
    """The text of the G-code of one layer. Lengths in the slicer's millimetres."""
    height = width / 100  # so that the flow model's rounded line ends take 0.2 % of the width, not a fifth
    solid, code = os.path.join(folder, "layer.stl"), os.path.join(folder, "layer.gcode")
    write_solid(solid, rings, height)
    options = {
        "nozzle-diameter": width, "extrusion-width": width, "first-layer-extrusion-width": width,
        "perimeter-extrusion-width": width, "external-perimeter-extrusion-width": width,
        "infill-extrusion-width": width, "solid-infill-extrusion-width": width, "top-infill-extrusion-width": width,
        "layer-height": height, "first-layer-height": height,
        "xy-size-compensation": width * (0.5 - CLEARANCE) - inset,
        "perimeters": settings["perimeters"], "external-infill-pattern": settings["pattern"],
        "fill-angle": settings["angle"], "fill-density": "100%", "fill-pattern": "rectilinear",
        "top-solid-layers": 1, "bottom-solid-layers": 1,
        "seam-position": "nearest", "skirts": 0, "brim-width": 0, "retract-length": 0,
        "filament-diameter": width, "threads": 1}
    command = ["slic3r", "--no-gui", "--dont-arrange", "--avoid-crossing-perimeters", "--use-relative-e-distances",
               "--no-thin-walls", "--no-fill-gaps",  # these print lines of other widths than the tool's
               "--start-gcode", "", "--end-gcode", "", "-o", code]
    for name, value in options.items():
        command += ["--" + name, f"{value:.9g}" if isinstance(value, float) else str(value)]
    done = subprocess.run(command + [solid], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, "HOME": folder, "LC_ALL": "C"}, check=False)
    if done.returncode != 0 or not os.path.exists(code):
        raise RuntimeError("slic3r failed: " + (done.stdout.strip().splitlines() or ["no output"])[-1])
    with open(code) as file:
        return file.read()


def strokes(code):
    """[(tool is on, to), ...] of the G-code's moves, in the slicer's millimetres."""
    at, moves = (0.0, 0.0), []
    for line in code.splitlines():
        words = dict(re.findall(r"([A-Z])(-?[0-9.]+)", line.split(";")[0]))
        if words.get("G") not in ("0", "1") or not ("X" in words or "Y" in words):
            continue
        at = (float(words.get("X", at[0])), float(words.get("Y", at[1])))
        moves.append((float(words.get("E", 0)) > 0, at))
    return moves


# --- the path ------------------------------------------------------------------------------------------------

class Path:
    def __init__(self, start):
        self.legs, self.at = [], start

    def drive(self, to, tool):
        if to == self.at:
            return
        if not self.legs or self.legs[-1][0] != tool:
            self.legs.append((tool, [self.at]))
        self.legs[-1][1].append(to)
        self.at = to

    def geojson(self):
        return {"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"tool": tool}, "geometry": {"type": "LineString", "coordinates": points}}
            for tool, points in self.legs]}


def chains(moves):
    """[polyline, ...]: what is driven with the tool on without a break, and the moves between."""
    runs, tool, at = [], False, None
    for on, to in moves:
        if not on:
            tool, at = False, to
        elif tool:
            runs[-1].append(to)
        else:
            runs.append([at, to])
            tool = True
    return runs


def transits(moves):
    """For each chain the points of the move to it."""
    return [[to for _, to in group] for on, group in itertools.groupby(moves, key=lambda move: move[0]) if not on]


def plan(question):
    problem, settings = question["problem"], question["settings"]
    start, robot = tuple(problem["properties"]["start"]), problem["properties"]["robot"]
    free = component(problem["geometry"], start)
    low = tuple(min(p[axis] for p in free[0]) for axis in (0, 1))  # the slicer's origin: its numbers are short
    scaled = [[(MM * (x - low[0]), MM * (y - low[1])) for x, y in ring] for ring in free]
    with tempfile.TemporaryDirectory() as folder:
        code = slice_layer(folder, scaled, MM * robot["tool_width"], MM * robot["radius"], settings)
    moves = [(on, (low[0] + x / MM, low[1] + y / MM)) for on, (x, y) in strokes(code)]
    router, path = Router(component(problem["configuration_space"], start)), Path(start)
    routed = unreachable = 0
    for transit, chain in zip(transits(moves), chains(moves)):
        if not router.holds(chain[0]):
            unreachable += 1
            continue
        if settings["transit"] == "routed":
            transit = chain[:1]
            if not router.free(path.at, chain[0]):
                routed += 1
                transit = router.path(path.at, chain[0])[1:]
        for point in transit:
            path.drive(point, False)
        for point in chain[1:]:
            path.drive(point, True)
    if not path.legs:
        say(error="infeasible", reason="the slicer finds nothing to print: the map is narrower than its lines")
        return
    say(record={"transits_routed": routed, "chains_unreachable": unreachable})
    say(path=path.geojson())


def main():
    if sys.argv[1:] == ["--describe"]:
        print(json.dumps(DESCRIPTION))
        return
    say(ready=True)
    question = json.loads(sys.stdin.readline())
    try:
        plan(question)
    except (OSError, RuntimeError) as error:
        say(error="failed", reason=str(error) + (": apt install slic3r" if isinstance(error, OSError) else ""))


main()

#!/usr/bin/env python3
"""An external planner for oxturn: horizontal lanes, joined by breadth-first search, and a round along each wall.

    oxturn plan --exec 'python3 docs/planners/lanes.py' rooms:7 --svg lanes.svg

Python 3 and its standard library only. README.md in this folder describes the protocol. The region in which the robot's
centre may be (`configuration_space`) comes with the problem: the planner never has to shrink the map itself.
"""
import json
import math
import sys
import time
from collections import deque

DESCRIPTION = {
    "oxturn": 1,
    "name": "lanes",
    "title": "horizontal lanes in the nearest order, then along the walls",
    "citation": "an example",
    "guarantee": "none: what no grid point reaches is left out",
    "promise": "nothing",
    "capabilities": ["holes", "footprint"],
    "version": "1",
    "parameters": [
        {"name": "spacing", "type": "number", "default": 0.9, "least": 0.1, "most": 1,
         "help": "distance of lanes, in tool widths"},
        {"name": "walls", "type": "yes/no", "default": True, "help": "also drive along the boundary"},
    ],
}
TINY = 1e-6  # share of the tool width that keeps points off the boundary


def say(**message):
    print(json.dumps(message), flush=True)


def rings_of(geometry):
    """All rings of a Polygon or MultiPolygon; the first point is repeated at the end."""
    polygons = geometry["coordinates"]
    if geometry["type"] == "Polygon":
        polygons = [polygons]
    return [[tuple(p) for p in ring] for polygon in polygons for ring in polygon]


def crossings(edges, at, axis):
    """Where edges cross the line on which coordinate `axis` is `at`: the other coordinate, in order."""
    found = []
    for a, b in edges:
        if (a[axis] < at) != (b[axis] < at):
            t = (at - a[axis]) / (b[axis] - a[axis])
            found.append(a[1 - axis] + t * (b[1 - axis] - a[1 - axis]))
    return sorted(found)


def crosses(a, b, edges):
    """Does the open segment from a to b cross an edge?"""
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return any(side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0 for c, d in edges)


class Grid:
    """Points (column, row) inside the region, and which neighbours a straight move reaches."""

    def __init__(self, rings, spacing, inset):
        self.edges = [edge for ring in rings for edge in zip(ring, ring[1:])]
        points = [p for ring in rings for p in ring]
        self.xs, self.ys = (self.divide([p[k] for p in points], spacing, inset) for k in (0, 1))
        self.intervals = []  # of each row: the stretches inside the region
        self.links = {}
        for j, y in enumerate(self.ys):
            cuts = crossings(self.edges, y, 1)
            self.intervals.append([(a + inset, b - inset) for a, b in zip(cuts[::2], cuts[1::2]) if b - a > 2 * inset])
        for i, x in enumerate(self.xs):
            for j in range(len(self.ys)):
                if self.interval((i, j)) is not None:
                    self.links[i, j] = []
        for i, x in enumerate(self.xs):
            cuts = crossings(self.edges, x, 0)
            part = [sum(c < y for c in cuts) for y in self.ys]
            for j in range(len(self.ys)):
                if j > 0 and part[j] == part[j - 1]:
                    self.link((i, j - 1), (i, j))
                if i > 0 and self.interval((i, j)) is not None and self.interval((i, j)) == self.interval((i - 1, j)):
                    self.link((i - 1, j), (i, j))

    @staticmethod
    def divide(values, spacing, inset):
        low, high = min(values) + 10 * inset, max(values) - 10 * inset
        n = max(1, math.ceil((high - low) / spacing))
        return [low + (high - low) * k / n for k in range(n + 1)]

    def interval(self, node):
        """Which stretch of its row holds the point, or None."""
        x = self.xs[node[0]]
        for k, (a, b) in enumerate(self.intervals[node[1]]):
            if a <= x <= b:
                return node[1], k
        return None

    def link(self, a, b):
        if a in self.links and b in self.links:
            self.links[a].append(b)
            self.links[b].append(a)

    def point(self, node):
        return self.xs[node[0]], self.ys[node[1]]

    def seen_from(self, point):
        """The nearest grid point to which a straight line is free, or None."""
        by_distance = sorted(self.links, key=lambda node: math.dist(self.point(node), point))
        return next((n for n in by_distance[:100] if not crosses(self.point(n), point, self.edges)), None)

    def route(self, start, goals):
        """The shortest path over the grid from a point to the nearest of some others, or None."""
        before, queue = {start: None}, deque([start])
        while queue:
            node = queue.popleft()
            if node in goals:
                path = []
                while node is not None:
                    path.append(node)
                    node = before[node]
                return path[::-1]
            for other in self.links[node]:
                if other not in before:
                    before[other] = node
                    queue.append(other)
        return None


class Path:
    """Legs in driving order, each a polyline with the tool on or off."""

    def __init__(self, start):
        self.at, self.legs = start, []

    def drive(self, points, tool):
        while points and points[0] == self.at:
            points = points[1:]
        if not points:
            return
        if self.legs and self.legs[-1][0] == tool:
            self.legs[-1][1].extend(points)
        else:
            self.legs.append((tool, [self.at] + points))
        self.at = points[-1]

    def geojson(self):
        return {"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"tool": tool}, "geometry": {"type": "LineString", "coordinates": points}}
            for tool, points in self.legs]}


def drive_lanes(grid, path, node, until):
    """Drives the nearest lane that is left, again and again; returns where it ends, and how many it drove."""
    lanes = {}  # grid point at the end of a lane -> lane
    for other in grid.links:
        lanes.setdefault(grid.interval(other), []).append(other)
    total, ends = len(lanes), {}
    for lane, nodes in lanes.items():
        ends.setdefault(min(nodes), set()).add(lane)
        ends.setdefault(max(nodes), set()).add(lane)
    driven = 0
    while ends and time.monotonic() < until:
        route = grid.route(node, ends)
        if route is None:
            break  # the rest is not connected to the start
        path.drive([grid.point(n) for n in route], False)
        lane = ends[route[-1]].pop()
        first, last = min(lanes[lane]), max(lanes[lane])
        for end in (first, last):
            ends.get(end, set()).discard(lane)
            if end in ends and not ends[end]:
                del ends[end]
        left, right = grid.intervals[lane[0]][lane[1]]
        y = grid.ys[lane[0]]
        stretch = [(left, y), (right, y)] if route[-1] == first else [(right, y), (left, y)]
        node = last if route[-1] == first else first
        path.drive(stretch[:1], True)
        path.drive(stretch[1:], True)
        path.drive([grid.point(node)], False)
        driven += 1
        say(progress=driven / total)
        if driven % 20 == 0:
            say(publish=path.geojson())  # scored if the time runs out
    return node, driven


def drive_walls(grid, path, node, rings, until):
    """Once round each ring that a grid point sees."""
    for ring in rings:
        corner = next((k for k in range(len(ring) - 1) if grid.seen_from(ring[k]) is not None), None)
        if corner is None or time.monotonic() > until:
            continue
        goal = grid.seen_from(ring[corner])
        route = grid.route(node, {goal})
        if route is None:
            continue
        path.drive([grid.point(n) for n in route], False)
        path.drive([ring[corner]], False)
        path.drive(ring[corner + 1:] + ring[1:corner + 1], True)
        path.drive([grid.point(goal)], False)
        node = goal


def plan(message, began):
    problem, settings = message["problem"], message["settings"]
    properties = problem["properties"]
    width = properties["robot"]["tool_width"]
    rings = rings_of(problem["configuration_space"])
    grid = Grid(rings, settings["spacing"] * width, TINY * width)
    start = tuple(properties["start"])
    node = grid.seen_from(start)
    if node is None:
        say(error="infeasible", reason="no grid point can be seen from the start; try a smaller spacing")
        return
    say(trace={"name": "grid", "lines": [[grid.point(a), grid.point(b)] for a in grid.links for b in grid.links[a]]})
    path = Path(start)
    path.drive([grid.point(node)], False)
    until = began + 0.8 * message["wall_s"]
    node, driven = drive_lanes(grid, path, node, until)
    if settings["walls"]:
        drive_walls(grid, path, node, rings, until)
    say(record={"lanes": driven})
    say(path=path.geojson())


def main():
    if sys.argv[1:] == ["--describe"]:
        print(json.dumps(DESCRIPTION))
        return
    say(ready=True)
    line = sys.stdin.readline()
    plan(json.loads(line), time.monotonic())


main()

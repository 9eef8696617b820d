/// The curvature of a path at its vertices.
///
///   for (const Bend& bend : bends(path, tolerance, robot.tool_width)) worst = std::max(worst, bend.curvature);
///
/// A path is a polyline, so the curve that it stands for is not known. At a vertex where the heading changes by d
/// between edges of lengths a and b (straight parts count as one edge), its curvature is the larger of
///   1. that of the circle through the vertex and its two neighbours, 2 sin d / sqrt(a^2 + b^2 + 2 a b cos d): exact
///      for vertices on an arc, however unevenly they are spaced;
///   2. (1 - cos(d / 2)) / (w / 1000), w = tool width: an arc sampled with the largest chord error that a path may have
///      turns that much at a vertex. It keeps long edges from hiding a corner.
/// A curve of radius R sampled as paths must be has at most 1 / R. In reverse the heading is opposite to the motion; so
/// a change of gear that keeps the heading (a cusp) is no curvature. The heading at the start is free.
#pragma once

#include <functional>
#include <vector>

#include "geometry/path.hpp"

namespace oxturn {

struct Bend {
  Point at{0, 0};
  double curvature = 0;  // 1 / m
  double error = 0;      // by which it is uncertain if vertices are wrong by `tolerance`
};

/// At all vertices where the heading changes. Points nearer together than `tolerance` metres count as one. O(n).
std::vector<Bend> bends(const Path& path, double tolerance, double tool_width);
/// Calls f for each of them, in driving order: paths have millions.
void for_each_bend(const Path& path, double tolerance, double tool_width, const std::function<void(const Bend&)>& f);

/// The bend is sharper than a circle of that radius (metres, > 0) by more than 1 % and the bend's error.
bool too_sharp(const Bend& bend, double least_radius);

}  // namespace oxturn

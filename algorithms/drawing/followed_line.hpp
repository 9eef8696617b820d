/// A stroke in pieces that a robot with a least turning radius can follow with the tool on.
///
///   for (const Polyline& piece : followed_line(stroke, {.radius = 0.5, .deviation = 0.008})) ...
///
/// What bends no more sharply than the radius is kept. Elsewhere the line is followed by Dubins curves that leave it by
/// `deviation` and `turn` at most, each from where the one before ends to as far ahead as there is one; where there is
/// none, one piece ends and the next one begins in the same point, as an arc in any direction that reaches as far as
/// possible. So a tight curve becomes a chain of flat arcs, and a sharp corner two pieces.
///
///        ____                   __ __
///       /    \     becomes     /  '  \     pieces meet in ' and are joined with the tool up
///
/// Guarantee   pieces keep the radius (geometry/bends.hpp); all but sharp corners stay within `deviation` of the line
/// Complexity  O(n log n) for n vertices
#pragma once

#include <functional>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

struct FollowOptions {
  double radius = 1;          // least turning radius, metres, > 0
  double deviation = 0.01;    // metres
  double turn = 0.3;          // radians: a piece's heading from the line's
  double tool_width = 1;      // metres; what a sampled curve is (geometry/bends.hpp) depends on it
  double tolerance = 1e-9;    // metres: vertices nearer together count as one
  double chord_error = 1e-3;  // metres
  /// Whether a piece may be driven; empty: anywhere. Not asked for straight edges of the line.
  std::function<bool(const Polyline&)> free = {};
};

/// `line` has at least two points. In driving order; the first piece begins and the last one ends where the line does.
std::vector<Polyline> followed_line(const Polyline& line, const FollowOptions& options);

/// Positions of the vertices with bends that are sharper than the radius. A closed line's first point counts too, as 0.
std::vector<std::size_t> sharp_vertices(const Polyline& line, bool closed, const FollowOptions& options);

}  // namespace oxturn

/// The strokes of a path: what a car-like robot can drive of it with the tool on, without a break.
///
///   std::vector<Stroke> strokes = strokes_of(path, problem, space);
///
/// The path is cut where the robot cannot turn (rounding.hpp). Strokes that end where another one goes on in the same
/// direction become one, so laps are whole again where the path left them for a detour. Strokes whose swath the others
/// cover are left out, short ones first: links between lanes, and chords of arcs too tight to be driven.
#pragma once

#include <vector>

#include "algorithms/smoothing/car_space.hpp"

namespace oxturn {

struct Stroke {
  Polyline points;
  bool closed = false;  // can be entered anywhere; the last point is the first
};

Pose first_pose(const Polyline& line);
Pose last_pose(const Polyline& line);

/// Maximal stretches with the tool on.
std::vector<Polyline> work_lines(const Path& path);
/// O(n log n) for n vertices.
std::vector<Stroke> strokes_of(const Path& path, const Problem& problem, const CarSpace& space);

/// Shortens open strokes whose ends lead a robot without reverse gear into a dead end, by a quarter of the tool's width
/// at a time. Those without an end from which it can go on become empty.
void shorten_dead_ends(std::vector<Stroke>& strokes, const Problem& problem, const CarSpace& space);

}  // namespace oxturn

/// The taut tether along a path: how long it is, where it bends, how it pulls, and where the robot drives over it.
///
///   if (const auto run = tether_run(problem, path, problem.map_edges(), problem.tolerance()))
///     fmt::print("longest {} m, {} crossings\n", run->longest_m, run->crossings.size());
///
///   anchor o---------. bend, the pivot of the robot's motion
///                     \  angle
///                      \ /
///                 ------R-------> heading
///
/// Method      TautTether reports each part of the drive during which the tether turns about one pivot. With h the
///             pivot's distance from the driven line and s the robot's position along it (0 at the pivot's foot), the
///             angle between the heading and the direction away from the tether's pull is atan2(h, s): 0 straight away
///             from the pull, pi back along the tether; in reverse atan2(h, -s). Its mean, and the share of the path
///             above a limit, are integrals in closed form; the tether's length is convex in s, hence greatest at an
///             end. Nothing is sampled, so the figures do not depend on how the path is cut into segments.
/// Decisions   1. Where the robot is at the pivot, the angle is 0.
///             2. "Sharper than the limit" means strictly greater; a limit of pi is never exceeded.
///             3. A path that jumps, starts elsewhere or leaves free space has no tether, hence no figures.
/// Complexity  n segments: O(n), beside the cost of TautTether and CrossingDetector
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/math.hpp"
#include "geometry/edge_index.hpp"
#include "maps/followed_path.hpp"

namespace oxturn {

/// A part of the path during which the tether turns about one pivot.
struct PivotMotion {
  TautTether::Swing swing;
  Point direction{1, 0};  // of motion, unit vector; in reverse the heading is the opposite one
  Gear gear = Gear::forward;
  double path_m = 0;          // driven before it
  double begin = 0, end = 0;  // robot's position along the motion, metres from the pivot's foot; begin <= end
  double height = 0;          // the pivot's distance from the driven line, metres
  double length_at(double s) const { return swing.before + math::hypot(height, s); }  // of the tether, metres
  /// Radians, between the heading and the direction away from the tether's pull.
  double angle_at(double s) const { return math::atan2(height, gear == Gear::forward ? s : -s); }
};

struct TetherCrossing {
  double path_m = 0;
  Point at{0, 0};
};

/// Called in driving order: of each segment first the crossings, then the motions, then the vertex at its end. Each may
/// be left out.
struct TetherVisitor {
  std::function<void(const TetherCrossing&)> crossing;
  std::function<void(const PivotMotion&)> motion;
  std::function<void(const TautTether&, double path_m)> vertex;
};
/// Drives the tether along `path`.
void drive_tether(const Problem& problem, const FollowedPath& path, const TetherVisitor& visitor);

struct TetherRun {
  double longest_m = 0;    // greatest length of the tether
  Point longest_at{0, 0};  // the robot's position then
  std::size_t bends_max = 0;
  double path_m = 0;     // driven
  double angle_min = 0;  // this and the next two are meaningless if path_m is 0
  double angle_sum = 0;  // integral of the angle over the path, rad m
  double sharp_m = 0;    // metres driven with an angle above the tether's sharp_angle
  std::vector<TetherCrossing> crossings;
  double end_m = 0;       // length of the tether at the end of the path
  double geodesic_m = 0;  // geodesic distance of that point from the anchor; infinity if it is not connected
};
/// nullopt for paths of decision 3, judged within `tolerance` metres. `walls`: edges of the map's free space. Throws
/// std::logic_error without a tether.
std::optional<TetherRun> tether_run(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance);

/// "pulls its tether to 12.3 m at (3, 4), 0.3 m over its limit 12 m", or "" if the limit is kept (within
/// `tolerance` metres and 1e-9 of the limit).
std::string find_tether_flaw(const Problem& problem, const std::optional<TetherRun>& run, double tolerance);

}  // namespace oxturn

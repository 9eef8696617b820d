/// Where a car-like robot can drive: curves against configuration space, and links between two poses.
///
///   const CarSpace space(problem);
///   if (const auto link = space.simple_link(lane_end, next_begin)) drive(*link);
///
/// A curve is driven as chords that leave it by a thousandth of the tool's width at most; these are tested against
/// configuration space exactly, but for half the problem's tolerance.
/// A link is the first of these that is free:
///   1. Dubins words, shortest first; in reverse: the shortest Reeds-Shepp curve
///   2. the same between poses further ahead on the lane's line (or, in reverse, also further back), shortest first
///   3. a detour: hybrid A* over position and heading, or random trees by OMPL (detour_search.hpp)
/// Complexity  some dozens of curves of a few microseconds and O(length) segment tests; a detour up to 0.2 s
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/curve.hpp"
#include "algorithms/smoothing/detour_search.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// Who searches detours.
enum class DetourSearch { lattice, ompl };

class CarSpace {
 public:
  /// `problem` must outlive it.
  explicit CarSpace(const Problem& problem, DetourSearch search = DetourSearch::lattice);
  /// The same forwards with another radius in another region, which has these walls. They must outlive it, too.
  CarSpace(const Problem& problem, const EdgeIndex& walls, const Box& bounds, double radius);

  double radius() const { return radius_; }
  bool reverse() const { return reverse_; }
  double chord_error() const { return chord_error_; }
  /// Metres of an arc of that radius that are driven as one chord.
  double chord() const { return chord_; }
  /// Of configuration space.
  const Box& bounds() const { return bounds_; }
  bool free(const Curve& curve) const;
  bool free(const Pose& from, const CurvePiece& piece) const;
  bool free(const Polyline& line) const;
  /// The shortest curve if there were no obstacles: Dubins', in reverse Reeds and Shepp's.
  Curve shortest(const Pose& from, const Pose& to) const;
  /// Its length.
  double least_length(const Pose& from, const Pose& to) const;
  /// Of a robot that turns on the spot; empty if not known.
  Polyline shortest_path(const Point& from, const Point& to) const;
  const EdgeIndex& walls() const { return walls_; }
  /// The length of a curve, and for each cusp the metres lost by stopping.
  double cost(const Curve& curve) const { return cost(curve.length(), curve.cusps()); }
  double cost(double metres, std::size_t cusps) const { return metres + stop_cost_ * static_cast<double>(cusps); }

  /// Steps 1 and 2. nullopt: none of them is free that costs less than `most` (as cost() counts).
  std::optional<Curve> simple_link(const Pose& from, const Pose& to,
                                   double most = std::numeric_limits<double>::infinity()) const;
  /// Step 3: from the pose from which it is cheapest.
  std::optional<Curve> detour(const std::vector<Pose>& from, const Pose& to, DetourEffort& effort,
                              const Context& context) const;
  /// The robot can go on from there for so many metres: by quarter circles and straight lines as long, or backwards.
  bool can_go_on(const Pose& from, double metres) const;

 private:
  const Problem* problem_ = nullptr;  // of which it is the space; nullptr: of another region
  const EdgeIndex& walls_;
  Box bounds_;
  DetourSearch search_;
  double radius_, chord_error_, chord_;
  double tolerance_;  // laps along the boundary are off it by rounding
  double stop_cost_;
  bool reverse_;
};

}  // namespace oxturn

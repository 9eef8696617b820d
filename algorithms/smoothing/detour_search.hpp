/// A drivable path around obstacles, from any of some poses to another one: two searches.
///
///   DetourEffort effort;                                                  // one for all searches of a plan
///   const auto detour = lattice_search(space, {from}, to, effort, context);   // nullopt: none was found
///
/// lattice_search: hybrid A* over position and heading
///   Source      Dolgov, Thrun, Montemerlo and Diebel, Path Planning for Autonomous Vehicles in Unknown Semi-structured
///               Environments, IJRR 29(5), 2010
///   Method      Steps of 1.5 cells, steering left, straight or right (in both gears if the robot has them), from exact
///               poses; of those in one cell of a quarter radius and five degrees the cheapest is kept. Heuristic: the
///               shortest curve without obstacles, which is also tried as the rest of the path, or, if that is longer,
///               the shortest path of a robot that turns on the spot (route.hpp).
///   Complexity  at most 20000 poses, each with a few curves: up to 0.2 s
///
/// ompl_search: trees of random poses, by OMPL
///   Source      LaValle, Rapidly-exploring random trees, 1998 (forward only); Kuffner and LaValle, RRT-Connect, ICRA
///               2000 (reverse), as in OMPL (Sucan, Moll and Kavraki 2012)
///   Method      States are poses, motions the shortest Dubins curves (in reverse Reeds-Shepp curves), tested exactly.
///               The path found is shortened: of the poses along it, one radius apart, those of the shortest sequence
///               of free curves are kept.
///   Guarantee   The same problem, seed and poses give the same path: poses are drawn by a generator of ours, and the
///               search ends after a number of curves, not of seconds.
///   Complexity  n poses take n^2 curves, because each is compared with all before; the search ends after as many
///               curves as take the time of 20000 poses of lattice_search. Longer than paths of lattice_search in open
///               space, but not limited to steps of a lattice
///
/// Where no path exists, or none is found, a search takes all that it may. So that a map with many such links does not
/// take minutes, searches share an effort: each takes as much as it needs, up to the figures above, until
/// it is spent (some 5 s, and 10 ms more for each stroke), and then a twentieth of them at most.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/curve.hpp"

namespace oxturn {

class CarSpace;

/// What the searches of one plan may still cost, in poses of lattice_search forwards. Deterministic.
class DetourEffort {
 public:
  static constexpr std::size_t kAll = 1'000'000, kEach = 2000;  // in all, and more for each stroke
  static constexpr std::size_t kMost = 20'000, kLeast = 1000;   // of one search
  explicit DetourEffort(std::size_t strokes = 0) : left_(kAll + kEach * strokes) {}
  /// Of the next search.
  std::size_t most() const { return std::clamp(left_, kLeast, kMost); }
  bool exhausted() const { return left_ < kMost; }
  void spend(std::size_t poses) { left_ -= std::min(poses, left_); }

 private:
  std::size_t left_;
};

std::optional<Curve> lattice_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                    DetourEffort& effort, const Context& context);
std::optional<Curve> ompl_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                 DetourEffort& effort, const Context& context);

struct ThoroughDetour {
  std::optional<Curve> curve;
  bool nothing_left = false;  // no curve, and all poses that can be reached were looked at
  std::size_t poses = 0;
};
/// lattice_search() from both ends by turns, until every pose was looked at that can be reached from one of them: where
/// one end is shut in that takes few. `most` poses for each end.
ThoroughDetour thorough_search(const CarSpace& space, const Pose& from, const Pose& to, std::size_t most,
                               const Context& context);

}  // namespace oxturn

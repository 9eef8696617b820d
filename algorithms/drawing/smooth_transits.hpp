/// Transits for a robot with a least turning radius: curves from pose to pose, round what is drawn where they can.
///
///   SmoothTransits smooth(problem, work, radius, keep_off);
///   const SmoothTransit t = smooth.find(exit, entry, round);       // round: the shortest path without a radius
///
/// The first of these that stays in configuration space and
///   1. is clear of finished work by `keep_off`: one smooth connection (smoothing/connection.hpp: spiro curves first)
///   2. is clear of finished work itself: the same; then connections through the bends of `round`
///   3. crosses the least of it, counted as by the router: Dubins' curves between poses further ahead on the strokes'
///      lines (smoothing/car_space.hpp); for so many transits only, then the first smooth connection that stays inside
///   4. as 3, found by a lattice search, if the robot cannot turn on the spot; with the effort of one plan for all
/// If there is none, `round` itself with its bends, which are reported.
/// Source: Vollprecht 2014, section 2.4. Cost: some dozen curves of up to a millisecond.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "algorithms/drawing/finished_work.hpp"
#include "algorithms/smoothing/connection.hpp"
#include "algorithms/smoothing/detour_search.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct SmoothTransit {
  Polyline path;
  bool keeps_radius = true;
};

class SmoothTransits {
 public:
  struct Options {
    double radius = 1;    // metres, > 0
    double keep_off = 0;  // metres from finished work, where possible
    ConnectionKind first = ConnectionKind::spiro;
    bool avoid = true;     // finished work; false: 3 and 4 only, by the first connection
    bool literal = false;  // the source's spiro curve, whatever its curvature and wherever it leads
  };
  /// References must outlive it.
  SmoothTransits(const Problem& problem, const FinishedWork& work, const Options& options);

  /// A metre over finished work costs as much as this many others.
  static constexpr double kCrossingWeight = 100;

  double radius() const { return options_.radius; }
  SmoothTransit find(const Pose& from, const Pose& to, const Polyline& round) const;
  /// From a point, with the best of some headings.
  SmoothTransit find(const Point& from, const Pose& to, const Polyline& round) const;

 private:
  /// What a curve must keep clear of.
  enum class Clear { near_work, work, walls };
  bool allowed(const SmoothCurve& curve, Clear clear) const;
  bool stays_inside(const Polyline& path) const;
  bool bends_too_sharply(const Polyline& path) const;
  std::optional<Polyline> one(const Pose& from, const Pose& to, Clear clear) const;
  std::optional<Polyline> least_crossing(const Pose& from, const Pose& to) const;
  std::optional<Polyline> along(const Pose& from, const Pose& to, const Polyline& round) const;
  std::optional<Polyline> by_lattice(const Pose& from, const Pose& to) const;

  using Key = std::array<double, 6>;

  const Problem& problem_;
  const FinishedWork& work_;
  Options options_;
  double chord_error_;
  // Whatever is finished, what lattice searches find between two poses is the same.
  mutable std::map<Key, std::optional<Polyline>> by_lattice_;
  mutable DetourEffort effort_;
  mutable std::size_t links_ = 0;  // sought by least_crossing()
};

}  // namespace oxturn

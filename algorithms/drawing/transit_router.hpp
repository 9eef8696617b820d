/// Transits that go round what is drawn already.
///
///   TransitRouter router(problem, work, keep_off, nullptr);
///   const Transit t = router.route(exit, entry);       // path, and metres of it over finished work
///
/// The straight line if it is clear; else the shortest path round the finished pieces that it crosses, then round those
/// that this one crosses, and so on (a path that is shortest round some of the obstacles and clear of all is shortest
/// round all). The robot's centre keeps `keep_off` from what is drawn; where that leaves no path, only off the drawn
/// lines themselves; where there is still none, the path with the least driving over them (weighted_search.hpp). With
/// smooth transits the path is replaced by a curve (smooth_transits.hpp). Paths are remembered as long as they are
/// valid; so are the pieces that leave none, as long as they are finished.
/// Shortest paths are found only as long as an effort lasts, enough for some thousand of them in drawings of usual
/// density; then the last resort is the only one.
/// Source: the outlook of Vollprecht 2014 (figure 5.1). Cost: a triangulation of the obstacles that are in the way.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "algorithms/drawing/smooth_transits.hpp"
#include "algorithms/drawing/weighted_search.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

struct Transit {
  Polyline path;
  double length_m = 0, crossing_m = 0;
  bool keeps_radius = true;
  static constexpr double kCrossingWeight = SmoothTransits::kCrossingWeight;
  double price() const { return length_m + kCrossingWeight * crossing_m; }
};

class TransitRouter {
 public:
  /// References must outlive it. `smooth`: nullptr for paths with bends.
  TransitRouter(const Problem& problem, const FinishedWork& work, double keep_off, const SmoothTransits* smooth);

  Transit route(const Pose& from, const Pose& to);
  /// From where the robot stands with any heading.
  Transit route(const Point& from, const Pose& to);
  /// Whatever is drawn: by the shortest path in configuration space.
  Transit direct(const Pose& from, const Pose& to) const;
  Transit direct(const Point& from, const Pose& to) const;

  /// No more shortest paths are found: time to end a search.
  bool exhausted() const { return effort_ >= kMostEffort; }

  const FinishedWork& work() const { return work_; }
  const Problem& problem() const { return problem_; }
  /// Of smooth transits; 0: they may have bends.
  double radius() const { return smooth_ == nullptr ? 0 : smooth_->radius(); }

 private:
  using Key = std::array<double, 6>;  // positions and headings; none: kAnyHeading
  struct Known {
    std::vector<std::size_t> round;  // pieces that the path goes round
    double keep_off = 0;             // it keeps so far from all others
    Transit transit;
    bool for_this_work = false;       // good only for the same finished work
    std::uint64_t fingerprint = 0;    // of that
    std::vector<bool> finished = {};  // by piece; it stays the best while more is finished, but for what it drives over
  };
  static constexpr double kAnyHeading = 1e9;
  /// Vertices of obstacles; each costs some ten microseconds. Cells of a search count as a quarter.
  static constexpr std::size_t kMostEffort = 1'500'000, kCellsToVertex = 4;
  Transit route(const Pose& from, bool any_heading, const Pose& to);
  Known with_bends(const Point& from, const Point& to);
  void smoothen(Known& known, const Pose& from, bool any_heading, const Pose& to) const;
  Region free_region(const std::vector<std::size_t>& pieces, const Point& from, const Point& to, double keep_off);
  std::optional<Known> lazy(const Point& from, const Point& to, double keep_off);
  bool valid(const Known& known) const;
  bool all_finished(const std::vector<std::size_t>& pieces) const;
  bool is_clear(const Known& known) const;
  const Region& sweep(std::size_t piece, bool grown);
  Transit measured(Polyline path, bool keeps_radius = true) const;

  const Problem& problem_;
  const FinishedWork& work_;
  double keep_off_;
  const SmoothTransits* smooth_;
  Connector connector_;
  std::map<Key, Known> known_;
  std::map<std::array<double, 5>, std::vector<std::size_t>> enclosing_;  // by ends and keep_off: no path round these
  std::map<std::pair<std::size_t, bool>, Region> sweeps_;
  std::optional<WeightedSearch> weighted_;  // made when it is needed
  std::size_t effort_ = 0;
};

}  // namespace oxturn

/// Transits that go round what is drawn already.
///
///   TransitRouter router(problem, work, keep_off);
///   const Transit t = router.route(exit, entry);       // path, and metres of it over finished work
///
/// The straight line if it is clear; else the shortest path round the finished pieces that it crosses, then round those
/// that this one crosses, and so on (a path that is shortest round some of the obstacles and clear of all is shortest
/// round all). The robot's centre keeps `keep_off` from what is drawn; where that leaves no path, only off the drawn
/// lines themselves; where there is still none, the path with the least driving over them (weighted_search.hpp). Paths
/// are remembered as long as they are valid.
/// Source: the outlook of Vollprecht 2014 (figure 5.1). Cost: a triangulation of the obstacles that are in the way.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "algorithms/drawing/finished_work.hpp"
#include "algorithms/drawing/weighted_search.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

struct Transit {
  Polyline path;
  double length_m = 0, crossing_m = 0;
  /// A metre over finished work costs as much as this many others.
  static constexpr double kCrossingWeight = 100;
  double price() const { return length_m + kCrossingWeight * crossing_m; }
};

class TransitRouter {
 public:
  /// References must outlive it.
  TransitRouter(const Problem& problem, const FinishedWork& work, double keep_off);

  Transit route(const Point& from, const Point& to);
  /// The shortest path in configuration space, whatever is drawn.
  Transit direct(const Point& from, const Point& to) const;
  /// Where the robot may drive, but for the pieces, grown by `keep_off` but at the ends of a transit.
  Region free_region(const std::vector<std::size_t>& pieces, const Point& from, const Point& to, double keep_off);

  const FinishedWork& work() const { return work_; }
  const Problem& problem() const { return problem_; }
  double keep_off() const { return keep_off_; }

 private:
  using Key = std::tuple<double, double, double, double>;
  struct Known {
    std::vector<std::size_t> round;  // pieces that the path goes round
    double keep_off;
    Transit transit;
    std::uint64_t fingerprint;  // of the finished work, where the path crosses it
  };
  std::optional<Known> lazy(const Point& from, const Point& to, double keep_off);
  bool valid(const Known& known) const;
  bool is_clear(const Known& known) const;
  const Region& sweep(std::size_t piece, bool grown);
  Transit measured(Polyline path) const;

  const Problem& problem_;
  const FinishedWork& work_;
  double keep_off_;
  Connector connector_;
  std::map<Key, Known> known_;
  std::map<std::pair<std::size_t, bool>, Region> sweeps_;
  std::optional<WeightedSearch> weighted_;  // made when it is needed
};

}  // namespace oxturn

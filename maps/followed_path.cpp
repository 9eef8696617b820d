#include "maps/followed_path.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

#include "geometry/paths/shortest_path.hpp"
#include "geometry/point_outside.hpp"

namespace oxturn {

TautTether tether_at_start(const Problem& problem) {
  TautTether tether(problem.tether()->taut_space(), problem.anchor());
  if (problem.anchor() == problem.start()) return tether;
  const Polyline geodesic = problem.tether()->geodesics().path(problem.start());
  if (geodesic.empty()) throw std::logic_error("a tethered problem whose anchor has no path to its start");
  for (std::size_t i = 1; i + 1 < geodesic.size(); ++i) tether.drive(geodesic[i]);
  tether.drive(problem.start());
  return tether;
}

namespace {

constexpr double kDetour = 10;  // tolerances by which a corner that is cut off may lengthen the path

/// Follows a path from point to point.
class Follower {
 public:
  Follower(const Problem& problem, const EdgeIndex& walls, double tolerance)
      : problem_(problem), walls_(walls), tolerance_(tolerance), last_(problem.start()) {}

  /// False if the path cannot be followed to this point. `joint`: the first of a leg.
  bool follow(const Point& to, bool joint, Gear gear) {
    if (!finite(to)) return false;
    gear_ = gear;
    if (joint ? distance(last_, to) > tolerance_ : point_outside(walls_, last_, to, tolerance_).has_value())
      return false;
    last_ = to;
    return tolerance_ > problem_.tolerance() ? append_inside(to) : append(to);
  }
  FollowedPath take(bool whole) { return {std::move(points_), std::move(gears_), whole}; }

 private:
  bool append(const Point& to) {
    if (to == points_.back()) return true;
    points_.push_back(to);
    gears_.push_back(gear_);
    return true;
  }

  /// A tether needs free space: points in walls are moved to the boundary, and corners that are cut off passed outside.
  bool append_inside(Point to) {
    const double rounding = problem_.tolerance();
    if (!nearly_contains(walls_, to, rounding)) to = walls_.nearest(to)->point;
    const Point from = points_.back();
    if (to == from || !point_outside(walls_, from, to, rounding)) return append(to);
    if (!paths_) paths_.emplace(problem_.map().free, rounding);
    const auto detour = paths_->path(from, to, distance(from, to) + kDetour * tolerance_);
    if (!detour) return false;
    for (const Point& p : *detour) append(p);
    return true;
  }

  const Problem& problem_;
  const EdgeIndex& walls_;
  double tolerance_;
  Point last_;  // of the path as given
  Polyline points_{last_};
  std::vector<Gear> gears_;
  Gear gear_ = Gear::forward;
  std::optional<ShortestPaths> paths_;
};

}  // namespace

Path FollowedPath::path() const {
  PathBuilder builder(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) builder.drive(points[i], true, gears[i - 1]);
  return builder.take();
}

FollowedPath followed_path(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance) {
  Follower follower(problem, walls, tolerance);
  for (const Leg& leg : path.legs)
    for (std::size_t i = 0; i < leg.points.size(); ++i)
      if (!follower.follow(leg.points[i], i == 0, leg.gear)) return follower.take(false);
  return follower.take(true);
}

}  // namespace oxturn

#include "maps/followed_path.hpp"

#include <stdexcept>

#include "geometry/point_outside.hpp"

namespace oxturn {

TautTether tether_at_start(const Problem& problem) {
  TautTether string(problem.tether()->taut_space(), problem.anchor());
  if (problem.anchor() == problem.start()) return string;
  const Polyline geodesic = problem.tether()->geodesics().path(problem.start());
  if (geodesic.empty()) throw std::logic_error("a tethered problem whose anchor has no way to its start");
  for (std::size_t i = 1; i + 1 < geodesic.size(); ++i) string.drive(geodesic[i]);
  string.drive(problem.start());
  return string;
}

FollowedPath followed_path(const Problem& problem, const Path& path, const EdgeIndex& walls) {
  const double tolerance = problem.tolerance();
  FollowedPath way{{problem.start()}, true};
  for (const Leg& leg : path.legs) {
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      const Point &from = way.points.back(), &to = leg.points[i];
      const bool follows =
          finite(to) && (i == 0 ? distance(from, to) <= tolerance : !point_outside(walls, from, to, tolerance));
      if (!follows) {
        way.whole = false;
        return way;
      }
      if (to != from) way.points.push_back(to);
    }
  }
  return way;
}

}  // namespace oxturn

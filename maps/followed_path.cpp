#include "maps/followed_path.hpp"

#include <stdexcept>

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

FollowedPath followed_path(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance) {
  FollowedPath followed{{problem.start()}, true};
  for (const Leg& leg : path.legs) {
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      const Point &from = followed.points.back(), &to = leg.points[i];
      const bool follows =
          finite(to) && (i == 0 ? distance(from, to) <= tolerance : !point_outside(walls, from, to, tolerance));
      if (!follows) {
        followed.whole = false;
        return followed;
      }
      if (to != from) followed.points.push_back(to);
    }
  }
  return followed;
}

}  // namespace oxturn

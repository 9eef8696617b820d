#include "geometry/convex_hull.hpp"

#include <algorithm>

#include "base/sorting.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {

Ring convex_hull(std::vector<Point> points) {
  sort_unique(points, before);
  if (points.size() < 2) return points;
  Ring hull;
  for (int half = 0; half < 2; ++half) {  // the lower chain from left to right, then the upper one back
    const std::size_t first = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= first + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the next chain begins with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace oxturn

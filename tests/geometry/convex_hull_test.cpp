#include "geometry/convex_hull.hpp"

#include <gmock/gmock.h>

#include "base/random.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using testing::ElementsAre;

TEST(ConvexHull, DropsInnerRepeatedAndCollinearPoints) {
  EXPECT_THAT(convex_hull({{2, 2}, {0, 0}, {1, 1}, {2, 0}, {1, 0}, {0, 2}, {0, 0}, {2, 1}}),
              ElementsAre(Point(0, 0), Point(2, 0), Point(2, 2), Point(0, 2)));
}

TEST(ConvexHull, OfFewerThanThreeDirections) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_THAT(convex_hull({{1, 2}, {1, 2}}), ElementsAre(Point(1, 2)));
  EXPECT_THAT(convex_hull({{1, 1}, {3, 3}, {2, 2}}), ElementsAre(Point(1, 1), Point(3, 3)));
}

// Oracle: an edge of the hull is a pair of points with all others on its left or between the two.
TEST(ConvexHull, EdgesAreThosePairsThatHaveAllPointsOnTheirLeft) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<Point> points;
    for (int k = rng.between(3, 30); k > 0; --k)  // on a small lattice: ties and collinear points
      points.push_back(Point(rng.between(0, 6), rng.between(0, 6)) * 0.1);
    const Ring hull = convex_hull(points);
    if (hull.size() < 3) continue;
    const auto bounds = [&](const Point& a, const Point& b) {
      for (const Point& p : points)
        if (orientation(a, b, p) < 0 || (orientation(a, b, p) == 0 && !on_segment(p, a, b))) return false;
      return true;
    };
    std::size_t edges = 0;
    for (const Point& a : points)
      for (const Point& b : points) {
        if (a == b || !bounds(a, b)) continue;
        bool found = false;
        for (std::size_t i = 0; i < hull.size(); ++i)
          found = found || (hull[i] == a && hull[(i + 1) % hull.size()] == b);
        EXPECT_TRUE(found);
        edges += found ? 1 : 0;
      }
    EXPECT_GE(edges, hull.size());  // repeated points repeat their edges
  }
}

}  // namespace
}  // namespace oxturn

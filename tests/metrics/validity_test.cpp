// Every rule has a path that breaks it, and a sentence that says which, where and by how much.
#include <gmock/gmock.h>

#include <limits>

#include "metrics/score.hpp"
#include "shapes.hpp"

namespace oxturn {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Problem hall() { return problem_in(two_holes(), {1, 1}); }

TEST(Validity, GoodPaths) {
  const Problem p = hall();
  EXPECT_EQ(find_flaw(p, work({{1, 1}, {9, 1}, {9, 7}})), "");
  EXPECT_EQ(find_flaw(p, Path{{Leg{false, {{1, 1}, {1, 1}}}, Leg{true, {{1, 1}, {1, 7}}}}}), "");
  EXPECT_EQ(find_flaw(p, work({{1, 1}, {0.2, 0.2}, {9.8, 0.2}})), "") << "along the wall, radius away";
  EXPECT_EQ(find_flaw(p, work({{1, 1}, {1, 0.2 - 1e-8}})), "") << "rounding is no sin";
}

TEST(Validity, Shape) {
  const Problem p = hall();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(find_flaw(p, Path{}), "path has no legs");
  EXPECT_EQ(find_flaw(p, work({})), "leg 1 has 0 points, expected at least 2");
  EXPECT_EQ(find_flaw(p, work({{1, 1}})), "leg 1 has 1 point, expected at least 2");
  EXPECT_EQ(find_flaw(p, work({{1, 1}, {2, nan}})), "leg 1 point 2 is not finite");
  EXPECT_EQ(find_flaw(p, Path{{Leg{true, {{1, 1}, {2, 1}}}, Leg{true, {{2, 1}, {3, 1}, {inf, 1}}}}}),
            "leg 2 point 3 is not finite");
  EXPECT_EQ(find_flaw(p, work({{1, 1.5}, {2, 1}})), "starts at (1, 1.5), the problem's start is (1, 1)");
  EXPECT_EQ(find_flaw(p, Path{{Leg{true, {{1, 1}, {2, 1}}}, Leg{false, {{2, 1.5}, {3, 1}}}}}),
            "leg 2 starts at (2, 1.5), 0.5 m from where leg 1 ended");
}

TEST(Validity, Walls) {
  const Problem p = hall();
  EXPECT_EQ(find_flaw(p, work({{1, 1}, {3, 1.87}, {5, 1}})),
            "leaves configuration space at (3, 1.87): 0.13 m from a wall, robot radius 0.2 m");
  EXPECT_THAT(find_flaw(p, work({{1, 1}, {3, 1}, {3, 5}})),
              AllOf(StartsWith("leaves configuration space at (3, 2)"), HasSubstr("in a wall")));
  EXPECT_THAT(find_flaw(p, work({{1, 1}, {1e6, 1}})), StartsWith("leaves configuration space"));
  EXPECT_THAT(find_flaw(p, work({{1, 1}, {1e300, 1e300}})), StartsWith("leaves configuration space"));
}

TEST(Validity, ThinWallBetweenTwoGoodPoints) {
  // 1 mm of wall: both ends are free, the path is not; with a disc and with a robot without size.
  Region r = box_region({0, 0}, {4, 4});
  r.polygons[0].holes.push_back({{2, 1}, {2, 3}, {2.001, 3}, {2.001, 1}});
  for (const double radius : {0.0, 0.2}) {
    const Problem p = problem_in(r, {1, 2}, radius, 0.4);
    EXPECT_THAT(find_flaw(p, work({{1, 2}, {3, 2}})), StartsWith("leaves configuration space at (2")) << radius;
    EXPECT_EQ(find_flaw(p, work({{1, 2}, {1, 3.5}, {3, 3.5}, {3, 2}})), "") << radius;
  }
}

TEST(Validity, NoSizeMayRunAlongWalls) {
  const Region r = transformed(two_holes(), 0.3, {0, 0});
  const auto at = [](double x, double y) { return rotated({x, y}, 0.3); };
  const Problem p = problem_in(r, at(1, 1), 0, 0.4);
  EXPECT_EQ(find_flaw(p, work({at(1, 1), at(0, 1), at(0, 8), at(10, 8), at(10, 0), at(2, 0)})), "");
  EXPECT_EQ(find_flaw(p, work({at(1, 1), at(2, 2), at(2, 4), at(4, 4), at(4, 2), at(2, 2)})), "");
  EXPECT_THAT(find_flaw(p, work({at(1, 1), at(2, 2), at(4, 4)})), HasSubstr("inside a wall"));
  EXPECT_THAT(find_flaw(p, work({at(1, 1), at(-0.01, 1)})), HasSubstr("0.01 m inside a wall"));
}

double clearance_of(const Problem& p, const Path& path) { return score(p, path).value("clearance_m").value(); }

TEST(Clearance, DistanceToWallsLessRadius) {
  const Problem p = hall();
  EXPECT_NEAR(clearance_of(p, work({{1, 1}, {5, 1}})), 0.8, 1e-12);
  EXPECT_NEAR(clearance_of(p, work({{1, 1}, {1, 3}, {1.5, 3}, {1, 3}})), 0.3, 1e-12);
  EXPECT_NEAR(clearance_of(p, work({{1, 1}, {0.1, 1}})), -0.1, 1e-12);
  EXPECT_NEAR(clearance_of(p, work({{1, 1}, {-0.5, 1}})), -0.7, 1e-12);
  EXPECT_NEAR(clearance_of(p, work({{-3, 1}, {-2, 1}})), -3.2, 1e-12) << "all of it outside";
}

// Oracle: many points on the path against every edge.
TEST(Clearance, AsByScanningEveryEdge) {
  Rng rng(11);
  for (int k = 0; k < 40; ++k) {
    Path path = random_walk(rng, Box{{0.5, 0.5}, {1.5, 7.5}}, 1, 6, 1.0);
    double least = 1e9;
    for (std::size_t i = 1; i < path.legs[0].points.size(); ++i)
      for (int t = 0; t <= 200; ++t) {
        const Point x = lerp(path.legs[0].points[i - 1], path.legs[0].points[i], t / 200.0);
        for_each_ring(two_holes(), [&](const Ring& ring) {
          for (std::size_t e = 0; e < ring.size(); ++e)
            least = std::min(least, distance_to_segment(x, ring[e], ring[(e + 1) % ring.size()]));
        });
      }
    EXPECT_NEAR(clearance_of(hall(), path), least - 0.2, 0.003);
  }
}

}  // namespace
}  // namespace oxturn

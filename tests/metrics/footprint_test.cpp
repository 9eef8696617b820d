// Polygonal footprints against the map's walls: where, by how much, and nothing borrowed from the erosion.
#include <gmock/gmock.h>

#include "base/random.hpp"
#include "metrics/score.hpp"
#include "shapes.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;

Problem with(const Region& free, Ring footprint, const Point& start) {
  Robot robot;
  robot.footprint = std::move(footprint);
  return Problem(Map{"drawn", free, "test", "test"}, robot, start);
}
const Ring kDiamond{{0.5, 0}, {0, 0.5}, {-0.5, 0}, {0, -0.5}};
const Ring kPlank{{0.75, -0.25}, {0.75, 0.25}, {-0.5, 0.25}, {-0.5, -0.25}};

TEST(FootprintValidity, AlongTheWallsToTheLastMicron) {
  const Problem p = with(box_region({0, 0}, {10, 8}), kPlank, {5, 4});
  EXPECT_EQ(find_flaw(p, work({{5, 4}, {0.5, 0.25}, {9.25, 0.25}, {9.25, 7.75}, {0.5, 7.75}})), "");
  EXPECT_EQ(find_flaw(p, work({{5, 4}, {0.5 - 1e-8, 4}})), "") << "rounding is no sin";
  EXPECT_THAT(find_flaw(p, work({{5, 4}, {9.3, 4}})), HasSubstr("leaves configuration space at (9.25, 4)"));
  EXPECT_THAT(find_flaw(p, work({{5, 4}, {0.4, 4}})), HasSubstr("leaves configuration space at (0.49999"));
  EXPECT_THAT(find_flaw(p, work({{5, 4}, {5, 7.8}})), HasSubstr("0.05 m into a wall"));
  EXPECT_THAT(find_flaw(p, work({{5, 4}, {20, 4}})), HasSubstr("(9.25, 4)"));
}

TEST(FootprintValidity, ADiamondPassesWhereItsBoxWouldNot) {
  Region free = box_region({0, 0}, {10, 10});
  free.polygons[0].holes.push_back({{4, 0.5}, {4, 4}, {6, 4}, {6, 0.5}});
  const Problem p = with(free, kDiamond, {2, 2});
  // Past the obstacle's corner (4, 4), along the diamond's own slope: touching, then a little too near.
  const double near = 4 - 0.25;
  EXPECT_EQ(find_flaw(p, work({{2, 2}, {near - 1, near + 1}, {near, near + 0.5}, {near + 1, near + 1.5}})), "");
  EXPECT_THAT(find_flaw(p, work({{2, 2}, {near - 1, near + 1}, {near + 0.05, near + 0.45}, {near + 1, near + 1.5}})),
              HasSubstr("leaves configuration space"));
  // An obstacle wholly inside what is swept, between two points that are both free.
  Region pin = box_region({0, 0}, {10, 10});
  pin.polygons[0].holes.push_back({{5, 5}, {5, 5.01}, {5.01, 5.01}, {5.01, 5}});
  const Problem q = with(pin, kDiamond, {2, 5});
  EXPECT_THAT(find_flaw(q, work({{2, 5}, {8, 5}})), HasSubstr("(4.5, 5)"));
  EXPECT_EQ(find_flaw(q, work({{2, 5}, {2, 5.6}, {8, 5.6}})), "");
}

double clearance_of(const Problem& p, const Path& path) { return *score(p, path).value("clearance_m"); }

TEST(FootprintClearance, ByTheBook) {
  Region free = box_region({0, 0}, {10, 10});
  const Problem p = with(free, kPlank, {5, 5});
  EXPECT_NEAR(clearance_of(p, work({{5, 5}, {5, 6}})), 10 - 6 - 0.25, 1e-12);
  EXPECT_NEAR(clearance_of(p, work({{5, 5}, {8, 5}})), 10 - 8 - 0.75, 1e-12);
  EXPECT_NEAR(clearance_of(p, work({{5, 5}, {9.25, 5}})), 0, 1e-12);
  EXPECT_NEAR(clearance_of(p, work({{5, 5}, {5, 9.8}})), -0.05, 1e-9);
  EXPECT_LT(clearance_of(p, work({{5, 5}, {5, 12}})), -2);
  free.polygons[0].holes.push_back({{7, 7}, {7, 8}, {8, 8}, {8, 7}});
  const Problem q = with(free, kPlank, {5, 5});
  // From the plank's upper right corner (5.75, 5.25) to (7, 7).
  EXPECT_NEAR(clearance_of(q, work({{5, 5}, {4, 5}})), std::hypot(1.25, 1.75), 1e-12);
}

// A polygon of many corners is judged as the disc is.
TEST(FootprintClearance, ARoundPolygonIsADisc) {
  Ring round;
  for (int k = 0; k < 96; ++k) round.push_back(rotated({0.2, 0}, 2 * kPi * k / 96));
  const Problem disc = problem_in(two_holes(), {1, 1}), polygon = with(two_holes(), round, {1, 1});
  const double coarse = 0.2 * (1 - std::cos(kPi / 96));
  int valid = 0;
  for (const std::uint64_t seed : seeds(100)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Path path = random_walk(rng, {{0.2, 0.2}, {9.8, 7.8}}, 1, 3, 1.5);
    path.legs[0].points.insert(path.legs[0].points.begin(), Point(1, 1));
    const double a = clearance_of(disc, path), b = clearance_of(polygon, path);
    if (a > 0) {
      EXPECT_GE(b, a - 1e-9);  // it lies inside the disc
      EXPECT_LE(b, a + coarse + 1e-9);
    }
    if (std::abs(a) < 2 * coarse) continue;
    EXPECT_EQ(find_flaw(disc, path).empty(), find_flaw(polygon, path).empty());
    valid += find_flaw(disc, path).empty() ? 1 : 0;
  }
  EXPECT_GT(valid, 2);
}

}  // namespace
}  // namespace oxturn

#include "geometry/region.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

TEST(Region, AreaAndLengthOfADrawnShape) {
  Region r = box_region({0, 0}, {4, 3});
  r.polygons[0].holes.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  EXPECT_EQ(area(r), 11);
  EXPECT_EQ(perimeter(r), 18);
  EXPECT_EQ(vertex_count(r), 8u);
  EXPECT_EQ(hole_count(r), 1u);
  EXPECT_EQ(signed_area(r.polygons[0].holes[0]), -1);
  EXPECT_TRUE(bounding_box(Region{}).empty());
  EXPECT_EQ(area(Region{}), 0);
}

TEST(Region, AreaSurvivesFarOrigins) {
  const Region r = transformed(box_region({0, 0}, {1, 1}), 0, {1048576, -4194304});
  EXPECT_EQ(area(r), 1);
}

TEST(Region, TurningAndShiftingKeepsAreaAndMovesPoints) {
  Rng rng(5);
  const Region r = samples::holed_star(rng, {1, 2}, 3);
  const Region t = transformed(r, 0.7, {5, -1});
  EXPECT_NEAR(area(t), area(r), 1e-12);
  EXPECT_NEAR(perimeter(t), perimeter(r), 1e-12);
  const Region back = transformed(transformed(r, 0.7, {0, 0}), -0.7, {0, 0});
  EXPECT_LT(distance(back.polygons[0].outer[1], r.polygons[0].outer[1]), 1e-14);
}

TEST(Region, ContainsAgreesWithSumOfAngles) {
  Rng rng(11);
  for (int k = 0; k < 20; ++k) {
    const Region r = samples::holed_star(rng, {rng.between(-3.0, 3.0), 1}, 2);
    for (int i = 0; i < 200; ++i) {
      const Point p{rng.between(-6.0, 6.0), rng.between(-2.0, 4.0)};
      if (samples::distance_to_boundary(r, p) < 1e-9) continue;
      EXPECT_EQ(contains(r, p), samples::sees_all_round(r, p)) << p.transpose();
    }
  }
}

TEST(Region, ContainsIsRightAtTheHeightOfCorners) {
  const Region diamond{{Polygon{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, {}}}};
  EXPECT_TRUE(contains(diamond, {0, 0}));
  EXPECT_TRUE(contains(diamond, {-0.5, 0}));
  EXPECT_FALSE(contains(diamond, {-2, 0}));
  EXPECT_FALSE(contains(diamond, {2, 0}));
  EXPECT_FALSE(contains(diamond, {-2, 1}));
  EXPECT_FALSE(contains(diamond, {-2, -1}));
}

}  // namespace
}  // namespace oxturn

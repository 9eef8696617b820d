#include "geometry/path.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace oxturn {
namespace {

TEST(PathBuilder, MergesNeighboursOfAKindAndDropsRepeats) {
  PathBuilder b({0, 0});
  b.drive(Polyline{{0, 0}, {1, 0}, {1, 0}, {2, 0}}, true);
  b.drive({2, 3}, true);
  b.drive({2, 3}, false);  // goes nowhere: no leg
  b.drive({2, 4}, false);
  b.drive({5, 8}, true);
  EXPECT_EQ(b.at(), Point(5, 8));
  const Path p = b.take();
  ASSERT_EQ(p.legs.size(), 3u);
  EXPECT_EQ(p.legs[0].points, (Polyline{{0, 0}, {1, 0}, {2, 0}, {2, 3}}));
  EXPECT_EQ(p.legs[1].points, (Polyline{{2, 3}, {2, 4}}));
  EXPECT_FALSE(p.legs[1].tool);
  EXPECT_EQ(p.length(), 11);
  EXPECT_EQ(p.length(true), 10);
  EXPECT_EQ(p.length(false), 1);
}

// Two pieces of a path that meet in a point computed in two ways.
TEST(PathBuilder, PointsThatDifferByRoundingAreRepeats) {
  const Point end(0.1 + 0.2, 7), same(0.3, 7);
  ASSERT_NE(end, same);
  PathBuilder b({0, 7});
  b.drive(Polyline{{0, 7}, end}, true);
  b.drive(Polyline{same, {1, 7}}, true);
  b.drive(Polyline{{1, 7}, {1, std::nextafter(7, 8)}, {1, 8}}, false);
  b.drive({1, 8 + 1e-9}, false);  // short, but no rounding
  const Path p = b.take();
  ASSERT_EQ(p.legs.size(), 2u);
  EXPECT_EQ(p.legs[0].points, (Polyline{{0, 7}, end, {1, 7}}));
  EXPECT_EQ(p.legs[1].points, (Polyline{{1, 7}, {1, 8}, {1, 8 + 1e-9}}));
}

TEST(PathBuilder, AChangeOfGearBeginsALeg) {
  PathBuilder builder({0, 0});
  builder.drive({1, 0}, true);
  builder.drive({0, 0}, true, Gear::reverse);
  builder.drive(Polyline{{0, 0}, {-1, 0}}, true, Gear::reverse);
  const Path path = builder.take();
  ASSERT_EQ(path.legs.size(), 2u);
  EXPECT_EQ(path.legs[0].gear, Gear::forward);
  EXPECT_EQ(path.legs[1].gear, Gear::reverse);
  EXPECT_EQ(path.legs[1].points, (Polyline{{1, 0}, {0, 0}, {-1, 0}}));
}

TEST(PathBuilder, NothingDrivenIsAnEmptyPath) {
  PathBuilder b({1, 1});
  b.drive(Polyline{}, true);
  b.drive({1, 1}, true);
  EXPECT_TRUE(b.take().legs.empty());
}

}  // namespace
}  // namespace oxturn

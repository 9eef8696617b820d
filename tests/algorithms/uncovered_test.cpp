#include "algorithms/lanes/uncovered.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"

namespace oxturn {
namespace {

Robot with_tool(double width) {
  Robot robot;
  robot.radius = width / 2;
  robot.tool_width = width;
  return robot;
}

Region hall(double width, double height) { return {{{{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}}}; }

// Oracle: all of the path subtracted at once, under the tool, and under one wider by the seams that count as covered.
void expect_rest(const Path& path, const Region& region, const Robot& robot) {
  std::vector<Polyline> lines;
  for (const Leg& leg : path.legs)
    if (leg.tool) lines.push_back(leg.points);
  const double r = robot.tool_width / 2, fine = 1e-4 * robot.tool_width;
  const Region most = subtract(region, swath_parts(lines, r, fine, Bound::inside));
  const Region least = subtract(region, swath_parts(lines, r + covered_seam(robot), fine, Bound::outside));
  const Region found = uncovered(region, path, robot);
  EXPECT_LT(area(subtract(found, most)), 1e-6);
  EXPECT_LT(area(subtract(least, found)), 1e-6);
}

TEST(Uncovered, OfNothingIsTheTarget) {
  EXPECT_NEAR(area(uncovered(hall(4, 3), {}, with_tool(0.4))), 12, 1e-6);
  PathBuilder off({0, 0});
  off.drive(Point(4, 0), false);
  EXPECT_NEAR(area(uncovered(hall(4, 3), off.take(), with_tool(0.4))), 12, 1e-6);
}

TEST(Uncovered, EachLegCoversItsOwnWidth) {
  PathBuilder path({0, 1});
  path.drive(Polyline{{0, 1}, {4, 1}}, true, Gear::forward, 0.1);
  path.drive(Point(4, 2), false);
  path.drive(Polyline{{4, 2}, {0, 2}}, true);
  EXPECT_NEAR(area(uncovered(hall(4, 3), path.take(), with_tool(0.4))), 12 - 4 * 0.1 - 4 * 0.4, 0.02);
}

// Spirals of short segments, laps from many deep to more than a tool width apart: chords stand for them at first.
TEST(Uncovered, OfSpiralsIsWhatAllOfTheirSegmentsLeave) {
  for (const double apart : {0.05, 0.3, 0.385, 0.395, 0.405, 0.45}) {
    SCOPED_TRACE(apart);
    PathBuilder path({1.8, 1.8});
    for (double turn = 0; apart * turn / (2 * kPi) < 1.4; turn += 0.08) {
      const double far = apart * turn / (2 * kPi);
      path.drive(Point(1.8 + far * std::cos(turn), 1.8 + far * std::sin(turn)), true);
    }
    path.drive(Point(0.1, 0.1), true);  // a long segment
    expect_rest(path.take(), hall(3.6, 3.6), with_tool(0.4));
  }
}

TEST(Uncovered, OfRandomWalksIsWhatTheyLeave) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    PathBuilder path({2, 2});
    const double step = rng.between(0.002, 0.5), bend = rng.between(0.0, 0.6);
    double heading = 0;
    for (int k = 0; k < 300; ++k) {
      heading += rng.between(-bend, bend);
      const Point to = path.at() + step * Point(std::cos(heading), std::sin(heading));
      path.drive(Point(to.cwiseMax(Point(0, 0)).cwiseMin(Point(4, 4))), rng.chance(0.97));
    }
    expect_rest(path.take(), hall(4, 4), with_tool(rng.between(0.2, 0.6)));
  }
}

// Oracle as above: squares of which most lie under one segment, some under several, and some beside all.
TEST(LeftOfPieces, IsWhatTheLinesLeave) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Region pieces;
    for (int k = 0; k < 400; ++k) {
      const Point low = 0.25 * Point(k % 20, k / 20);
      pieces.polygons.push_back(
          box_region(low, low + Point(rng.between(0.01, 0.24), rng.between(0.01, 0.24))).polygons[0]);
    }
    std::vector<Polyline> lines{{{0.3, 0.2}}};  // and a line of one point
    for (int l = 0; l < 6; ++l) {
      Polyline& line = lines.emplace_back();
      for (int k = 0; k < 5; ++k) line.push_back({rng.between(0.0, 5.0), rng.between(0.0, 5.0)});
    }
    const double r = 0.3, seam = 0.002;
    const Region found = left_of_pieces(pieces, lines, r, seam);
    const Region most = subtract(pieces, swath_parts(lines, r, 1e-4, Bound::inside));
    const Region least = subtract(pieces, swath_parts(lines, r + seam, 1e-4, Bound::outside));
    EXPECT_GT(area(most), 0.1);
    EXPECT_LT(area(subtract(found, most)), 1e-6);
    EXPECT_LT(area(subtract(least, found)), 1e-6);
  }
}

}  // namespace
}  // namespace oxturn

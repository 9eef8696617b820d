#include "algorithms/lanes/uncovered.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/lanes/convex_rest.hpp"
#include "algorithms/lanes/covered_cells.hpp"
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
void expect_rest(const Path& path, const Region& region, const Robot& robot, std::size_t least_segments = 1) {
  const double fine = 1e-4 * robot.tool_width;
  Region most = region, least = region;
  std::size_t segments = 0;
  for (const Leg& leg : path.legs) {
    if (!leg.tool) continue;
    const double width = leg.width > 0 ? leg.width : robot.tool_width,
                 seam = covered_seam(robot) * width / robot.tool_width;
    segments += leg.points.size();
    most = subtract(most, swath_parts({leg.points}, width / 2, fine, Bound::inside));
    least = subtract(least, swath_parts({leg.points}, width / 2 + seam, fine, Bound::outside));
  }
  EXPECT_GE(segments, least_segments);
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

// Enough segments that most cells are looked at without an overlay: laps just near enough or too far apart, holes that
// the path crosses, curves of short and of longer segments, and a leg of another width.
TEST(Uncovered, OfManySegmentsIsWhatTheyLeave) {
  for (const double apart : {0.37, 0.399, 0.401, 0.41}) {
    for (const double step : {0.01, 0.1}) {
      SCOPED_TRACE(fmt::format("{} {}", apart, step));
      Region region = hall(12, 9);
      for (double x = 1; x < 11; x += 1.7)
        region.polygons[0].holes.push_back({{x, 2}, {x + 0.3, 5}, {x + 0.6, 2}, {x + 0.2, 1.5}});
      PathBuilder path({0.2, 0.2});
      const double wave = step < 0.05 ? 0.02 : 0;
      for (double y = 0.2; y < 8.9; y += apart)
        for (double x = 0.2; x <= 11.8; x += step) path.drive(Point(x, y + wave * std::sin(3 * x)), true);
      path.drive(Polyline{{6, 0}, {6, 9}}, true, Gear::forward, 0.9);
      expect_rest(path.take(), region, with_tool(0.4), 2500);
    }
  }
}

TEST(Uncovered, NothingIsLeftInACellBetweenTwoLaps) {
  std::vector<Polyline> laps;
  for (double y = 0.2; y < 9; y += 0.39) {
    Polyline& lap = laps.emplace_back();
    for (double x = 0.2; x < 11.8; x += 0.03) lap.push_back({x, y});
  }
  const Region region{{{{{0.3, 0.3}, {11, 0.3}, {11, 8.5}, {0.3, 8.5}}, {{{5, 4}, {5, 5}, {6, 4.5}}}}}};
  const auto open = in_open_cells(region, {{laps, 0.2, 0.0016}});
  ASSERT_TRUE(open);
  EXPECT_TRUE(open->region.empty());
  laps.erase(laps.begin() + 10);
  const auto gap = in_open_cells(region, {{laps, 0.2, 0.0016}});
  ASSERT_TRUE(gap);
  EXPECT_GT(area(gap->region), 10 * 0.37);
  EXPECT_LT(area(gap->region), 11 * 1.0);
  EXPECT_LE(gap->near[0].size(), 6u);
  EXPECT_FALSE(in_open_cells(region, {{{{{1, 1}, {2, 2}}}, 0.2, 0.0016}}));
}

// Oracle: samples, and for the area an overlay.
TEST(ConvexRest, IsWhatCapsulesLeave) {
  int covered = 0, known = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const auto point = [&] { return Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)); };
    ConvexRest rest({{-0.5, -0.5}, {0.5, 0.5}});
    std::vector<Polyline> lines;
    bool fits = true;
    const double radius = rng.between(0.3, 0.7);
    for (int k = 0; k < 4; ++k) {
      const Point a = point(), b = rng.chance(0.2) ? a : point();
      lines.push_back({a, b});
      fits = fits && rest.subtract(a, b, radius);
    }
    if (!fits) continue;
    ++known;
    covered += rest.empty() ? 1 : 0;
    double left = 0;
    for (const ConvexPiece& piece : rest) left += signed_area({piece.begin(), piece.end()});
    const Region box = box_region({-0.5, -0.5}, {0.5, 0.5});
    const double least = area(subtract(box, swath_parts(lines, radius, 1e-5, Bound::inside)));
    EXPECT_GE(left, least - 1e-4);
    EXPECT_LE(left, least + 0.02);
    for (int k = 0; k < 200; ++k) {
      const Point p = point() / 2;
      if (std::ranges::any_of(lines, [&](const Polyline& l) { return distance_to_segment(p, l[0], l[1]) < radius; }))
        continue;
      EXPECT_TRUE(std::ranges::any_of(rest, [&](const ConvexPiece& piece) {
        return contains(Region{{{{piece.begin(), piece.end()}, {}}}}, p);
      }));
    }
  }
  EXPECT_GT(known, 360);
  EXPECT_GT(covered, 40);
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

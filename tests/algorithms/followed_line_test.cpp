#include "algorithms/drawing/followed_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/drawing/uncovered_parts.hpp"
#include "base/random.hpp"
#include "geometry/bends.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

FollowOptions options(double radius) {
  return {.radius = radius, .deviation = 0.008, .tool_width = 0.42, .chord_error = 0.3e-3};
}

Polyline circle(double radius, int n) {
  Polyline points;
  for (int k = 0; k <= n; ++k)
    points.push_back({radius * std::cos(2 * kPi * (k % n) / n), radius * std::sin(2 * kPi * (k % n) / n)});
  return points;
}

double distance_to(const Polyline& line, const Point& p) {
  double least = 1e9;
  for (std::size_t k = 1; k < line.size(); ++k) least = std::min(least, distance_to_segment(p, line[k - 1], line[k]));
  return least;
}

/// By sampling: each point of the one line is near the others.
double farthest(const Polyline& line, const std::vector<Polyline>& others) {
  double most = 0;
  for (std::size_t k = 1; k < line.size(); ++k)
    for (int i = 0; i <= 4; ++i) {
      const Point p = lerp(line[k - 1], line[k], i / 4.0);
      double least = 1e9;
      for (const Polyline& other : others) least = std::min(least, distance_to(other, p));
      most = std::max(most, least);
    }
  return most;
}

void expect_followed(const Polyline& line, const FollowOptions& o) {
  const std::vector<Polyline> pieces = followed_line(line, o);
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().front(), line.front());
  EXPECT_EQ(pieces.back().back(), line.back());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    ASSERT_GE(pieces[k].size(), 2u);
    if (k > 0) { EXPECT_EQ(pieces[k].front(), pieces[k - 1].back()); }
    for (const Bend& bend : bends({{{true, pieces[k]}}}, o.tolerance, o.tool_width))
      EXPECT_FALSE(too_sharp(bend, o.radius)) << to_text(bend.at);
    EXPECT_LE(farthest(pieces[k], {line}), o.deviation + 1e-6);
  }
  EXPECT_LE(farthest(line, pieces), o.deviation + 1e-6);
}

TEST(FollowedLine, GentleLinesStayAsTheyAre) {
  const Polyline wide = circle(2, 200);
  EXPECT_EQ(followed_line(wide, options(0.5)), std::vector<Polyline>{wide});
}

TEST(FollowedLine, ASharpCornerMakesTwoPieces) {
  const Polyline corner{{0, 0}, {4, 0}, {4, 3}};
  EXPECT_EQ(followed_line(corner, options(0.5)).size(), 2u);
  expect_followed(corner, options(0.5));
}

TEST(FollowedLine, AnObtuseCornerIsRounded) {
  const Polyline bent{{0, 0}, {4, 0}, {8, 0.8}};
  EXPECT_EQ(followed_line(bent, options(0.5)).size(), 1u);
  expect_followed(bent, options(0.5));
}

// A circle of 0.1 m in flat arcs: as many as headings allow, and no more than half as many again.
TEST(FollowedLine, ATightCircleBecomesAChainOfArcs) {
  const std::size_t pieces = followed_line(circle(0.1, 60), options(0.5)).size();
  EXPECT_GE(pieces, 5u);
  EXPECT_LE(pieces, 15u);
  expect_followed(circle(0.1, 60), options(0.5));
}

TEST(FollowedLine, RandomLinesAreFollowed) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Polyline line{{0, 0}};
    double heading = 0;
    for (int k = 0; k < 40; ++k) {
      heading += (rng.unit() - 0.5) * (k % 9 == 0 ? 5 : 0.8);
      line.push_back(line.back() + (0.02 + 0.4 * rng.unit()) * Point(std::cos(heading), std::sin(heading)));
    }
    expect_followed(line, options(0.2 + 0.5 * rng.unit()));
  }
}

TEST(FollowedLine, WhatMayNotBeDrivenIsNot) {
  FollowOptions o = options(0.5);
  o.free = [](const Polyline& piece) { return piece.size() < 3; };  // no arc
  for (const Polyline& piece : followed_line(circle(0.3, 40), o))
    EXPECT_NEAR(length(piece), distance(piece.front(), piece.back()), 1e-9);
}

TEST(SharpVertices, AClosedLinesFirstPointCounts) {
  const Polyline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  EXPECT_EQ(sharp_vertices(square, true, options(0.2)), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(sharp_vertices(square, false, options(0.2)), (std::vector<std::size_t>{1, 2, 3}));
}

// A square of 2 m, swept along its inset: what is left are the corners, and the lap passes all of them.
TEST(UncoveredParts, CornersOfASquare) {
  const Region square{{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}}}};
  const Polyline lap{{0.2, 0.2}, {1.8, 0.2}, {1.8, 1.8}, {0.2, 1.8}, {0.2, 0.2}};
  const Region rest = not_surely_covered(square, {{.tool = true, .points = lap, .width = 0.4}}, 1);
  const double corner = 0.2 * 0.2 * (1 - kPi / 4), middle = 1.2 * 1.2;
  EXPECT_NEAR(area(rest), 4 * corner + middle, 1e-3);
  EXPECT_EQ(worthwhile(rest, 0.16).polygons.size(), 5u);
  Region corners = worthwhile(rest, 0.16);
  std::erase_if(corners.polygons, [](const Polygon& p) { return area(p) > 1; });
  const std::vector<Polyline> parts = parts_near({lap}, corners, 0.16);
  EXPECT_TRUE(parts.empty());                             // too far inside for the narrow tool
  EXPECT_EQ(parts_near({lap}, corners, 0.4).size(), 5u);  // the first corner at both ends
}

}  // namespace
}  // namespace oxturn

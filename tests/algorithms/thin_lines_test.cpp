#include "algorithms/drawing/thin_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/path.hpp"

namespace oxturn {
namespace {

constexpr double kPen = 0.04, kLeast = 0.1;

std::vector<Polyline> thin_lines(const Polygon& area, double width, double least) {
  return ThinLines(area, width).lines(least);
}

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Ring circle(const Point& centre, double radius, int n) {
  Ring ring;
  for (int k = 0; k < n; ++k)
    ring.push_back(centre + radius * Point(std::cos(2 * kPi * k / n), std::sin(2 * kPi * k / n)));
  return ring;
}

TEST(ThinLines, AStripIsDrawnAlongItsMiddle) {
  const auto lines = thin_lines({box(0, 0, 1, 0.02), {}}, kPen, kLeast);
  ASSERT_EQ(lines.size(), 1u);
  for (const Point& p : lines[0]) EXPECT_NEAR(p.y(), 0.01, 1e-6);
  EXPECT_NEAR(length(lines[0]), 1 - 0.02, 1e-3);  // without the branches into its corners
}

TEST(ThinLines, WherePenFitsThereAreNone) {
  EXPECT_TRUE(thin_lines({box(0, 0, 1, 1), {}}, kPen, kLeast).empty());
  EXPECT_TRUE(thin_lines({circle({0, 0}, 0.5, 100), {}}, kPen, kLeast).empty());
}

TEST(ThinLines, KnowTheLargestDisc) {
  EXPECT_NEAR(ThinLines({box(0, 0, 3, 0.5), {}}, kPen).largest_radius(), 0.25, 1e-6);
  EXPECT_NEAR(ThinLines({circle({0, 0}, 0.5, 100), {}}, kPen).largest_radius(), 0.5 * std::cos(kPi / 100), 1e-6);
}

TEST(ThinLines, AThinTailOfAThickArea) {
  const Polygon flag{{{0, 0}, {1, 0}, {1, 0.49}, {2, 0.49}, {2, 0.51}, {1, 0.51}, {1, 1}, {0, 1}}, {}};
  const auto lines = thin_lines(flag, kPen, kLeast);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(length(lines[0]), 1, 0.03);
  EXPECT_TRUE(thin_lines(flag, kPen, 1.2).empty());  // shorter than asked for
}

// The outline of a letter o: one line round, whatever small corners its sides have.
TEST(ThinLines, ARingIsOneClosedLine) {
  Ring inner = circle({0, 0}, 0.49, 90);
  std::reverse(inner.begin(), inner.end());
  const auto lines = thin_lines({circle({0, 0}, 0.51, 90), {inner}}, kPen, kLeast);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  EXPECT_NEAR(length(lines[0]), kPi, 0.02);
  for (const Point& p : lines[0]) EXPECT_NEAR(p.norm(), 0.5, 2e-3);
}

TEST(ThinLines, AtAJunctionTheStraightestGoOn) {
  // A T: the bar is one line, the stem another one.
  const Polygon t{{{0.49, 0}, {0.51, 0}, {0.51, 0.98}, {1, 0.98}, {1, 1}, {0, 1}, {0, 0.98}, {0.49, 0.98}}, {}};
  const auto lines = thin_lines(t, kPen, kLeast);
  ASSERT_EQ(lines.size(), 2u);
  const double longer = std::max(length(lines[0]), length(lines[1]));
  EXPECT_NEAR(longer, 0.98, 0.01);
  EXPECT_NEAR(length(lines[0]) + length(lines[1]), 1.96, 0.02);
}

TEST(ThinLines, DotsAreDrawnSpecksAreNot) {
  for (const Ring& ring :
       {box(0, 0, 0.02, 0.02), circle({0.01, 0.01}, 0.01, 40), Ring{{0, 0}, {0.03, 0}, {0.015, 0.02}}}) {
    const auto lines = thin_lines({ring, {}}, kPen, kLeast);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(length(lines[0]), kPen / 4, 1e-9);
  }
  EXPECT_TRUE(thin_lines({box(0, 0, 0.005, 0.005), {}}, kPen, kLeast).empty());
}

}  // namespace
}  // namespace oxturn

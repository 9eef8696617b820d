#include "geometry/overlay/swath.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

TEST(Swath, OfASegmentIsACapsule) {
  const double error = 1e-4, exact = 2 * 0.5 * 3 + kPi * 0.25;
  for (const double angle : {0.0, 0.3, 2.0, kPi}) {
    const Polyline line{{1, 1}, Point(1, 1) + rotated({3, 0}, angle)};
    const double inside = area(swath({line}, 0.5, error, Bound::inside));
    const double outside = area(swath({line}, 0.5, error, Bound::outside));
    EXPECT_LT(inside, exact);
    EXPECT_GT(outside, exact);
    EXPECT_GT(inside, exact - kPi * error);
    EXPECT_LT(outside, exact + kPi * error);
  }
}

TEST(Swath, OfAPointIsADiscAndOfNothingIsNothing) {
  EXPECT_NEAR(area(swath({{{2, 3}}}, 1, 1e-5, Bound::inside)), kPi, 1e-4);
  EXPECT_NEAR(area(swath({{{2, 3}, {2, 3}}}, 1, 1e-5, Bound::outside)), kPi, 1e-4);
  EXPECT_TRUE(swath({}, 1, 0.1, Bound::inside).empty());
  EXPECT_THROW(swath({{{0, 0}}}, 0, 0.1, Bound::inside), std::invalid_argument);
  EXPECT_THROW(swath({{{0, 0}}}, 1, 0, Bound::inside), std::invalid_argument);
}

/// Points are in the swath if they are near a segment, but for the chord error.
void expect_near_lines(const std::vector<Polyline>& lines, double radius, const std::vector<Point>& points) {
  const double error = radius / 50;
  const Region inside = swath(lines, radius, error, Bound::inside);
  const Region outside = swath(lines, radius, error, Bound::outside);
  for (const Point& p : points) {
    double least = 1e9;
    for (const Polyline& line : lines)
      for (std::size_t i = 0; i < line.size(); ++i)
        least = std::min(least, distance_to_segment(p, line[i], line[std::min(i + 1, line.size() - 1)]));
    if (least < radius - error) { EXPECT_TRUE(contains(inside, p)) << p.transpose(); }
    if (least > radius) { EXPECT_FALSE(contains(inside, p)) << p.transpose(); }
    if (least < radius) { EXPECT_TRUE(contains(outside, p)) << p.transpose(); }
    if (least > radius + error) { EXPECT_FALSE(contains(outside, p)) << p.transpose(); }
  }
}

TEST(Swath, AgreesWithDistances) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const auto any = [&] { return Point(rng.between(0.0, 4.0), rng.between(0.0, 4.0)); };
    std::vector<Polyline> lines(rng.below(3) + 1);
    for (Polyline& line : lines)
      for (std::uint64_t n = rng.below(8) + 1; n > 0; --n) line.push_back(any());
    const double radius = rng.between(0.05, 0.6);
    std::vector<Point> points;
    for (int k = 0; k < 300; ++k) points.push_back(any());
    expect_near_lines(lines, radius, points);
  }
}

// Long lines of segments shorter than the radius, with gentle and sharp bends, straight runs, and arcs there and back:
// the inner sides of bends overlap many deep, or meet in one point.
TEST(Swath, OfWindingLinesAgreesWithDistances) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const double radius = rng.between(0.1, 0.5), bend = rng.between(0.0, 1.5);
    Polyline line{{0, 0}};
    double heading = 0;
    for (int n = 0; n < 60; ++n) {
      const double step = radius * std::pow(10, rng.between(-2.0, 0.5));
      if (rng.chance(0.8)) heading += rng.chance(0.1) ? kPi * rng.between(-1.0, 1.0) : rng.between(-0.2 * bend, bend);
      line.push_back(line.back() + rotated({step, 0}, heading));
    }
    if (seed % 3 == 0)
      for (std::size_t k = line.size(); k-- > 1;) line.push_back(line[k - 1]);
    std::vector<Point> points;
    for (int k = 0; k < 400; ++k)
      points.push_back(line[rng.below(line.size())] +
                       rotated({radius * rng.between(0.5, 1.3), 0}, 2 * kPi * rng.unit()));
    expect_near_lines({line}, radius, points);
  }
}

// A zigzag of 2,000 strokes, each overlapping 800 others: united all at once their edges cross a million times.
TEST(Swath, OfStrokesHundredsDeepIsThatOfTheirOutline) {
  Polyline line;
  for (int k = 0; k <= 2000; ++k) line.emplace_back(k * 5e-4, k % 2 == 0 ? 0 : 0.02);
  const double r = 0.2, exact = 1 * (0.02 + 2 * r) + kPi * r * r + 2 * r * 0.02;
  for (const Bound bound : {Bound::inside, Bound::outside})
    EXPECT_NEAR(area(swath({line}, r, 2e-3 * r, bound)), exact, 0.01 * exact);
}

TEST(Swath, ItsPartsTakeAwayWhatTheWholeDoes) {
  Rng rng(5);
  Polyline line;
  for (int k = 0; k < 1500; ++k) line.emplace_back(rng.between(0.0, 10.0), rng.between(0.0, 10.0));
  for (const std::size_t n : {std::size_t{3}, line.size()}) {
    const std::vector<Polyline> lines{Polyline(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(n))};
    const Region floor = box_region({0, 0}, {10, 10});
    const Region left = subtract(floor, swath_parts(lines, 0.02, 1e-3, Bound::outside));
    const Region expected = subtract(floor, swath(lines, 0.02, 1e-3, Bound::outside));
    EXPECT_EQ(left.polygons.size(), expected.polygons.size());
    EXPECT_NEAR(area(left), area(expected), 1e-5);
    EXPECT_NEAR(area(subtract(left, expected)) + area(subtract(expected, left)), 0, 1e-5);
  }
}

// A wave of 20,000 vertices 0.1 mm apart: the bounds hold, with a small share of the vertices.
TEST(Swath, OfDenseLinesIsBoundedToo) {
  Polyline dense, coarse;
  for (int k = 0; k <= 20000; ++k) dense.push_back({1e-4 * k, 0.1 * std::sin(5e-4 * k)});
  for (int k = 0; k <= 20000; k += 40) coarse.push_back(dense[static_cast<std::size_t>(k)]);
  const double radius = 0.2, error = 1e-3;
  const Region inside = swath({dense}, radius, error, Bound::inside),
               outside = swath({dense}, radius, error, Bound::outside);
  // The coarse line has chords of 4 mm, less than 0.1 micrometres off the wave.
  EXPECT_LT(area(subtract(inside, swath({coarse}, radius, 1e-5, Bound::outside))), 1e-6);
  EXPECT_LT(area(subtract(swath({coarse}, radius, 1e-5, Bound::inside), outside)), 1e-6);
  EXPECT_LT(area(subtract(outside, inside)), 2 * error * 5.5);
  EXPECT_LT(vertex_count(outside), 500u);
}

// They lie in the swath, and what they lack lies about the two ends, outside of three chords of a half disc.
TEST(Swath, WithBluntEndsLacksSegmentsOfDiscsOnly) {
  const double r = 0.5, lacks = kPi / 6 - std::sin(kPi / 3) / 2;  // of r^2, a chord's segment
  const std::vector<Polyline> lines{{{0, 0}, {3, 0.5}, {5, 3}}};
  const Region whole = swath(lines, r, 1e-4, Bound::outside);
  const Region blunt = unite(swath_parts_with_blunt_ends(lines, r, 1e-4, Bound::outside));
  EXPECT_LT(area(subtract(blunt, whole)), 1e-6);
  EXPECT_NEAR(area(whole) - area(blunt), 6 * lacks * r * r, 1e-3);
}

}  // namespace
}  // namespace oxturn

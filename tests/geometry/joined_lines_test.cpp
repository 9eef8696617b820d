#include "geometry/joined_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "random_region.hpp"

namespace oxturn {
namespace {

constexpr double kTolerance = 1e-3;

double distance_to(const Polyline& line, const Point& p) {
  double least = 1e300;
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

/// An arc of radius 5, in n pieces of two or three points, in any order and direction; some come twice, and ends that
/// meet differ by rounding.
std::vector<Polyline> shattered_arc(Rng& rng, int n) {
  const auto at = [](double t) { return Point(5 * std::cos(t), 5 * std::sin(t)); };
  const auto near = [&](const Point& p) -> Point {
    return p + Point(rng.between(-1e-7, 1e-7), rng.between(-1e-7, 1e-7));
  };
  std::vector<Polyline> pieces;
  for (int k = 0; k < n; ++k) {
    const double begin = 2.0 * k / n, end = 2.0 * (k + 1) / n;
    Polyline piece{near(at(begin)), near(at(end))};
    if (rng.chance(0.5)) piece.insert(piece.begin() + 1, at((begin + end) / 2));
    if (rng.chance(0.5)) std::reverse(piece.begin(), piece.end());
    if (rng.chance(0.2)) pieces.push_back(piece);
    if (rng.chance(0.2)) pieces.push_back({piece.front(), near(piece.front())});  // a tiny one
    pieces.push_back(std::move(piece));
  }
  for (std::size_t i = pieces.size(); i > 1; --i)
    std::swap(pieces[i - 1], pieces[static_cast<std::size_t>(rng.between(0, static_cast<int>(i) - 1))]);
  return pieces;
}

TEST(JoinedLines, PiecesOfALineBecomeThatLine) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const int n = rng.between(1, 300);
    const std::vector<Polyline> pieces = shattered_arc(rng, n), whole = joined_lines(pieces, kTolerance);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_LE(whole[0].size(), 100u);  // of up to 600; a chord of 0.2 m is 1e-3 m off
    for (const Polyline& piece : pieces)
      for (const Point& p : piece) EXPECT_LE(distance_to(whole[0], p), 2 * kTolerance);
    EXPECT_EQ(common_ends(whole, 2).size(), 0u);
  }
}

TEST(JoinedLines, ThreeLinesEndAtOnePoint) {
  const std::vector<Polyline> pieces{
      {{0, 0}, {1, 0}}, {{1, 1e-6}, {2, 0}}, {{2, 1e-6}, {3, 1}}, {{2 + 1e-6, 0}, {3, -1}}, {{3, 1}, {4, 2}}};
  const std::vector<Polyline> whole = joined_lines(pieces, kTolerance);
  ASSERT_EQ(whole.size(), 3u);
  const std::vector<Point> hubs = common_ends(whole, 3);
  ASSERT_EQ(hubs.size(), 1u);
  EXPECT_LE(distance(hubs[0], {2, 0}), 1e-5);
  for (const Polyline& line : whole) EXPECT_EQ(line.size(), 2u);
}

TEST(JoinedLines, RingsStayClosed) {
  const std::vector<Polyline> square{{{0, 0}, {1, 0}}, {{1, 1}, {1, 0}}, {{1, 1}, {0, 1}}, {{0, 0}, {0, 1}}};
  const std::vector<Polyline> whole = joined_lines(square, kTolerance);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].size(), 5u);
  EXPECT_EQ(whole[0].front(), whole[0].back());
  EXPECT_TRUE(joined_lines({}, kTolerance).empty());
  EXPECT_TRUE(joined_lines({{}, {{1, 1}}, {{2, 2}, {2, 2}}}, kTolerance).empty());
}

// Two ways around the same square, with the same ends.
TEST(JoinedLines, LinesThatOnlyShareTheirEndsAreNoRepetition) {
  const std::vector<Polyline> whole = joined_lines({{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {0, 1}, {1, 1}}}, kTolerance);
  double sum = 0;
  for (const Polyline& line : whole) sum += length(line);
  EXPECT_NEAR(sum, 4, 1e-9);
}

}  // namespace
}  // namespace oxturn

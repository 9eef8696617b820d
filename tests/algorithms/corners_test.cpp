// Corners rounded inside and outside: closed forms, and curvature, tangents and ends on random polylines.
#include "algorithms/smoothing/corners.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/algorithms/curve_checks.hpp"

namespace oxturn {
namespace {

/// Where the driven curve begins and ends, by its pieces.
void check_loop(const Curve& loop, double tolerance) {
  Pose at = loop.from;
  for (const CurvePiece& piece : loop.pieces) {
    ASSERT_GE(piece.length, 0);
    at = after(at, piece, loop.radius);
  }
  ASSERT_LT(distance(at.at, loop.to.at), tolerance * loop.radius);
  ASSERT_LT(std::abs(std::remainder(at.heading - loop.to.heading, 2 * kPi)), 1e-9);
  ASSERT_EQ(loop.from.at, loop.to.at);
}

TEST(Corners, BulbIsBoundedAndNeverLongerThanTheStraightLoop) {
  Rng rng(1);
  for (int i = 0; i < 30000; ++i) {
    const double radius = std::exp(rng.between(-2.0, 3.0));
    const double deflection = rng.chance(0.01) ? kPi : rng.between(-kPi, kPi);
    const Pose at{{5, -7}, rng.between(-4.0, 4.0)};
    const Curve loop = bulb(at, deflection, radius);
    check_loop(loop, 1e-9);
    if (HasFatalFailure()) return;
    ASSERT_LE(loop.length(), 7 * kPi / 3 * radius * (1 + 1e-12)) << i;
    ASSERT_LE(loop.length(), dubins_curve(loop.from, loop.to, radius).length() + 1e-5 * radius) << i;
    if (i % 20 == 0) {
      const Leg leg = sampled(loop, 1e-4 * radius, false).front();
      for (const Point& p : leg.points) ASSERT_LE(distance(p, at.at), (1 + std::sqrt(3.0)) * radius * (1 + 1e-9)) << i;
    }
    if (std::abs(deflection) > 3.13) continue;
    const Curve straight = straight_loop(at, deflection, radius);
    check_loop(straight, 1e-6);
    ASSERT_LE(loop.length(), straight.length() * (1 + 1e-12)) << i;
  }
}

TEST(Corners, ARightAngleInside) {
  const Polyline line{{0, 0}, {4, 0}, {4, 4}};
  const CornerOptions options{.rule = CornerRule::inside, .radius = 1, .chord_error = 1e-5};
  const RoundedLine rounded = rounded_corners(line, {1}, options);
  ASSERT_EQ(rounded.legs.size(), 1u);
  EXPECT_TRUE(rounded.stops.empty());
  EXPECT_NEAR(length(rounded.legs[0].points), 6 + kPi / 2, 1e-4);
  for (const Point& p : rounded.legs[0].points)
    if (p.x() > 3 && p.y() < 1) { EXPECT_NEAR(distance(p, {3, 1}), 1, 1e-9); }
  const RoundedLine no_room = rounded_corners({{0, 0}, {0.9, 0}, {0.9, 4}}, {1}, options);
  EXPECT_EQ(no_room.stops, std::vector<std::size_t>{1});
  EXPECT_EQ(no_room.legs.size(), 2u) << "a leg ends at each stop";
}

// Two corners on one edge: both fit only if their tangents together do.
TEST(Corners, NeighboursShareAnEdge) {
  const CornerOptions options{.rule = CornerRule::inside, .radius = 1, .may_stop = false};
  for (const double edge : {1.99, 2.0}) {
    const RoundedLine rounded = rounded_corners({{0, 0}, {4, 0}, {4, edge}, {0, edge}}, {1, 2}, options);
    EXPECT_EQ(rounded.failed.size(), edge < 2 ? 1u : 0u);
    EXPECT_TRUE(rounded.stops.empty());
  }
}

TEST(Corners, AutomaticTakesTheLoopWhereRoundingLeavesTheVertex) {
  const Polyline line{{0, 0}, {10, 0}, {10, 10}};
  const double deviation = std::sqrt(2.0) - 1;
  for (const double allowed : {0.99 * deviation, 1.01 * deviation}) {
    const RoundedLine rounded = rounded_corners(line, {1}, {.radius = 1, .largest_deviation = allowed});
    EXPECT_EQ(rounded.legs.size(), allowed < deviation ? 3u : 1u);
    if (rounded.legs.size() != 3) continue;
    EXPECT_FALSE(rounded.legs[1].tool);
    EXPECT_EQ(rounded.legs[0].points.back(), Point(10, 0));
    EXPECT_EQ(rounded.legs[1].points.front(), Point(10, 0));
    EXPECT_EQ(rounded.legs[1].points.back(), Point(10, 0));
    EXPECT_EQ(rounded.legs[2].points.front(), Point(10, 0));
  }
}

TEST(Corners, ALoopThatIsNotFreeIsReplacedByAStop) {
  const Polyline line{{0, 0}, {10, 0}, {10, 10}};
  const auto nowhere = [](const Polyline&) { return false; };
  const auto rounded = rounded_corners(line, {1}, {.radius = 1, .free = nowhere});
  EXPECT_EQ(rounded.stops, std::vector<std::size_t>{1});
  const auto failed = rounded_corners(line, {1}, {.radius = 1, .may_stop = false, .free = nowhere});
  EXPECT_EQ(failed.failed, std::vector<std::size_t>{1});
  EXPECT_EQ(failed.legs.size(), 1u);
  EXPECT_EQ(failed.legs[0].points, line);
}

TEST(Corners, AThreePointTurnIsShorterThanABulb) {
  const Polyline line{{0, 0}, {10, 0}, {10, 10}};
  const RoundedLine forward = rounded_corners(line, {1}, {.radius = 1});
  const RoundedLine reverse = rounded_corners(line, {1}, {.radius = 1, .reverse = true});
  const auto off = [](const RoundedLine& rounded) {
    double sum = 0;
    for (const Leg& leg : rounded.legs) sum += leg.tool ? 0 : length(leg.points);
    return sum;
  };
  EXPECT_LT(off(reverse), 0.5 * off(forward));
  EXPECT_GT(reverse.legs.size(), forward.legs.size());
}

TEST(Corners, LiteralRuleOfVollprecht) {
  const auto literal = [](const Polyline& line) {
    return rounded_corners(line, {1}, {.rule = CornerRule::literal, .radius = 1});
  };
  EXPECT_EQ(literal({{0, 0}, {9, 0}, {9, 9}}).legs.size(), 1u) << "inner angle of 90 degrees: inside";
  EXPECT_EQ(literal({{0, 0}, {9, 0}, {8, 9}}).legs.size(), 3u) << "less: outside";
  EXPECT_EQ(literal({{0, 0}, {0.5, 0}, {0.5, 9}}).stops.size(), 1u) << "no room: kept";
  EXPECT_EQ(literal({{0, 0}, {9, 0}, {0, 1e-9}}).stops.size(), 1u) << "a loop without bound";
}

/// Tangents are continuous at the ends of legs, curvature is kept along them.
void check_drivable(const RoundedLine& rounded, const Polyline& line) {
  ASSERT_EQ(rounded.legs.front().points.front(), line.front());
  ASSERT_EQ(rounded.legs.back().points.back(), line.back());
  Polyline all;
  for (const Leg& leg : rounded.legs) {
    if (!all.empty()) { ASSERT_EQ(all.back(), leg.points.front()); }
    for (const Point& p : leg.points)
      if (all.empty() || p != all.back()) all.push_back(p);
  }
  for (std::size_t i = 2; i < all.size(); ++i) {
    const double turn = heading_between(all[i - 1], all[i]) - heading_between(all[i - 2], all[i - 1]);
    // An arc of the radius, sampled with 1e-4 radii, turns by 0.0283 at each vertex.
    ASSERT_LE(std::abs(std::remainder(turn, 2 * kPi)), 0.0285) << i;
  }
}

TEST(Corners, RandomPolylinesBecomeDrivable) {
  Rng rng(2);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const double radius = std::exp(rng.between(-2.0, 2.0));
    Polyline line{{0, 0}};
    std::vector<std::size_t> corners;
    for (auto n = 2 + rng.below(8); n > 0; --n) {
      line.push_back(line.back() + radius * rng.between(0.01, 8.0) * direction({{0, 0}, rng.between(-kPi, kPi)}));
      if (n > 1) corners.push_back(line.size() - 1);
    }
    for (const double sharpness : {-1.0, 0.0}) {
      const auto rule = rng.chance(0.7) ? CornerRule::automatic : CornerRule::outside;
      const RoundedLine rounded = rounded_corners(line, corners,
                                                  {.rule = rule,
                                                   .radius = radius,
                                                   .sharpness = sharpness,
                                                   .largest_deviation = rng.between(0.0, 2.0) * radius,
                                                   .chord_error = 1e-4 * radius,
                                                   .may_stop = false});
      ASSERT_TRUE(rounded.failed.empty());
      check_drivable(rounded, line);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Corners, OtherVerticesAreKept) {
  const Polyline line{{0, 0}, {1, 0.1}, {2, 0}, {3, 0}, {3, 3}};
  EXPECT_EQ(corners_of(line, 0.5), std::vector<std::size_t>{3});
  const RoundedLine rounded = rounded_corners(line, {3}, {.rule = CornerRule::outside, .radius = 0.2});
  EXPECT_EQ(rounded.legs[0].points, Polyline(line.begin(), line.begin() + 4));
}

TEST(Corners, HostileInput) {
  const Polyline line{{0, 0}, {1, 0}, {1, 1}};
  EXPECT_THROW(rounded_corners(line, {0}, {}), std::invalid_argument);
  EXPECT_THROW(rounded_corners(line, {2}, {}), std::invalid_argument);
  EXPECT_THROW(rounded_corners(line, {1, 1}, {}), std::invalid_argument);
  EXPECT_THROW(rounded_corners({{0, 0}}, {}, {}), std::invalid_argument);
  EXPECT_THROW(rounded_corners({{0, 0}, {1, 0}, {1, 0}, {2, 2}}, {1}, {}), std::invalid_argument);
  EXPECT_THROW(rounded_corners(line, {1}, {.radius = 0}), std::invalid_argument);
  EXPECT_EQ(rounded_corners({{0, 0}, {1, 0}, {0, 0}}, {1}, {.rule = CornerRule::inside}).stops.size(), 1u);
}

}  // namespace
}  // namespace oxturn

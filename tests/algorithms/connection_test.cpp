// Smooth connections on random poses: ends, tangents, curvature and length, by sampled points.
#include "algorithms/smoothing/connection.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>

#include "tests/algorithms/curve_checks.hpp"

namespace oxturn {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// OXTURN_CONNECTIONS: how many instead, for the wide test by hand.
int connections() {
  const char* count = std::getenv("OXTURN_CONNECTIONS");
  return count != nullptr ? std::atoi(count) : 10000;
}

/// `samples`: also by the sampled points.
void check(const Connection& c, const RandomConnection& p, bool samples) {
  const JointErrors errors = joint_errors(c.curve);
  ASSERT_TRUE(finite(c.curve));
  constexpr double kExact = 1e-6;
  ASSERT_LT(errors.position, kExact * p.radius) << static_cast<int>(c.kind);
  ASSERT_LT(errors.heading, kExact) << static_cast<int>(c.kind);
  ASSERT_LE(c.curvature * p.radius, 1.01);
  if (!samples || distance(p.from.at, p.to.at) < 1e-3 * p.radius) return;
  const Polyline line = sampled(c.curve, 2e-4 * p.radius);
  ASSERT_EQ(line.front(), p.from.at);
  ASSERT_EQ(line.back(), p.to.at);
  ASSERT_LE(sampled_curvature(line) * p.radius, 1.02) << static_cast<int>(c.kind);
  ASSERT_LE(end_kink(line, p.from, p.to), 0.03) << static_cast<int>(c.kind);
  ASSERT_LE(oxturn::length(line), length(c.curve) * (1 + 1e-6));
  ASSERT_GE(oxturn::length(line), length(c.curve) * 0.999);
}

TEST(Connection, AlwaysOneThatKeepsTheRadius) {
  Rng rng(1);
  std::array<int, 4> kinds{};
  for (int i = 0; i < connections(); ++i) {
    SCOPED_TRACE(i);
    const RandomConnection p(rng);
    const Connection c = smooth_connection(p.from, p.to, {.radius = p.radius});
    check(c, p, i % 5 == 0);
    if (HasFatalFailure()) return;
    ++kinds[static_cast<std::size_t>(c.kind)];
  }
  for (std::size_t kind = 0; kind < 3; ++kind) EXPECT_GT(kinds[kind], 0) << kind;
  RecordProperty("spiro", kinds[0]);
}

TEST(Connection, FromEachKindOn) {
  Rng rng(2);
  for (const auto first : {ConnectionKind::bezier, ConnectionKind::clothoid, ConnectionKind::dubins})
    for (int i = 0; i < connections() / 4; ++i) {
      SCOPED_TRACE(i);
      const RandomConnection p(rng);
      const Connection c = smooth_connection(p.from, p.to, {.radius = p.radius, .first = first});
      ASSERT_GE(c.kind, first);
      check(c, p, i % 5 == 0);
      if (HasFatalFailure()) return;
      if (first == ConnectionKind::dubins) {
        ASSERT_NEAR(length(c.curve), dubins_curve(p.from, p.to, p.radius).length(), 1e-6 * p.radius);
      }
    }
}

/// 50,000 connections by each rule: Vollprecht's gave some that were not finite.
void check_spiro_curves(SpiroRule rule) {
  Rng rng(3);
  int found = 0;
  for (int i = 0; i < 50000; ++i) {
    const RandomConnection p(rng);
    const std::vector<Point> through = spiro_control_points(p.from, p.to, 2 * p.radius, rule);
    for (const Point& c : through) ASSERT_TRUE(finite(c)) << i;
    ASSERT_TRUE(through.empty() || distance(through[0], through[1]) > 1.999 * p.radius) << i;
    const auto curve = spiro_curve(p.from, p.to, through, 2 * p.radius);
    if (!curve) continue;
    ++found;
    ASSERT_TRUE(finite(*curve)) << i;
    const JointErrors errors = joint_errors(*curve);
    ASSERT_LT(errors.heading, 1e-6) << i;
    ASSERT_LT(errors.position, 1e-9) << i;
  }
  EXPECT_GT(found, 45000);
}
TEST(Connection, SpiroCurvesAreFiniteAndEndInTheirPoses) { check_spiro_curves(SpiroRule::improved); }
TEST(Connection, LiteralSpiroCurvesAreFiniteToo) { check_spiro_curves(SpiroRule::literal); }

TEST(Connection, TheShortestIsNoLongerThanTheFirst) {
  Rng rng(5);
  double first = 0, shortest = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const RandomConnection p(rng);
    const Connection a = smooth_connection(p.from, p.to, {.radius = p.radius});
    const Connection b = smooth_connection(p.from, p.to, {.radius = p.radius, .shortest = true});
    check(b, p, i % 5 == 0);
    if (HasFatalFailure()) return;
    ASSERT_LE(length(b.curve), length(a.curve) * (1 + 1e-12));
    ASSERT_NE(b.kind, ConnectionKind::dubins);
    first += (length(a.curve) - distance(p.from.at, p.to.at)) / p.radius;
    shortest += (length(b.curve) - distance(p.from.at, p.to.at)) / p.radius;
  }
  EXPECT_LT(shortest, first);
  RecordProperty("detour_radii", std::to_string(first / 2000) + " " + std::to_string(shortest / 2000));
}

// Gentle connections need no control points; a straight one is a line.
TEST(Connection, AnalyticCases) {
  EXPECT_TRUE(spiro_control_points({{0, 0}, 0.3}, {{10, 0}, 0.2}, 2, SpiroRule::improved).empty());
  const Connection line = smooth_connection({{1, 1}, kPi / 2}, {{1, 9}, kPi / 2}, {.radius = 1});
  EXPECT_EQ(line.kind, ConnectionKind::spiro);
  EXPECT_NEAR(length(line.curve), 8, 1e-9);
  EXPECT_NEAR(line.curvature, 0, 1e-6);
  // Both headings lead away from the other end: the control points stand beside the ends, 2 R off the chord.
  const auto beside = spiro_control_points({{0, 0}, kPi}, {{10, 0}, -kPi + 1e-9}, 2, SpiroRule::improved);
  ASSERT_EQ(beside.size(), 2u);
  EXPECT_NEAR(distance(beside[0], {0, 2}), 0, 1e-6);
  EXPECT_NEAR(distance(beside[1], {10, 2}), 0, 1e-6);
  // Spiro curves begin and end without curvature, as lines do.
  const auto quarter = spiro_curve({{0, 0}, 0}, {{1, 1}, kPi / 2}, {}, 0.1);
  ASSERT_TRUE(quarter);
  EXPECT_NEAR(curvature_at(std::get<Bezier>(quarter->pieces.at(1)), 0), 0, 0.2);
  EXPECT_GT(largest_curvature(*quarter), 1);
  EXPECT_NEAR(length(*quarter), 1.6525, 1e-3);
}

// Control points closer than rho are moved: literally along their line, else about the ends.
TEST(Connection, ControlPointsKeepTheirDistance) {
  const Pose from{{0, 0}, kPi / 2}, to{{1, 0}, -kPi / 2};
  const auto literal = spiro_control_points(from, to, 2, SpiroRule::literal);
  EXPECT_NEAR(distance(literal[0], {-0.5, 2}), 0, 1e-9);
  EXPECT_NEAR(distance(literal[1], {1.5, 2}), 0, 1e-9);
  const auto improved = spiro_control_points(from, to, 2, SpiroRule::improved);
  EXPECT_NEAR(distance(improved[0], from.at), 2, 1e-9);
  EXPECT_NEAR(distance(improved[1], to.at), 2, 1e-9);
  EXPECT_GE(distance(improved[0], improved[1]), 2);
  EXPECT_LT(distance(improved[0], improved[1]), 2.1);
}

TEST(Connection, LiteralIsNotTested) {
  const Pose from{{0, 0}, 2.0}, to{{1.5, 0}, -1.0};
  const Connection literal = smooth_connection(from, to, {.radius = 1, .rule = SpiroRule::literal});
  EXPECT_EQ(literal.kind, ConnectionKind::spiro);
  EXPECT_EQ(literal.through, spiro_control_points(from, to, 2, SpiroRule::literal));
}

TEST(Connection, AllowedCurvesArePreferredAndTheRestSaysSo) {
  const Pose from{{0, 0}, 0}, to{{0, 3}, kPi};
  const auto left_of = [](double x) {
    return [x](const SmoothCurve& curve) {
      for (const Point& p : sampled(curve, 1e-3))
        if (p.x() > x) return false;
      return true;
    };
  };
  const Connection any = smooth_connection(from, to, {.radius = 1});
  double most = 0;
  for (const Point& p : sampled(any.curve, 1e-3)) most = std::max(most, p.x());
  const Connection narrow = smooth_connection(from, to, {.radius = 1, .allowed = left_of(most - 0.1)});
  EXPECT_TRUE(narrow.allowed);
  EXPECT_NE(length(narrow.curve), length(any.curve));
  const Connection none = smooth_connection(from, to, {.radius = 1, .allowed = left_of(-9)});
  EXPECT_FALSE(none.allowed);
  EXPECT_EQ(length(none.curve), length(any.curve));
}

TEST(Connection, APersonsPointsAreObeyed) {
  const Pose from{{0, 0}, 0}, to{{10, 0}, 0};
  const auto spiro = edited_connection(from, to, ConnectionKind::spiro, {{3, 2}, {7, -2}}, 0.5);
  ASSERT_TRUE(spiro);
  for (const Point& through : {Point(3, 2), Point(7, -2)}) {
    double nearest = 1;
    const Polyline line = sampled(spiro->curve, 1e-5);
    for (std::size_t i = 1; i < line.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(through, line[i - 1], line[i]));
    EXPECT_LT(nearest, 1e-4);
  }
  const auto bezier = edited_connection(from, to, ConnectionKind::bezier, {{4, 0}, {6, 0.1}}, 0.5);
  ASSERT_TRUE(bezier);
  EXPECT_EQ(std::get<Bezier>(bezier->curve.pieces.at(0)).points.size(), 4u);
  EXPECT_THROW(edited_connection(from, to, ConnectionKind::dubins, {}, 1), std::invalid_argument);
  EXPECT_FALSE(edited_connection(from, to, ConnectionKind::bezier, {{kNaN, 0}}, 1));
  EXPECT_THROW(edited_connection(from, to, ConnectionKind::bezier, std::vector<Point>(33, {1, 1}), 1),
               std::invalid_argument);
}

TEST(Connection, ManyPointsOfAPersonAreFinite) {
  Rng rng(4);
  for (int i = 0; i < 3000; ++i) {
    const RandomConnection p(rng);
    std::vector<Point> points;
    for (auto n = rng.below(6); n > 0; --n)
      points.push_back(p.from.at + p.radius * Point(rng.between(-9.0, 9.0), rng.between(-9.0, 9.0)));
    if (!points.empty() && rng.chance(0.1)) points.push_back(points.back());
    const auto edited = edited_connection(p.from, p.to, ConnectionKind::spiro, points, p.radius);
    if (edited) { ASSERT_TRUE(finite(edited->curve)) << i; }
  }
}

TEST(Connection, HostileInput) {
  EXPECT_THROW(smooth_connection({{kNaN, 0}, 0}, {{1, 0}, 0}, {}), std::invalid_argument);
  EXPECT_THROW(smooth_connection({{0, 0}, 0}, {{1, 0}, kNaN}, {}), std::invalid_argument);
  EXPECT_THROW(smooth_connection({{0, 0}, 0}, {{1, 0}, 0}, {.radius = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace oxturn

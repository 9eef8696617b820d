// Curvature of paths and what a robot with min_turn_radius may drive: circles, corners, cusps by hand.
#include <gmock/gmock.h>

#include <cmath>

#include "base/random.hpp"
#include "metrics/score.hpp"
#include "tests/metrics/shapes.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

Problem meadow(double radius, bool reverse = false) {
  Robot car;
  car.radius = 1, car.tool_width = 3, car.min_turn_radius = radius, car.reverse = reverse;
  return Problem(Map{"meadow", box_region({-100, -100}, {100, 100}), "test", "test"}, car, Point(0, 0));
}

/// A line, then an arc to the left, then a line; vertices on the arc unevenly spaced, at most the chord error apart.
Polyline bend(double radius, double angle, double w, Rng& rng) {
  Polyline line{{0, 0}, {20, 0}};
  const double most = 2 * std::acos(1 - w / 1000 / radius);
  for (double at = 0; at < angle;) {
    at = std::min(angle, at + most * rng.between(0.05, 1.0));
    line.push_back({20 + radius * std::sin(at), radius * (1 - std::cos(at))});
  }
  line.push_back(line.back() + 20 * Point(std::cos(angle), std::sin(angle)));
  return line;
}

TEST(Curvature, ACircleHasThatOfItsRadiusHoweverItIsSampled) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const double radius = rng.between(2.0, 20.0);
    const Polyline line = bend(radius, rng.between(1.0, 3.0), 3, rng);
    const Score s = score(meadow(radius), work(line));
    EXPECT_EQ(s.flaw, "") << radius;
    EXPECT_EQ(s.value("curvature_violations"), 0);
    EXPECT_NEAR(*s.value("curvature_max_per_m") * radius, 1, 0.01);
    const Score tight = score(meadow(radius * 1.03), work(line));
    EXPECT_THAT(tight.flaw, HasSubstr("turns too sharply at ("));
    EXPECT_GE(*tight.value("curvature_violations"), 1);
  }
}

TEST(Curvature, ACornerIsNotHiddenByLongEdges) {
  const Score s = score(meadow(4), work({{0, 0}, {60, 0}, {60, 60}}));
  EXPECT_THAT(s.flaw, HasSubstr("turns too sharply at (60, 0)"));
  EXPECT_NEAR(*s.value("curvature_max_per_m"), (1 - std::sqrt(0.5)) / 0.003, 1e-6);
  EXPECT_EQ(score(meadow(0), work({{0, 0}, {60, 0}, {60, 60}})).flaw, "");
}

TEST(Curvature, CuspsKeepTheHeading) {
  const auto path = [](Gear gear, const Point& to) {
    return Path{{{true, {{0, 0}, {10, 0}}, Gear::forward}, {false, {{10, 0}, to}, gear}}};
  };
  EXPECT_EQ(score(meadow(4, true), path(Gear::reverse, {3, 0})).flaw, "");
  EXPECT_EQ(score(meadow(4, true), path(Gear::reverse, {3, 0})).value("cusps"), 1);
  EXPECT_THAT(score(meadow(4, true), path(Gear::forward, {3, 0})).flaw, HasSubstr("turns too sharply at (10, 0)"));
  EXPECT_THAT(score(meadow(4, true), path(Gear::reverse, {3, 3})).flaw, HasSubstr("turns too sharply at (10, 0)"));
  EXPECT_EQ(score(meadow(4), path(Gear::reverse, {3, 0})).flaw,
            "drives backwards at (10, 0), robot 'disc' only forwards (reverse = false)");
}

// Coordinates rounded to a millimetre: valid with that tolerance.
TEST(Curvature, ToleranceOfCoordinates) {
  Rng rng(2);
  for (int i = 0; i < 50; ++i) {
    Polyline line = bend(4, 3, 3, rng);
    for (Point& p : line) p = (p * 1000).array().round() / 1000;
    EXPECT_EQ(score(meadow(4), work(line), {.tolerance = 0.001}).flaw, "");
  }
}

}  // namespace
}  // namespace oxturn

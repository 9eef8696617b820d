// turns, turn_rad, mission_s: by hand, and the same however finely a curve is sampled.
#include <gtest/gtest.h>

#include <functional>

#include "metrics/score.hpp"
#include "shapes.hpp"

namespace oxturn {
namespace {

constexpr double kTool = 0.4;  // speed 0.5 m/s, acceleration 0.5 m/s^2, turn rate 1.5 rad/s by default

Problem plain() { return problem_in(box_region({-100, -100}, {100, 100}), {0, 0}, 0.2, kTool); }

double value(const std::string& metric, const Path& path, const Problem& p) {
  for (const Metric& m : built_in_metrics()) {
    if (m.name != metric) continue;
    const SweptArea none;
    const MissionClock clock(p, path);
    return m.compute(Scored{p, path, none, 0, nullptr, &clock, p.tolerance(), {}}).value();
  }
  throw std::logic_error("no metric " + metric);
}
double turns(const Polyline& line) { return value("turns", work(line), plain()); }
double turn_rad(const Polyline& line) { return value("turn_rad", work(line), plain()); }
double mission(const Polyline& line) { return value("mission_s", work(line), plain()); }

/// Chords for an arc so that its error is `share` of a thousandth of the tool width.
int chords(double radius, double angle, double share) {
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (2 * std::acos(1 - share * kTool / 1000 / radius)))));
}

Polyline rounded_rectangle(double a, double b, double r, double share) {
  Polyline line{{a / 2, 0}};
  const int n = chords(r, kPi / 2, share);
  append(line, arc({a - r, r}, r, -kPi / 2, 0, n));
  append(line, arc({a - r, b - r}, r, 0, kPi / 2, n));
  append(line, arc({r, b - r}, r, kPi / 2, kPi, n));
  append(line, arc({r, r}, r, kPi, 3 * kPi / 2, n));
  line.push_back({a / 2, 0});
  return line;
}

Polyline spiral(double r0, double growth, double laps, double share) {
  Polyline line;
  for (double angle = 0; angle < 2 * kPi * laps;) {
    const double r = r0 + growth * angle;
    line.push_back(rotated({r, 0}, angle));
    angle += 2 * std::acos(1 - share * kTool / 1000 / r);
  }
  const double last = 2 * kPi * laps;
  line.push_back(rotated({r0 + growth * last, 0}, last));
  return line;
}

TEST(Turns, Corners) {
  EXPECT_EQ(turns({{0, 0}, {5, 0}}), 0);
  EXPECT_EQ(turns({{0, 0}, {5, 0}, {5, 5}}), 1);
  EXPECT_EQ(turns({{0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 0}}), 3);
  EXPECT_NEAR(turn_rad({{0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 0}}), 3 * kPi / 2, 1e-12);
  EXPECT_EQ(turns({{0, 0}, {5, 0}, {5, 0.3}, {0, 0.3}}), 2) << "a U-turn into the next lane is two corners";
  EXPECT_EQ(turns({{0, 0}, {5, 0}, {0, 0}}), 1);
  EXPECT_NEAR(turn_rad({{0, 0}, {5, 0}, {0, 0}}), kPi, 1e-12);
  EXPECT_EQ(turns({{0, 0}, {5, 0}, {5, 0}, {5, 0}, {5, 5}}), 1) << "standing still is no turn";
  EXPECT_EQ(turns({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}}), 3) << "stairs";
  EXPECT_EQ(turns({{0, 0}, {5, 0}, {10, 0.5}}), 0) << "0.1 rad is less than a turn";
  EXPECT_NEAR(turn_rad({{0, 0}, {5, 0}, {10, 0.5}}), std::atan2(0.5, 5), 1e-12);
}

TEST(Turns, TransitCountsToo) {
  const Path path{{Leg{true, {{0, 0}, {5, 0}}}, Leg{false, {{5, 0}, {5, 5}, {9, 5}}}, Leg{true, {{9, 5}, {9, 0}}}}};
  EXPECT_EQ(value("turns", path, plain()), 3);
}

TEST(Turns, ACurveIsOneTurnHoweverFine) {
  for (const double share : {1.0, 0.5, 0.1, 0.01, 0.0001}) {
    SCOPED_TRACE(share);
    for (const double r : {0.02, 0.05, 0.2, 0.6, 3.0}) {
      SCOPED_TRACE(r);
      Polyline bend{{-4, -r}};
      append(bend, arc({0, 0}, r, -kPi / 2, 0, chords(r, kPi / 2, share)));
      bend.push_back({r, 7});
      EXPECT_EQ(turns(bend), 1);
      EXPECT_NEAR(turn_rad(bend), kPi / 2, 1e-9);
      EXPECT_EQ(turns(rounded_rectangle(9, 8, r, share)), 4);
      EXPECT_NEAR(turn_rad(rounded_rectangle(9, 8, r, share)), 2 * kPi, 1e-9);
    }
    EXPECT_EQ(turns(spiral(0.1, 0.06, 8, share)), 1);
    EXPECT_NEAR(turn_rad(spiral(0.1, 0.06, 8, share)), turn_rad(spiral(0.1, 0.06, 8, 0.001)),
                0.01 * turn_rad(spiral(0.1, 0.06, 8, 0.001)));
    Polyline wave;  // S bends: left, right, left, right
    for (int k = 0; k < 4; ++k)
      append(wave, k % 2 ? arc({2.0 * k, 0}, 1, kPi, 2 * kPi, chords(1, kPi, share))
                         : arc({2.0 * k, 0}, 1, kPi, 0, chords(1, kPi, share)));
    EXPECT_EQ(turns(wave), 4);
    EXPECT_NEAR(turn_rad(wave), 4 * kPi, 0.002 * 4 * kPi);
    EXPECT_NEAR(turn_rad(arc({0, 0}, 0.4, 0, 2 * kPi, chords(0.4, 2 * kPi, share))), 2 * kPi, 1e-9);
  }
}

TEST(Turns, StraightPiecesSampledFinely) {
  Polyline line;
  for (int k = 0; k <= 500; ++k) line.push_back(rotated({0.01 * k, 0}, 0.3));
  for (int k = 1; k <= 500; ++k) line.push_back(rotated({5, 0.01 * k}, 0.3));
  EXPECT_EQ(turns(line), 1);
  EXPECT_NEAR(turn_rad(line), kPi / 2, 1e-9);
}

TEST(Mission, StraightLines) {
  EXPECT_NEAR(mission({{0, 0}, {10, 0}}), 10 / 0.5 + 1, 1e-9);               // ramps of 1 s cost half of it each
  EXPECT_NEAR(mission({{0, 0}, {0.1, 0}}), 2 * std::sqrt(0.1 / 0.5), 1e-9);  // never reaches full speed
  EXPECT_EQ(mission({{0, 0}, {0, 0}}), 0);
  EXPECT_NEAR(mission({{0, 0}, {1, 0}, {4, 0}, {10, 0}}), 21, 1e-9);
}

TEST(Mission, StopsAtCornersAndTurns) {
  const double side = 4 / 0.5 + 1, turn = kPi / 2 / 1.5;
  EXPECT_NEAR(mission({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}), 4 * side + 3 * turn, 1e-9);
  EXPECT_NEAR(mission({{0, 0}, {4, 0}, {0, 0}}), 2 * side + kPi / 1.5, 1e-9);
}

TEST(Mission, CirclesAtTheTurnRate) {
  // Radius 0.2: 1.5 rad/s allows 0.3 m/s. Twenty laps, so that the ramps hardly count.
  const double laps = 20, length = 2 * kPi * 0.2 * laps;
  const Polyline circle = arc({0, 0}, 0.2, 0, 2 * kPi * laps, chords(0.2, 2 * kPi * laps, 1));
  EXPECT_NEAR(mission(circle), length / 0.3 + 0.3 / 0.5, 0.01 * length / 0.3);
  // Radius 2: speed is the limit.
  EXPECT_NEAR(mission(arc({0, 0}, 2, 0, 2 * kPi, chords(2, 2 * kPi, 1))), 4 * kPi / 0.5 + 1, 0.05);
}

TEST(Mission, SamplingHardlyMatters) {
  for (const double r : {0.1, 0.2, 0.5, 2.0}) {
    SCOPED_TRACE(r);
    const double fine = mission(rounded_rectangle(9, 6, r, 0.0005));
    for (const double share : {1.0, 0.3, 0.1, 0.01})
      EXPECT_NEAR(mission(rounded_rectangle(9, 6, r, share)), fine, 0.01 * fine);
  }
  const double fine = mission(spiral(0.1, 0.06, 8, 0.0005));
  for (const double share : {1.0, 0.1, 0.01}) EXPECT_NEAR(mission(spiral(0.1, 0.06, 8, share)), fine, 0.01 * fine);
}

TEST(Mission, TooTightIsAStopButOnlyAtItsEnds) {
  Robot car;
  car.min_turn_radius = 1;
  const Problem p(Map{"plain", box_region({-100, -100}, {100, 100}), "test", "test"}, car, Point(0, 0));
  const auto time = [&](double r, double share) {
    return value("mission_s", work(rounded_rectangle(9, 8, r, share)), p);
  };
  EXPECT_NEAR(time(2, 1), mission(rounded_rectangle(9, 8, 2, 1)), 1e-9);
  EXPECT_GT(time(0.5, 1), mission(rounded_rectangle(9, 8, 0.5, 1)) + 4);
  EXPECT_NEAR(time(0.5, 1), time(0.5, 0.01), 0.01 * time(0.5, 0.01));
  EXPECT_NEAR(time(0.5, 0.3), time(0.5, 0.01), 0.01 * time(0.5, 0.01));
}

TEST(Mission, NeverFasterThanFullSpeed) {
  Rng rng(4);
  for (int k = 0; k < 100; ++k) {
    const Path path = random_walk(rng, Box{{-9, -9}, {9, 9}}, 3, 10, k % 2 ? 3 : 0.1);
    const double t = value("mission_s", path, plain());
    EXPECT_GE(t, path.length() / 0.5);
    EXPECT_LT(t, 1e4);
  }
}

}  // namespace
}  // namespace oxturn

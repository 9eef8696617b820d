// turns, turn_rad, mission_s: by hand, and the same however finely a curve is sampled.
#include <gtest/gtest.h>

#include <functional>

#include "metrics/score.hpp"
#include "shapes.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kTool = 0.4;  // speed 0.5 m/s, acceleration 0.5 m/s^2, turn rate 1.5 rad/s by default

Problem plain() { return problem_in(box_region({-100, -100}, {100, 100}), {0, 0}, 0.2, kTool); }

double value(const std::string& metric, const Path& path, const Problem& p) {
  for (const Metric& m : built_in_metrics()) {
    if (m.name != metric) continue;
    const SweptArea none;
    const MissionClock clock(p, path);
    return m.compute(Scored{p, path, none, 0, nullptr, &clock, p.tolerance(), {}, {}}).value();
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

/// Arcs and straight pieces that continue in each other's tangents, the same for every `share`.
Polyline smooth_curve(std::uint64_t seed, double share) {
  Rng rng(seed);
  Polyline line{{0, 0}};
  double heading = 0;
  for (int k = 0; k < 12; ++k) {
    const Point from = line.back();
    if (rng.chance(0.4)) {
      line.push_back(from + rotated({rng.between(0.5, 3.0), 0}, heading));
      continue;
    }
    const double r = std::pow(10, rng.between(-1.3, 0.7)), angle = rng.between(0.4, 3.0) * (rng.chance(0.5) ? 1 : -1);
    const double side = angle > 0 ? 1 : -1;
    const Point centre = from + rotated({0, side * r}, heading);
    const double first = heading - side * kPi / 2;
    for (const Point& p : arc(centre, r, first, first + angle, chords(r, angle, share)))
      if (distance(p, line.back()) > 1e-9) line.push_back(p);
    heading += angle;
  }
  return line;
}

TEST(Turns, RandomSmoothCurvesHoweverFine) {
  for (const auto seed : seeds(100)) {
    SCOPED_TRACE(seed);
    const Polyline fine = smooth_curve(seed, 0.001);
    for (const double share : {1.0, 0.4, 0.1, 0.01}) {
      const Polyline line = smooth_curve(seed, share);
      EXPECT_EQ(turns(line), turns(fine)) << share;
      EXPECT_NEAR(turn_rad(line), turn_rad(fine), 0.01 * turn_rad(fine)) << share;
      EXPECT_NEAR(mission(line), mission(fine), 0.01 * mission(fine)) << share;
    }
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

TEST(Mission, ThereAndBackTurnsOnTheSpot) {
  EXPECT_NEAR(mission({{0, 0}, {40, 0}, {0, 0}}), 2 * (40 / 0.5 + 1) + kPi / 1.5, 1e-3 * 164);
  EXPECT_NEAR(mission({{0, 0}, {90, 0}, {20, 0}, {90, 0}, {0, 0}}), 2 * 181 + 2 * 141 + 3 * kPi / 1.5, 1e-3 * 644);
}

// By numerical integration of the model for one corner: fine steps along the smoothed corner in closed form.
double corner_by_fine_steps(double arm, double angle, const Robot& robot) {
  const double h = robot.tool_width / 10;
  const int n = 200000;
  std::vector<double> length(n), top(n + 1);
  for (int i = 0; i <= n; ++i) {
    const double t = -1 + 2.0 * i / n;                                              // position in 2 h
    const double part = t < 0 ? (1 + t) * (1 + t) / 2 : 1 - (1 - t) * (1 - t) / 2;  // of the second heading
    const double rate = (1 - std::abs(t)) / (2 * h);
    const Point first = (1 - part) * Point(1, 0) + part * rotated({1, 0}, angle);
    const Point second = rate * (rotated({1, 0}, angle) - Point(1, 0));
    const double turning = std::abs(cross(first, second)) / first.squaredNorm();
    top[i] = std::min(robot.speed, turning > 0 ? robot.turn_rate * first.norm() / turning : robot.speed);
    if (i < n) length[i] = 4 * h / n * first.norm();
  }
  for (int i = n / 2; i < n; ++i)
    top[i + 1] = std::min(top[i + 1], std::sqrt(top[i] * top[i] + 2 * robot.acceleration * length[i]));
  for (int i = n; i > n / 2; --i)
    top[i - 1] = std::min(top[i - 1], std::sqrt(top[i] * top[i] + 2 * robot.acceleration * length[i - 1]));
  for (int i = n / 2; i-- > 0;)
    top[i] = std::min(top[i], std::sqrt(top[i + 1] * top[i + 1] + 2 * robot.acceleration * length[i]));
  double time = 0;
  for (int i = 0; i < n; ++i) time += 2 * length[i] / (top[i] + top[i + 1]);
  const double ramp = (2 * robot.speed - top[0]) / robot.acceleration;
  const double ramps = (2 * robot.speed * robot.speed - top[0] * top[0]) / (2 * robot.acceleration);
  return time + 2 * (ramp + (arm - 2 * h - ramps) / robot.speed);
}

// In reverse the heading is opposite to the motion: there and back without a turn, but with a stop.
TEST(Mission, AChangeOfGearIsAStopAndNoTurn) {
  const Problem p = plain();
  const Path there_and_back{{Leg{true, {{0, 0}, {5, 0}}}, Leg{true, {{5, 0}, {1, 0}}, Gear::reverse}}};
  EXPECT_EQ(value("turns", there_and_back, p), 0);
  EXPECT_EQ(value("turn_rad", there_and_back, p), 0);
  EXPECT_NEAR(value("mission_s", there_and_back, p), mission({{0, 0}, {5, 0}}) + mission({{0, 0}, {4, 0}}), 1e-6);
  const MissionClock clock(p, there_and_back);
  EXPECT_NEAR(clock.at(5), mission({{0, 0}, {5, 0}}), 1e-6);
  EXPECT_NEAR(clock.at(9), clock.total(), 1e-9);
  // Onwards in reverse: turned round at rest.
  const Path onwards{{Leg{true, {{0, 0}, {5, 0}}}, Leg{true, {{5, 0}, {9, 0}}, Gear::reverse}}};
  EXPECT_EQ(value("turns", onwards, p), 1);
  EXPECT_NEAR(value("mission_s", onwards, p), value("mission_s", there_and_back, p) + kPi / p.robot().turn_rate, 1e-6);
  // All of it in reverse: the same as forwards.
  const Polyline bent{{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  const Path backwards{{Leg{true, bent, Gear::reverse}}};
  for (const char* metric : {"turns", "turn_rad", "mission_s"})
    EXPECT_EQ(value(metric, backwards, p), value(metric, work(bent), p)) << metric;
}

TEST(Mission, OneCornerByFineSteps) {
  const Robot robot;
  for (const double angle : {0.05, 0.3, 1.0, kPi / 2, 2.0, 2.5, 3.0}) {
    const Point end = Point(4, 0) + rotated({4, 0}, angle);
    const double truth = corner_by_fine_steps(4, angle, robot);
    EXPECT_NEAR(mission({{0, 0}, {4, 0}, end}), truth, (angle < 2.9 ? 1e-3 : 1.5e-3) * truth) << angle;
  }
}

TEST(Mission, CirclesAtTheTurnRate) {
  // Radius 0.2: 1.5 rad/s allows 0.3 m/s. Twenty laps, so that the ramps hardly count.
  const double laps = 20, length = 2 * kPi * 0.2 * laps;
  const Polyline circle = arc({0, 0}, 0.2, 0, 2 * kPi * laps, chords(0.2, 2 * kPi * laps, 1));
  EXPECT_NEAR(mission(circle), length / 0.3 + 0.3 / 0.5, 0.02 * length / 0.3) << "the smoothing cuts 1.4 % off";
  // Radius 2: speed is the limit.
  EXPECT_NEAR(mission(arc({0, 0}, 2, 0, 2 * kPi, chords(2, 2 * kPi, 1))), 4 * kPi / 0.5 + 1, 1e-3 * 26);
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

// Radius 0.5 for a robot that needs 1: half of each quarter turn is made up at rest.
TEST(Mission, TooTightIsTurnedAtRest) {
  Robot car;
  car.min_turn_radius = 1;
  const Problem p(Map{"plain", box_region({-100, -100}, {100, 100}), "test", "test"}, car, Point(0, 0));
  const auto time = [&](double r, double share) {
    return value("mission_s", work(rounded_rectangle(9, 8, r, share)), p);
  };
  EXPECT_NEAR(time(2, 1), mission(rounded_rectangle(9, 8, 2, 1)), 1e-9);
  for (const double share : {1.0, 0.3, 0.01})
    EXPECT_NEAR(time(0.5, share), mission(rounded_rectangle(9, 8, 0.5, share)) + 4 * kPi / 4 / 1.5, 0.2);
  EXPECT_NEAR(time(0.999, 0.1), time(1.001, 0.1), 0.1) << "no jump";
}

TEST(Mission, AboutAtFullSpeedAtMost) {
  Rng rng(4);
  for (int k = 0; k < 100; ++k) {
    const Path path = random_walk(rng, Box{{-9, -9}, {9, 9}}, 3, 10, k % 2 ? 3 : 0.1);
    const MissionClock clock(plain(), path);
    const double t = clock.total(), length = path.length();
    if (k % 2) { EXPECT_GE(t, (length - 0.08 * 30) / 0.5); }  // corners are cut by at most 4 h / 3 each
    EXPECT_LT(t, 1e4);
    double last = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double now = clock.at(length * i / 1000);
      EXPECT_GE(now, last);
      last = now;
    }
    EXPECT_NEAR(last, t, 1e-6);
    EXPECT_EQ(clock.at(length + 1), t);
  }
}

/// Steps of at least half a tool width.
Polyline spaced_walk(Rng& rng, int n) {
  Polyline line{{0, 0}};
  for (int k = 0; k < n; ++k)
    line.push_back(line.back() + rotated({rng.between(kTool / 2, 3.0), 0}, rng.between(-kPi, kPi)));
  return line;
}

TEST(Mission, PointsOnStraightLinesChangeNothing) {
  for (const auto seed : seeds(50)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Polyline line = spaced_walk(rng, 20);
    line.push_back(line[line.size() - 2]);  // there and back
    Polyline dense{line[0]};
    for (std::size_t i = 1; i < line.size(); ++i) {
      const int n = 2 + static_cast<int>(rng.below(49));
      for (int k = 1; k <= n; ++k) dense.push_back(k == n ? line[i] : lerp(line[i - 1], line[i], k / (n + 0.0)));
    }
    EXPECT_NEAR(mission(dense), mission(line), 1e-6 * mission(line));
  }
}

TEST(Mission, AMillimetreIsAMillimetre) {
  for (const auto seed : seeds(100)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Polyline line = spaced_walk(rng, 20);
    if (seed % 3 == 0)
      for (std::size_t k = 2; k < line.size(); k += 2) line[k] = line[k - 2];  // reversals
    Polyline shaken = line;
    for (Point& p : shaken) p += rotated({rng.between(0.0, 0.001), 0}, rng.between(-kPi, kPi));
    EXPECT_NEAR(mission(shaken), mission(line), 0.01 * mission(line));
  }
}

TEST(Mission, ACornerIsASmallArc) {
  for (const double angle : {0.3, 0.9, kPi / 2, 2.2, 3.0, kPi}) {
    SCOPED_TRACE(angle);
    const double arm = angle < kPi ? 3 : 15;  // a U-turn of this size begins to turn while it brakes: 0.4 s less
    const Point end = rotated({arm, 0}, angle);
    const double corner = mission({{-arm, 0}, {0, 0}, end});
    for (const int n : {1, 3, 10, 100}) {
      const double r = kTool / 100;  // of an arc that begins with heading 0 and ends with `angle`
      Polyline line{{-arm, 0}};
      append(line, arc({0, r}, r, -kPi / 2, angle - kPi / 2, n));
      line.push_back(line.back() + end);
      EXPECT_NEAR(mission(line), corner, 0.01 * corner) << n;
    }
  }
}

TEST(Mission, MillimetreSteps) {
  Polyline few, many;
  const auto at = [](double m) { return Point(0.9 * m, 3 * std::sin(m / 8)); };
  for (int k = 0; k <= 100; ++k) few.push_back(at(k));
  for (int k = 0; k < 100; ++k)
    for (int i = 0; i < 1000; ++i) many.push_back(lerp(few[k], few[k + 1], i / 1000.0));
  many.push_back(few.back());
  EXPECT_NEAR(mission(many), mission(few), 0.01 * mission(few));
  many.clear();
  for (int k = 0; k <= 100000; ++k) many.push_back(at(k / 1000.0));
  EXPECT_NEAR(mission(many), mission(few), 0.01 * mission(few));
}

}  // namespace
}  // namespace oxturn

// Times against a plain forward and backward pass over all samples, with windows far shorter and far longer than the
// braking distance.
#include "metrics/drive_times.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using Samples = std::vector<DriveTimes::Sample>;

/// Seconds at each sample.
std::vector<double> reference(const Robot& robot, const Samples& samples) {
  const double a = robot.acceleration;
  std::vector<double> speed, at{0};
  for (const auto& s : samples) speed.push_back(s.at_rest ? 0 : s.limit);
  for (std::size_t i = 1; i < speed.size(); ++i)
    speed[i] = std::min(speed[i], std::sqrt(speed[i - 1] * speed[i - 1] + 2 * a * samples[i - 1].length));
  for (std::size_t i = speed.size() - 1; i-- > 0;)
    speed[i] = std::min(speed[i], std::sqrt(speed[i + 1] * speed[i + 1] + 2 * a * samples[i].length));
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double top = std::max(samples[i].limit, samples[i + 1].limit), length = samples[i].length;
    const auto speed_at = [&](double s) {
      return std::min({top, std::sqrt(speed[i] * speed[i] + 2 * a * s),
                       std::sqrt(speed[i + 1] * speed[i + 1] + 2 * a * (length - s))});
    };
    // Up to the top speed or until it must brake, at the top speed, down: each at a constant acceleration.
    const double up = (top * top - speed[i] * speed[i]) / (2 * a);
    const double down = length - (top * top - speed[i + 1] * speed[i + 1]) / (2 * a);
    const double peak = length / 2 + (speed[i + 1] * speed[i + 1] - speed[i] * speed[i]) / (4 * a);
    double seconds = 0, from = 0;
    for (double to : {std::min(up, peak), std::max(down, peak), length}) {
      to = std::clamp(to, from, length);
      if (to > from) seconds += 2 * (to - from) / (speed_at(from) + speed_at(to));
      from = to;
    }
    double driving = samples[i].turn;
    if (robot.min_turn_radius > 0) driving = std::min(driving, length / robot.min_turn_radius);
    at.push_back(at.back() + std::max(seconds, driving / robot.turn_rate) +
                 (samples[i].turn - driving) / robot.turn_rate);
  }
  return at;
}

Samples random_samples(Rng& rng, const Robot& robot, int count, double longest) {
  Samples samples;
  double path_m = 0;
  for (int i = 0; i < count; ++i) {
    const bool rests = i == 0 || i + 1 == count || rng.chance(0.01);
    const double length = i + 1 == count || (rests && i > 0 && rng.chance(0.5)) ? 0 : longest * rng.unit() * rng.unit();
    samples.push_back({path_m, robot.speed * (rng.chance(0.5) ? 1 : 0.01 + 0.99 * rng.unit()), length,
                       rng.chance(0.5) ? 0 : 0.2 * rng.unit(), rests});
    path_m += length;
  }
  return samples;
}

TEST(DriveTimes, AreThoseOfTwoPassesOverAllSamples) {
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Robot robot;
    robot.acceleration = std::pow(10, rng.between(-5.0, 1.0));  // brakes within 12.5 km to 1 cm
    robot.min_turn_radius = rng.chance(0.5) ? 0 : 0.3;
    const Samples samples = random_samples(rng, robot, rng.between(2, 6000), std::pow(10, rng.between(-2.0, 1.0)));
    const std::vector<double> truth = reference(robot, samples);
    DriveTimes times(robot, 0.2);
    for (const auto& s : samples) times.add(s);
    times.finish();
    EXPECT_NEAR(times.total(), truth.back(), 1e-9 * truth.back());
    double before = 0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const double now = times.at(samples[i].path_m);
      ASSERT_GE(now, before);
      before = now;
      // Between samples closer than the step, times are interpolated.
      const bool kept = i > 0 && samples[i].path_m - samples[i - 1].path_m >= 0.2;
      if (kept) { ASSERT_NEAR(now, truth[i], 1e-9 * truth.back() + 1e-9) << i; }
    }
    EXPECT_EQ(times.at(samples.back().path_m), times.total());
  }
}

TEST(DriveTimes, OfNothing) {
  DriveTimes times(Robot{}, 0.2);
  times.finish();
  EXPECT_EQ(times.total(), 0);
  EXPECT_EQ(times.at(1), 0);
}

/// A stop takes its time where it is, not over the step about it.
TEST(DriveTimes, TurnsAtRest) {
  Robot robot;
  robot.speed = robot.acceleration = 0.5;
  robot.turn_rate = 1;
  DriveTimes times(robot, 0.2);
  times.add({0, 0.5, 1, 0, true});
  times.add({1, 0.5, 0, 0, true});
  times.turn_at_rest(2);
  times.add({1, 0.5, 0.1, 0, true});
  times.add({1.1, 0.5, 0.1, 0});
  times.add({1.2, 0.5, 0.8, 0});
  times.add({2, 0.5, 0, 0, true});
  times.finish();
  EXPECT_NEAR(times.at(1), 3, 1e-12);
  EXPECT_NEAR(times.at(1.0625), 5.5, 1e-12);
  EXPECT_NEAR(times.total(), 8, 1e-12);
}

}  // namespace
}  // namespace oxturn

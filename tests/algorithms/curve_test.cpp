// Dubins and Reeds-Shepp curves: ends, tangents and lengths on random poses, against closed forms.
#include "algorithms/smoothing/curve.hpp"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/random.hpp"
#include "tests/support/dubins.hpp"

namespace oxturn {
namespace {

double end_error(const Curve& curve) {
  Pose at = curve.from;
  for (const CurvePiece& piece : curve.pieces) at = after(at, piece, curve.radius);
  return std::max(distance(at.at, curve.to.at) / curve.radius,
                  std::abs(std::remainder(at.heading - curve.to.heading, 2 * kPi)));
}

/// Distances from 1e-6 to 20 radii, headings random, aligned or opposite.
struct RandomPoses {
  explicit RandomPoses(Rng& rng) {
    radius = std::exp(rng.between(-2.0, 3.0));
    const double d = radius * (rng.chance(0.5) ? rng.between(0.0, 6.0) : std::exp(rng.between(-14.0, 3.0)));
    const double theta = rng.between(-kPi, kPi);
    const auto heading = [&] { return rng.chance(0.2) ? theta + kPi * rng.between(-1, 2) : rng.between(-9.0, 9.0); };
    from = {{rng.between(-50.0, 50.0), rng.between(-50.0, 50.0)}, heading()};
    to = {from.at + d * direction({{0, 0}, theta}), heading()};
  }
  double radius;
  Pose from, to;
};

TEST(Curve, MillionDubinsCurvesEndInTheirPoseAndAreAsLongAsTheClosedForm) {
  Rng rng(1);
  for (int i = 0; i < 1000000; ++i) {
    const RandomPoses p(rng);
    const Curve curve = dubins_curve(p.from, p.to, p.radius);
    ASSERT_LT(end_error(curve), 1e-6) << i;
    if (distance(p.from.at, p.to.at) < 1e-5 * p.radius) continue;  // words swap within rounding
    const double oracle = dubins_length({p.from.at, p.from.heading}, {p.to.at, p.to.heading}, p.radius);
    ASSERT_NEAR(curve.length() / p.radius, oracle / p.radius, 1e-5) << i;
  }
}

/// Random headings only: OMPL 1.5.2 of Debian 12 aborts for some that are aligned.
TEST(Curve, DubinsCurvesAreAsLongAsOmpls) {
  Rng rng(6);
  const auto space = std::make_shared<ompl::base::DubinsStateSpace>(1.0);
  ompl::base::ScopedState<ompl::base::DubinsStateSpace> from(space), to(space);
  for (int i = 0; i < 200000; ++i) {
    from->setXY(0, 0);
    from->setYaw(rng.between(-kPi, kPi));
    to->setXY(rng.between(-6.0, 6.0), rng.between(-6.0, 6.0));
    to->setYaw(rng.between(-kPi, kPi));
    const Curve curve = dubins_curve({{0, 0}, from->getYaw()}, {{2 * to->getX(), 2 * to->getY()}, to->getYaw()}, 2);
    ASSERT_NEAR(curve.length() / 2, space->distance(from.get(), to.get()), 1e-5) << i;
  }
}

TEST(Curve, EachWordEndsInItsPose) {
  Rng rng(2);
  std::size_t words = 0;
  for (int i = 0; i < 100000; ++i) {
    const RandomPoses p(rng);
    if (distance(p.from.at, p.to.at) < 1e-5 * p.radius) continue;
    const DubinsWords all = dubins_words(p.from, p.to, p.radius);
    ASSERT_GE(all.count, 2u);
    for (const Word& word : all.all()) {
      const Curve curve = curve_of(word, p.from, p.to, p.radius);
      ASSERT_LT(end_error(curve), 1e-6) << i;
      ASSERT_NEAR(word.length, curve.length(), 1e-9 * p.radius) << i;
    }
    words += all.count;
  }
  EXPECT_GT(words, 300000u);
}

/// The least over curves of three arcs or lines in all gears, sampled: an upper bound that a shortest curve must reach.
double sampled_reeds_shepp(const Pose& from, const Pose& to) {
  double best = std::numeric_limits<double>::infinity();
  const Gear gears[] = {Gear::forward, Gear::reverse};
  for (const Steering first : {Steering::left, Steering::right})
    for (const Gear gear : gears)
      for (int k = 0; k <= 40; ++k) {
        const CurvePiece piece{first, k * kPi / 40, gear};
        // The rest forwards, or backwards as the mirrored problem.
        const Pose mid = after(from, piece, 1);
        best = std::min(best, piece.length + dubins_length({mid.at, mid.heading}, {to.at, to.heading}, 1));
        best = std::min(best, piece.length + dubins_length({mid.at, mid.heading + kPi}, {to.at, to.heading + kPi}, 1));
      }
  return best;
}

TEST(Curve, ReedsSheppEndsInItsPoseAndIsNoLongerThanAnyCurveTried) {
  Rng rng(3);
  for (int i = 0; i < 100000; ++i) {
    const RandomPoses p(rng);
    const Curve curve = reeds_shepp_curve(p.from, p.to, p.radius);
    ASSERT_LT(end_error(curve), 1e-6) << i;
    if (distance(p.from.at, p.to.at) < 1e-2 * p.radius) continue;  // OMPL drops words whose parts are tiny
    ASSERT_LE(curve.length(), dubins_curve(p.from, p.to, p.radius).length() + 1e-5 * p.radius) << i;
    if (i % 1000 != 0) continue;
    const Pose from{p.from.at / p.radius, p.from.heading}, to{p.to.at / p.radius, p.to.heading};
    ASSERT_LE(curve.length() / p.radius, sampled_reeds_shepp(from, to) + 1e-5) << i;
    ASSERT_NEAR(curve.length(), reeds_shepp_curve(p.to, p.from, p.radius).length(), 1e-5 * p.radius) << i;
  }
}

/// OMPL drops words whose parts are tiny, and some of aligned poses.
TEST(Curve, ReedsSheppCurvesAreAsLongAsOmpls) {
  Rng rng(7);
  const auto space = std::make_shared<ompl::base::ReedsSheppStateSpace>(1.0);
  ompl::base::ScopedState<ompl::base::ReedsSheppStateSpace> from(space), to(space);
  for (int i = 0; i < 200000; ++i) {
    from->setXY(0, 0);
    from->setYaw(rng.between(-kPi, kPi));
    to->setXY(rng.between(-6.0, 6.0), rng.between(-6.0, 6.0));
    to->setYaw(rng.between(-kPi, kPi));
    const Pose a{{0, 0}, from->getYaw()}, b{{2 * to->getX(), 2 * to->getY()}, to->getYaw()};
    ASSERT_NEAR(reeds_shepp_distance(a, b, 2) / 2, space->distance(from.get(), to.get()), 1e-6) << i;
    ASSERT_NEAR(reeds_shepp_curve(a, b, 2).length(), reeds_shepp_distance(a, b, 2), 1e-6) << i;
    ASSERT_EQ(reeds_shepp_word(a, b, 2).length, reeds_shepp_distance(a, b, 2)) << i;
  }
}

// Rounding must not hide the words without cusps, as between lanes.
TEST(Curve, ReedsSheppCurvesOfAlignedPosesAreNoLongerThanDubins) {
  Rng rng(8);
  for (int i = 0; i < 100000; ++i) {
    const double along = rng.between(-kPi, kPi);
    const auto turned = [&] { return along + kPi / 2 * std::floor(rng.between(-2.0, 2.0)); };
    const Pose from{{rng.between(-50.0, 50.0), rng.between(-50.0, 50.0)}, turned()};
    const Pose to{from.at + rng.between(0.0, 6.0) * direction({{0, 0}, along}), turned()};
    const double length = reeds_shepp_distance(from, to, 1);
    ASSERT_LE(length, dubins_distance(from, to, 1) + 1e-8) << i;
    ASSERT_LE(length, dubins_distance(turned_round(from), turned_round(to), 1) + 1e-8) << i;
  }
}

// Without position: the least length to turn by 90 degrees on the spot is known.
TEST(Curve, AnalyticCases) {
  EXPECT_NEAR(dubins_curve({{0, 0}, 0}, {{0, 8}, kPi}, 4).length(), 4 * kPi, 1e-6);
  EXPECT_NEAR(dubins_curve({{0, 0}, 0}, {{7, 0}, 0}, 4).length(), 7, 1e-6);
  EXPECT_NEAR(reeds_shepp_curve({{0, 0}, 0}, {{-7, 0}, 0}, 4).length(), 7, 1e-6);
  EXPECT_EQ(reeds_shepp_curve({{0, 0}, 0}, {{-7, 0}, 0}, 4).cusps(), 0u);
  // Lanes d = 3 < 2 R apart: bulb R (pi + 4 theta), cos theta = (2 R + d) / 4 R.
  EXPECT_NEAR(dubins_curve({{0, 0}, 0}, {{0, 3}, kPi}, 4).length(), 4 * (kPi + 4 * std::acos(11.0 / 16)), 1e-6);
  for (const double at : {0.0, 1e-9, -1e-9})
    EXPECT_LT(dubins_curve({{0, 0}, at}, {{1, 0}, -at}, 1).length(), 1.1) << "no circle more";
}

TEST(Curve, SamplesKeepTheChordErrorAndTheEnds) {
  Rng rng(4);
  for (int i = 0; i < 2000; ++i) {
    const RandomPoses p(rng);
    const double error = p.radius * std::exp(rng.between(-9.0, -2.0));
    for (const Curve& curve : {dubins_curve(p.from, p.to, p.radius), reeds_shepp_curve(p.from, p.to, p.radius)}) {
      const std::vector<Leg> legs = sampled(curve, error, false);
      double length = 0;
      for (const Leg& leg : legs) length += oxturn::length(leg.points);
      ASSERT_LE(length, curve.length() + 1e-5 * p.radius);
      ASSERT_GE(length, curve.length() * (1 - error / p.radius) - 1e-2 * p.radius);
      if (legs.empty()) continue;
      ASSERT_EQ(legs.front().points.front(), p.from.at);
      ASSERT_EQ(legs.back().points.back(), p.to.at);
      for (std::size_t k = 1; k < legs.size(); ++k) {
        ASSERT_EQ(legs[k].points.front(), legs[k - 1].points.back());
        ASSERT_NE(legs[k].gear, legs[k - 1].gear);
      }
    }
  }
}

TEST(Curve, OppositeLeadsBack) {
  Rng rng(5);
  for (int i = 0; i < 2000; ++i) {
    const RandomPoses p(rng);
    const Curve back = opposite(reeds_shepp_curve(p.from, p.to, p.radius));
    ASSERT_LT(end_error(back), 3e-6);
  }
}

}  // namespace
}  // namespace oxturn

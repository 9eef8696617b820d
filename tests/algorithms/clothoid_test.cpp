// Clothoids against fine sums, turns and words of continuous curvature on random poses.
#include "algorithms/smoothing/clothoid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/algorithms/curve_checks.hpp"

namespace oxturn {
namespace {

/// The midpoint rule, with 20,000 steps.
Pose summed(const Clothoid& c) {
  Pose at = c.from;
  const int n = 20000;
  const double h = c.length / n;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) * h;
    at.at += h * direction({{0, 0}, c.from.heading + s * (c.curvature + c.sharpness * s / 2)});
  }
  at.heading += c.length * (c.curvature + c.sharpness * c.length / 2);
  return at;
}

double pose_error(const Pose& a, const Pose& b) {
  return std::max(distance(a.at, b.at), std::abs(std::remainder(a.heading - b.heading, 2 * kPi)));
}

TEST(Clothoid, EndsWhereAFineSumDoes) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const Clothoid c{{{1, 2}, rng.between(-4.0, 4.0)},
                     rng.between(-2.0, 2.0),
                     rng.chance(0.2) ? 0 : rng.between(-3.0, 3.0),
                     rng.between(0.0, 4.0)};
    ASSERT_LT(pose_error(end_of(c), summed(c)), 1e-6) << i;
  }
}

/// Continuous pieces with a curvature that begins and ends at zero and keeps its limits.
void check(const std::vector<Clothoid>& pieces, const TurnShape& shape) {
  double curvature = 0;
  Pose at = pieces.front().from;
  for (const Clothoid& piece : pieces) {
    ASSERT_LT(pose_error(at, piece.from), 1e-9);
    ASSERT_NEAR(piece.curvature * shape.radius(), curvature * shape.radius(), 1e-9);
    ASSERT_LE(std::abs(piece.sharpness), shape.sharpness() * (1 + 1e-9));
    ASSERT_GE(piece.length, 0);
    curvature = piece.curvature + piece.sharpness * piece.length;
    ASSERT_LE(std::abs(curvature) * shape.radius(), 1 + 1e-9);
    at = end_of(piece);
  }
  ASSERT_NEAR(curvature * shape.radius(), 0, 1e-9);
}

double random_sharpness(Rng& rng, double radius) {
  return rng.chance(0.3) ? 0 : std::exp(rng.between(std::log(1 / kPi) + 1e-9, 4.0)) / (radius * radius);
}

TEST(Clothoid, TurnsBeginAndEndOnTheSameCircle) {
  Rng rng(2);
  for (int i = 0; i < 100000; ++i) {
    const double radius = std::exp(rng.between(-2.0, 3.0));
    const TurnShape shape(radius, random_sharpness(rng, radius));
    const double exponent = rng.between(-16.0, std::log(2 * kPi));
    const double deflection =
        (rng.chance(0.5) ? 1 : -1) * (rng.chance(0.5) ? std::exp(exponent) : rng.between(0.0, 6.28));
    const Pose from{{3, 4}, rng.between(-4.0, 4.0)};
    const std::vector<Clothoid> turn = shape.turn(from, deflection);
    check(turn, shape);
    if (HasFatalFailure()) return;
    const Pose end = end_of(turn.back());
    ASSERT_LT(std::abs(std::remainder(end.heading - from.heading - deflection, 2 * kPi)), 1e-9) << i;
    const double sense = deflection < 0 ? -1 : 1;
    const auto centre = [&](const Pose& pose, double forward) {
      return Point(ahead(pose, forward * shape.centre().x()).at +
                   sense * shape.centre().y() * perpendicular(direction(pose)));
    };
    ASSERT_LT(distance(centre(from, 1), centre(end, -1)), 1e-9 * (1 + radius)) << i;
  }
}

TEST(Clothoid, WordsEndInTheirPoseAndThereIsAlwaysOne) {
  Rng rng(3);
  for (int i = 0; i < 50000; ++i) {
    const RandomConnection p(rng);
    const TurnShape shape(p.radius, random_sharpness(rng, p.radius));
    const auto words = continuous_dubins_words(p.from, p.to, shape);
    ASSERT_FALSE(words.empty()) << i;
    for (std::size_t k = 0; k < words.size(); ++k) {
      check(words[k], shape);
      if (HasFatalFailure()) return;
      const Pose end = end_of(words[k].back());
      ASSERT_LT(distance(end.at, p.to.at), 1e-6 * p.radius) << i;
      ASSERT_LT(std::abs(std::remainder(end.heading - p.to.heading, 2 * kPi)), 1e-8) << i;
      if (k > 0) { ASSERT_LE(length(words[k - 1]), length(words[k])); }
    }
    ASSERT_GE(length(words.front()), dubins_curve(p.from, p.to, p.radius).length() - 1e-6 * p.radius) << i;
  }
}

// The sharper, the nearer to Dubins curves.
TEST(Clothoid, GreatSharpnessGivesDubinsCurves) {
  Rng rng(4);
  const TurnShape shape(1, 1e7);
  for (int i = 0; i < 2000; ++i) {
    const Pose from{{0, 0}, rng.between(-3.0, 3.0)}, to{{rng.between(4.5, 20.0), 0}, rng.between(-3.0, 3.0)};
    const double dubins = dubins_curve(from, to, 1).length();
    ASSERT_NEAR(length(continuous_dubins_words(from, to, shape).front()), dubins, 1e-3) << i;
  }
}

TEST(Clothoid, CornersTouchBothLinesAtTheTangentLength) {
  Rng rng(5);
  for (int i = 0; i < 20000; ++i) {
    const double radius = std::exp(rng.between(-2.0, 3.0)), deflection = rng.between(-3.0, 3.0);
    if (std::abs(deflection) < 1e-6) continue;
    const TurnShape shape(radius, random_sharpness(rng, radius));
    const double tangent = shape.tangent_length(deflection);
    const std::vector<Clothoid> corner = shape.corner({{-tangent, 0}, 0}, deflection);
    check(corner, shape);
    if (HasFatalFailure()) return;
    ASSERT_LT(pose_error(end_of(corner.back()), {ahead({{0, 0}, deflection}, tangent).at, deflection}),
              1e-9 * (1 + tangent));
    double nearest = 1e300, half = length(corner) / 2;
    for (const Clothoid& piece : corner) {
      if (half <= piece.length) {
        nearest = pose_at(piece, half).at.norm();
        break;
      }
      half -= piece.length;
    }
    ASSERT_NEAR(shape.deviation(deflection), nearest, 1e-9 * (1 + nearest)) << i;
  }
}

TEST(Clothoid, TooLittleSharpnessIsRefused) {
  EXPECT_NEAR(TurnShape(1).outer_radius(), 1.04, 0.01);
  EXPECT_NO_THROW(TurnShape(2, 1 / (4 * kPi)));
  EXPECT_THROW(TurnShape(2, 0.99 / (4 * kPi)), std::invalid_argument);
  EXPECT_THROW(TurnShape(0), std::invalid_argument);
  EXPECT_THROW(TurnShape(-1, 5), std::invalid_argument);
}

}  // namespace
}  // namespace oxturn

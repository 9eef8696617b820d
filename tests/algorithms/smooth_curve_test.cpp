// Bézier curves and the sampling of smooth curves.
#include "algorithms/smoothing/smooth_curve.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/algorithms/curve_checks.hpp"

namespace oxturn {
namespace {

Point de_casteljau(std::vector<Point> points, double t) {
  while (points.size() > 1) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = lerp(points[i], points[i + 1], t);
    points.pop_back();
  }
  return points.front();
}

TEST(Bezier, PositionsVelocitiesAndCurvaturesAreThoseOfDeCasteljau) {
  Rng rng(1);
  for (int i = 0; i < 2000; ++i) {
    Bezier curve;
    for (auto n = 2 + rng.below(6); n > 0; --n)
      curve.points.emplace_back(rng.between(-3.0, 3.0), rng.between(-3.0, 3.0));
    const double t = rng.between(0.01, 0.99), h = 1e-4;
    const Point before = de_casteljau(curve.points, t - h), at = de_casteljau(curve.points, t);
    const Point after = de_casteljau(curve.points, t + h);
    ASSERT_LT(distance(position_at(curve, t), at), 1e-12);
    ASSERT_LT(distance(velocity_at(curve, t), (after - before) / (2 * h)), 1e-4);
    if (velocity_at(curve, t).norm() < 0.5) continue;
    const Point velocity = (after - before) / (2 * h), acceleration = (after - 2 * at + before) / (h * h);
    const double curvature = cross(velocity, acceleration) / std::pow(velocity.norm(), 3);
    ASSERT_NEAR(curvature_at(curve, t), curvature, 1e-2 * (1 + std::abs(curvature)));
  }
}

TEST(Bezier, GreatestCurvatureIsNotBelowThatOfManySamples) {
  Rng rng(2);
  for (int i = 0; i < 300; ++i) {
    const RandomConnection p(rng);
    const Bezier curve = quintic_connection(p.from, p.to, p.radius);
    double most = 0;
    for (int k = 0; k <= 3000; ++k) most = std::max(most, std::abs(curvature_at(curve, k / 3000.0)));
    // Near a cusp it is but known to be large.
    ASSERT_GE(largest_curvature(curve), most * (most * p.radius < 3 ? 1 - 1e-3 : 0.3)) << i;
  }
}

TEST(Bezier, QuinticBeginsAndEndsWithoutCurvatureAndBeatsOtherHandles) {
  Rng rng(3);
  for (int i = 0; i < 300; ++i) {
    const RandomConnection p(rng);
    const double d = distance(p.from.at, p.to.at);
    const Bezier curve = quintic_connection(p.from, p.to, p.radius);
    ASSERT_NEAR(curvature_at(curve, 0) * p.radius, 0, 1e-6);
    ASSERT_NEAR(curvature_at(curve, 1) * p.radius, 0, 1e-6);
    if (d < p.radius) continue;
    for (const double h : {d / 8, d / 4, d / 2, d, d + 4 * p.radius}) {
      const Bezier other{{p.from.at, ahead(p.from, h).at, ahead(p.from, 2 * h).at, ahead(p.to, -2 * h).at,
                          ahead(p.to, -h).at, p.to.at}};
      if (largest_curvature(other) * p.radius > 3) continue;  // near a cusp
      ASSERT_LE(largest_curvature(curve), 1.1 * largest_curvature(other) + 1e-9) << i << ' ' << h / d;
    }
  }
}

TEST(Bezier, CubicOfAQuarterCircle) {
  const Bezier arc = cubic_connection({{0, 0}, 0}, {{1, 1}, kPi / 2}, 0.5522847498);
  EXPECT_NEAR(length(arc), kPi / 2, 1e-3);
  EXPECT_NEAR(largest_curvature(arc), 1, 0.03);
}

/// The largest distance of finely sampled points from the chords.
double chord_error(const SmoothCurve& fine, const Polyline& chords) {
  double largest = 0;
  for (const Point& p : sampled(fine, 1e-7)) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < chords.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(p, chords[i - 1], chords[i]));
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(SampledCurve, SamplesKeepTheChordError) {
  Rng rng(4);
  for (int i = 0; i < 20; ++i) {
    const Pose from{{0, 0}, rng.between(-3.0, 3.0)}, to{{rng.between(0.5, 5.0), 0}, rng.between(-3.0, 3.0)};
    const double error = std::exp(rng.between(-8.0, -3.0));
    const SmoothCurve dubins = smooth_curve(dubins_curve(from, to, 1));
    const SmoothCurve quintic{from, to, {quintic_connection(from, to, 1)}};
    const auto word = continuous_dubins_words(from, to, TurnShape(1)).front();
    const SmoothCurve clothoids{from, to, {word.begin(), word.end()}};
    for (const SmoothCurve& curve : {dubins, quintic, clothoids}) {
      const Polyline line = sampled(curve, error);
      ASSERT_LE(chord_error(curve, line), error * (1 + 1e-6) + 2e-7) << i;
      ASSERT_EQ(line.front(), from.at);
      ASSERT_EQ(line.back(), to.at);
      ASSERT_NEAR(oxturn::length(sampled(curve, 1e-7)), length(curve), 1e-5 * length(curve)) << i;
      for (std::size_t k = 1; k < line.size(); ++k) ASSERT_GT(distance(line[k - 1], line[k]), 0);
    }
    ASSERT_NEAR(largest_curvature(dubins), 1, 1e-12);
  }
}

TEST(SampledCurve, NoReverseAndNoLength) {
  EXPECT_THROW(smooth_curve(reeds_shepp_curve({{0, 0}, 0}, {{-2, 0}, 0}, 1)), std::invalid_argument);
  const SmoothCurve none{{{1, 2}, 0}, {{1, 2}, 0}, {}};
  EXPECT_EQ(length(none), 0);
  EXPECT_EQ(sampled(none, 1e-3).size(), 2u);
}

TEST(SampledCurve, EvenSamplesAreEven) {
  const Polyline line{{0, 0}, {3, 0}, {3, 0.5}, {3, 0.5}, {3, 1}};
  const Polyline even = evenly_sampled(line, 0.3);
  ASSERT_EQ(even.size(), 15u);
  EXPECT_EQ(even.front(), line.front());
  EXPECT_EQ(even.back(), line.back());
  for (std::size_t i = 1; i < 11; ++i) EXPECT_NEAR(distance(even[i - 1], even[i]), 4.0 / 14, 1e-12);
  EXPECT_NEAR(even[13].y(), 1 - 4.0 / 14, 1e-12);
  EXPECT_EQ(evenly_sampled({{1, 1}}, 0.1).size(), 1u);
}

}  // namespace
}  // namespace oxturn

// Concave chains by brute force: no point of the polygon is too far from the chain's edges, and every point that only
// the chain can cover is in the polygon.
#include "geometry/overlay/concave_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/geometry/samples.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

LatticePoint rounded(const Point& p) {
  return {static_cast<std::int32_t>(std::lround(p.x())), static_cast<std::int32_t>(std::lround(p.y()))};
}
Point point(const LatticePoint& s) { return {static_cast<double>(s.x), static_cast<double>(s.y)}; }

/// A chain that bends left at every vertex, by less than three quarters of a turn in all.
std::vector<LatticePoint> bent_chain(Rng& rng) {
  const int kind = rng.between(0, 3), n = rng.between(4, 40);
  const double size = std::pow(10.0, rng.between(3.0, 7.0)), total = rng.between(0.2, 4.5);
  Point at(rng.between(-1e6, 1e6), rng.between(-1e6, 1e6));
  double heading = rng.between(0.0, 2 * kPi);
  std::vector<LatticePoint> out{rounded(at)};
  for (int k = 0; k < n; ++k) {
    double length = size, bend = total / n;
    if (kind == 1) length *= rng.between(0.05, 1.0);                                             // uneven edges
    if (kind == 2) length *= std::pow(rng.between(0.5, 1.0), k), bend *= rng.between(0.5, 1.0);  // a spiral inwards
    if (kind == 3) length *= rng.chance(0.2) ? 20 : 0.5, bend *= rng.between(0.01, 1.0);         // arcs between walls
    at += length * Point(std::cos(heading), std::sin(heading));
    heading += bend;
    if (const LatticePoint s = rounded(at); s != out.back()) out.push_back(s);
  }
  return out;
}

double winding(const std::vector<Point>& ring, const Point& p) {
  double sum = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    sum += std::atan2(cross(ring[j] - p, ring[i] - p), (ring[j] - p).dot(ring[i] - p));
  return sum / (2 * kPi);
}

double distance_to_boundary(const std::vector<Point>& ring, const Point& p) {
  double best = 1e300;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    best = std::min(best, distance_to_segment(p, ring[j], ring[i]));
  return best;
}

TEST(ConcaveChain, CoversWhatIsNearItsEdgesAndNothingBeyondTheReach) {
  std::size_t trials = 0, longer = 0, covered = 0;
  for (const auto seed : seeds(3000)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<LatticePoint> points = bent_chain(rng);
    const double side = rng.chance(0.5) ? 1 : -1;
    if (side < 0)
      for (LatticePoint& s : points) s.x = -s.x;  // now it bends to the right
    const Walk walk(points, side);
    const std::size_t n = points.size();
    std::size_t begin = 1, limit = 1;  // the closing edge is not part of the chain
    while (limit + 2 < n && walk.bend[limit] > 0 && walk.bend[limit + 1] > 0) ++limit;
    double radius = 0;  // of the curve, approximately
    for (std::size_t i = begin; i < limit; ++i)
      radius = std::max(radius, walk.length[i] / std::max(walk.bend[i], 1e-6));
    const double reach = rng.chance(0.3) ? radius : radius * std::pow(10.0, rng.between(-1.5, 1.0));
    if (reach > 1e8 || reach < 100) continue;
    while (begin < limit) {
      const ConcaveChain chain = longest_concave_chain(walk, begin, limit, reach);
      ASSERT_GT(chain.end, begin);
      ASSERT_LE(chain.end, limit);
      ++trials;
      if (chain.end > begin + 1) ++longer;
      std::vector<Point> ring, edges;
      for (std::size_t i = chain.begin; i <= chain.end; ++i) edges.push_back(point(points[i]));
      ring.assign(edges.rbegin(), edges.rend());
      ring.insert(ring.end(), chain.far.begin(), chain.far.end());
      const auto far_from_chain = [&](const Point& p) {
        double best = 1e300;
        for (std::size_t i = 1; i < edges.size(); ++i)
          best = std::min(best, distance_to_segment(p, edges[i - 1], edges[i]));
        return best;
      };
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        for (const double t : {0.0, 0.3, 0.7})
          EXPECT_LE(far_from_chain(lerp(ring[j], ring[i], t)), reach * (1 + 1e-9) + 1);
      for (int k = 0; k < 20; ++k) {
        const std::size_t edge =
            chain.begin + static_cast<std::size_t>(rng.between(0, static_cast<int>(chain.end - chain.begin) - 1));
        const Point foot = lerp(point(points[edge]), point(points[edge + 1]), rng.unit());
        const double high = reach * (rng.chance(0.5) ? rng.unit() : 1 - 1e-3 * rng.unit());
        const Point p = foot + high * walk.normal(edge);
        bool nearest = true;
        for (std::size_t i = 1; i < n && nearest; ++i)
          nearest = i == edge + 1 || distance_to_segment(p, point(points[i - 1]), point(points[i])) > high + 2;
        if (!nearest) continue;
        ++covered;
        EXPECT_TRUE(std::abs(winding(ring, p)) > 0.5 || distance_to_boundary(ring, p) < 1)
            << edge << " of " << chain.begin << ".." << chain.end;
      }
      begin = chain.end;
    }
  }
  EXPECT_GT(longer, trials / 10);
  EXPECT_GT(covered, trials);
}

TEST(ConcaveChain, AQuarterCircleIsOneChain) {
  for (const double reach : {0.9e6, 1e6 - 3, 1.05e6}) {  // smaller than the arc's radius, the same, larger
    std::vector<LatticePoint> points;
    const int steps = 20;
    for (int k = -1; k <= steps + 1; ++k)
      points.push_back(rounded(1e6 / std::cos(kPi / 4 / steps) *
                               Point(std::sin(kPi / 2 * k / steps), -std::cos(kPi / 2 * k / steps))));
    const Walk walk(points, 1);
    const ConcaveChain chain = longest_concave_chain(walk, 1, static_cast<std::size_t>(steps) + 1, reach);
    EXPECT_EQ(chain.end, static_cast<std::size_t>(steps) + 1) << reach;
    std::vector<LatticePoint> far;
    for (const Point& p : chain.far) far.push_back(rounded(p));
    far.erase(std::unique(far.begin(), far.end()), far.end());
    if (reach > 0.95e6) { EXPECT_LE(straightened_line(far).size(), 4u) << reach; }
  }
}

TEST(ConcaveChain, StraighteningMovesARingByAQuantumAtMost) {
  for (const auto seed : seeds(300)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<LatticePoint> ring;
    for (const Point& p : samples::star(rng, {0, 0}, 20, 2e3, rng.between(3, 9))) {
      const LatticePoint s = rounded(p);
      if (!ring.empty()) {
        const Point from = point(ring.back());
        const int between = rng.between(0, 20);
        for (int k = 1; k <= between; ++k) ring.push_back(rounded(lerp(from, point(s), k / (between + 1.0))));
      }
      ring.push_back(s);
    }
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    const std::vector<LatticePoint> straight = straightened_ring(ring);
    EXPECT_LE(straight.size(), ring.size());
    std::vector<Point> left;
    for (const LatticePoint& s : straight) left.push_back(point(s));
    for (const LatticePoint& s : ring) EXPECT_LE(distance_to_boundary(left, point(s)), 1 + 1e-9);
  }
}

}  // namespace
}  // namespace oxturn

// Edges of an overlay after they have been split, against brute force: any two meet at common ends only, and no edge
// passes a vertex within half a quantum.
#include "geometry/overlay/resolve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using Edges = std::vector<OverlayEdge>;

int sign(std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

bool cross_inside(const OverlayEdge& e, const OverlayEdge& f) {
  return sign(twice_area(e.a, e.b, f.a)) * sign(twice_area(e.a, e.b, f.b)) < 0 &&
         sign(twice_area(f.a, f.b, e.a)) * sign(twice_area(f.a, f.b, e.b)) < 0;
}

/// Measured vertically from a flat edge and horizontally from a steep one.
bool passes(const OverlayEdge& e, const LatticePoint& v) {
  const LatticePoint d = e.b - e.a;
  const std::int64_t along = dot(d, v - e.a), wide = std::max(std::abs(d.x), std::abs(d.y));
  return along > 0 && along < dot(d, d) && 2 * std::abs(twice_area(e.a, e.b, v)) <= wide;
}

/// Faults among edges that must be resolved.
int faults(const Edges& edges) {
  int found = 0;
  for (const OverlayEdge& e : edges)
    for (const OverlayEdge& f : edges) {
      if (&e == &f) continue;
      found += cross_inside(e, f) || passes(e, f.a) || passes(e, f.b) || (e.a == f.a && e.b == f.b);
    }
  return found;
}

/// What leaves each vertex less what enters it. Splitting edges of closed rings leaves 0 everywhere.
bool is_closed(const Edges& edges) {
  std::map<LatticePoint, Windings> sums;
  for (const OverlayEdge& e : edges) {
    sums[e.a] = sums[e.a] + e.weight;
    sums[e.b] = sums[e.b] - e.weight;
  }
  return std::ranges::all_of(sums, [](const auto& s) { return s.second == Windings{}; });
}

void expect_resolved(Edges edges) {
  resolve(edges);
  EXPECT_EQ(faults(edges), 0);
  EXPECT_TRUE(is_closed(edges));
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const OverlayEdge &e = edges[k - 1], &f = edges[k];
    EXPECT_TRUE(e.a < f.a || (e.a == f.a && e.b < f.b)) << k;
    EXPECT_NE(f.weight, Windings{});
  }
}

LatticePoint random_point(Rng& rng, int far) { return {rng.between(-far, far), rng.between(-far, far)}; }

TEST(Resolve, RandomRingsMeetAtCommonEndsOnly) {
  for (const auto seed : seeds(600)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    // On a small lattice pieces are moved so far that many have to be split again; on a large one hardly any.
    const int far = std::array{6, 20, 100, 3000, 1 << 20, 1 << 29}[static_cast<std::size_t>(rng.between(0, 5))];
    Edges edges;
    for (int k = rng.between(1, 6); k > 0; --k) {
      std::vector<LatticePoint> ring(static_cast<std::size_t>(rng.between(3, 12)));
      for (LatticePoint& p : ring) p = random_point(rng, far);
      add_ring(edges, ring, {rng.chance(0.5) ? 1 : 0, 1});
    }
    expect_resolved(edges);
  }
}

TEST(Resolve, FlatRingsThroughTheSamePointsMeetAtCommonEndsOnly) {
  for (const auto seed : seeds(400)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    // Needles through a few points, a few quanta beside each other: they cross at small angles, near other crossings.
    const int far = std::array{200, 20000, 1 << 24}[static_cast<std::size_t>(rng.between(0, 2))];
    std::vector<LatticePoint> met(static_cast<std::size_t>(rng.between(1, 3)));
    for (LatticePoint& p : met) p = random_point(rng, far / 4);
    Edges edges;
    for (int k = rng.between(2, 10); k > 0; --k) {
      const LatticePoint through = met[static_cast<std::size_t>(rng.between(0, static_cast<int>(met.size()) - 1))];
      const LatticePoint p = random_point(rng, far), q = through + (through - p) + random_point(rng, 3);
      add_ring(edges, {p, q, rounded((p.x + q.x) / 2.0, (p.y + q.y) / 2.0) + random_point(rng, 3)}, {1, 0});
    }
    expect_resolved(edges);
  }
}

TEST(Resolve, LongEdgesWithManyCrossingsMeetAtCommonEndsOnly) {
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    // Two combs across each other, on a lattice that is hardly finer than their teeth, and a bundle of needles across
    // one of them.
    const int teeth = rng.between(5, 60), far = rng.chance(0.5) ? 4 * teeth : 300 * teeth;
    Edges edges;
    const auto in_bundle = [&](int x) { return LatticePoint{x, far / 3 + rng.between(0, 6)}; };
    for (int k = 0; k < teeth; ++k) {
      const int at = far * k / teeth, shift = rng.between(0, 3);
      add_ring(edges, {{at, -5}, {at + shift, far}, {at + 1, far}}, {1, 0});
      if (rng.chance(0.3)) add_ring(edges, {{-5, at}, {far, at + shift}, {far, at + 1}}, {0, 1});
      if (k % 8 == 0) add_ring(edges, {in_bundle(-5), in_bundle(far), in_bundle(far / 2)}, {1, 1});
    }
    expect_resolved(edges);
  }
}

// So a second look need not compare them.
TEST(Resolve, PiecesOfOneEdgeMeetAtTheirEndsOnly) {
  Rng rng(7);
  for (int k = 0; k < 300000; ++k) {
    const int far = std::array{12, 60, 1000}[static_cast<std::size_t>(k % 3)];
    const LatticePoint a{0, 0}, b{rng.between(1, far), rng.between(-far, far)};
    const double length = std::hypot(b.x, b.y), near = rng.unit();
    std::vector<LatticePoint> stops{b};
    for (int n = rng.between(1, 5); n > 0; --n) {  // points of the edge, rounded
      const double t = std::clamp(near + rng.between(-3.0, 3.0) / length, 0.0, 1.0);
      if (const LatticePoint p = rounded(t * b.x, t * b.y); p != a) stops.push_back(p);
    }
    std::ranges::sort(stops, {}, [&](const LatticePoint& p) { return std::pair(dot(b, p), p); });
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    Edges pieces;
    for (LatticePoint at = a; const LatticePoint& p : stops)
      directed(std::exchange(at, p), p, {1, 0}, [&](const auto& e) { pieces.push_back(e); });
    ASSERT_EQ(faults(pieces), 0) << b.x << " " << b.y;
  }
}

}  // namespace
}  // namespace oxturn

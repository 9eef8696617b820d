// The parts of an overlay against brute force: spread_sort, close pairs, splitting edges, the edge below a point, the
// order of parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/random.hpp"
#include "base/sorting.hpp"
#include "geometry/overlay/arrangement.hpp"
#include "geometry/overlay/close_pairs.hpp"
#include "geometry/overlay/edge_below.hpp"
#include "geometry/spatial_order.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

TEST(SpreadSort, SortsEvenlySpreadClusteredAndEqualKeys) {
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    using Item = std::pair<std::uint64_t, int>;
    std::vector<Item> items(static_cast<std::size_t>(rng.between(0, 3000)));
    const int bits = rng.between(1, 63), kind = rng.between(0, 2);
    for (Item& item : items) {
      item.first = static_cast<std::uint64_t>(rng.unit() * std::ldexp(1.0, bits));
      if (kind == 1 && rng.chance(0.9)) item.first = 7;
      if (kind == 2) item.first >>= rng.between(0, 60);
      item.second = rng.between(0, 5);
    }
    std::vector<Item> sorted = items;
    std::sort(sorted.begin(), sorted.end());
    spread_sort(
        items, [](const Item& i) { return i.first; }, std::less<>());
    EXPECT_EQ(items, sorted);
  }
}

std::vector<SegmentPart> random_segments(Rng& rng) {
  const int kind = rng.between(0, 5);
  const int n = kind == 5 ? rng.between(3500, 5000) : rng.chance(0.2) ? rng.between(2500, 3500) : rng.between(2, 1500);
  std::vector<SegmentPart> out;
  for (int k = 0; k < n; ++k) {
    double x = rng.between(0.0, 1e6), y = rng.between(0.0, 1e6), reach = 2e4;
    if (kind == 1 && k > 9) x /= 1e3, y /= 1e3, reach /= 1e3;  // almost all in one corner
    if (kind == 2) reach = rng.chance(0.02) ? 1e6 : 1e4;       // a few long ones
    if (kind == 3) y = std::floor(y / 1e5) * 1e5;              // on a few lines
    if (kind == 4) x = 5e5;
    if (kind == 5) {  // crowds crossed by long ones: cells within cells
      const bool is_long = rng.chance(0.05);
      if (!is_long) x = 2.5e5 * rng.between(1, 3) + x / 50, y = 2.5e5 * rng.between(1, 3) + y / 50;
      reach = is_long ? 1e6 : 1e3;
    }
    const double dx = rng.chance(0.3) ? 0 : rng.unit() * reach, dy = rng.chance(0.3) ? 0 : rng.between(-reach, reach);
    out.push_back(
        {std::round(x), std::round(y), std::round(x + dx), std::round(y + dy), static_cast<std::uint32_t>(k)});
  }
  return out;
}

/// Are the segments within `slack` of each other? Never false where they are.
bool near(const SegmentPart& s, const SegmentPart& t, double slack) {
  if (s.x1 < t.x0 - slack || t.x1 < s.x0 - slack || std::max(s.y0, s.y1) < std::min(t.y0, t.y1) - slack ||
      std::max(t.y0, t.y1) < std::min(s.y0, s.y1) - slack)
    return false;
  const Point a(s.x0, s.y0), b(s.x1, s.y1), c(t.x0, t.y0), d(t.x1, t.y1);
  const auto side = [](const Point& p, const Point& q, const Point& r) { return cross(q - p, r - p); };
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)}) <= slack;
}

TEST(ClosePairs, NoPairWithinTheSlackIsMissing) {
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const std::vector<SegmentPart> all = random_segments(rng);
    std::vector<std::uint8_t> active;
    const double share = rng.chance(0.3) ? 1 : rng.chance(0.5) ? 0.02 : 0.5;
    for (std::size_t k = 0; k < all.size(); ++k) active.push_back(rng.chance(share) ? 1 : 0);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for_close_pairs(
        all.size(), [&](std::size_t k) { return all[k]; }, 1.0, active,
        [&](std::uint32_t i, std::uint32_t j) {
          found.insert({std::min(i, j), std::max(i, j)});
        });
    std::size_t wanted = 0;
    for (std::uint32_t i = 0; i < all.size(); ++i)
      for (std::uint32_t j = i + 1; j < all.size(); ++j) {
        if ((active[i] == 0 && active[j] == 0) || !near(all[i], all[j], 1.0)) continue;
        ++wanted;
        EXPECT_TRUE(found.count({i, j})) << i << " " << j;
      }
    EXPECT_LE(wanted, found.size());
    for (const auto& [i, j] : found) EXPECT_TRUE(active[i] != 0 || active[j] != 0);
  }
}

TEST(Arrangement, NoVertexLiesWithinHalfAQuantumOfAnEdge) {
  int close = 0;
  for (const auto seed : seeds(400)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    // Triangles so flat that their sides bend to each other's ends, and others across them.
    std::vector<OverlayEdge> edges;
    const auto point = [&](int far) { return LatticePoint{rng.between(-far, far), rng.between(-far, far)}; };
    const int triangles = rng.between(1, 4), far = rng.chance(0.5) ? 30 : 3000;
    for (int k = 0; k < triangles; ++k) {
      const LatticePoint p = point(far), q = point(far);
      const double t = rng.between(-0.5, 1.5);
      const LatticePoint r = rounded(p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)) + point(2);
      std::array corners{p, q, r};
      std::rotate(corners.begin(), corners.begin() + rng.between(0, 2), corners.end());
      close += std::abs(twice_area(p, q, r)) <= far;
      add_ring(edges, {corners.begin(), corners.end()}, {twice_area(p, q, r) > 0 ? 1 : -1, 0});
    }
    const std::vector<BoundaryEdge> boundary = boundary_of(edges, inside_first);
    for (const BoundaryEdge& e : boundary)
      for (const BoundaryEdge& f : boundary) {
        const LatticePoint d = e.to - e.from, &v = f.from;
        const std::int64_t along = dot(d, v - e.from), wide = std::max(std::abs(d.x), std::abs(d.y));
        if (along <= 0 || along >= dot(d, d)) continue;
        EXPECT_GT(2 * std::abs(twice_area(e.from, e.to, v)), wide) << v.x << " " << v.y;
      }
  }
  EXPECT_GT(close, 100);
}

TEST(EdgeBelow, IsTheHighestOfTheEdgesBelow) {
  for (const auto seed : seeds(200)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    // Edges that do not cross: chains one above the other, with some long edges.
    std::vector<EdgeBelow::Edge> edges;
    const int lines = rng.between(1, 30);
    for (int l = 0; l < lines; ++l) {
      int x = rng.between(-1000, 900);
      const int pieces = rng.between(1, 30);
      for (int k = 0; k < pieces && x < 1000; ++k) {
        const int to = x + rng.between(1, rng.chance(0.2) ? 1000 : 60), low = 100 * l, high = 100 * l + 99;
        const int from_y = k == 0 ? rng.between(low, high) : edges.back().b.y;
        edges.push_back({{x, from_y}, {to, rng.between(low, high)}, static_cast<std::uint32_t>(edges.size())});
        x = to;
      }
    }
    std::vector<EdgeBelow::Edge> shuffled = edges;
    for (std::size_t k = shuffled.size(); k > 1; --k)
      std::swap(shuffled[k - 1], shuffled[static_cast<std::size_t>(rng.between(0, static_cast<int>(k) - 1))]);
    const EdgeBelow below(shuffled);
    std::ranges::sort(edges, {}, [](const EdgeBelow::Edge& e) { return e.a; });
    FewEdgesBelow few(edges.size(), [&](std::uint32_t e) { return std::pair(edges[e].a, edges[e].b); });
    for (int q = 0; q < 100; ++q) {
      const LatticePoint p{rng.between(-1100, 2000), rng.between(-100, 3100)};
      std::uint32_t best = EdgeBelow::kNone;
      double top = -1e9;
      bool on_edge = false;
      for (const EdgeBelow::Edge& e : edges) {
        if (e.a.x >= p.x || e.b.x < p.x) continue;
        const double y = e.a.y + (e.b.y - e.a.y) * ((p.x - e.a.x) / (double(e.b.x) - e.a.x));
        on_edge = on_edge || std::abs(y - p.y) < 1e-6;
        if (y < p.y && y > top) {
          top = y;
          best = e.id;
        }
      }
      if (on_edge) continue;
      EXPECT_EQ(below.below(p), best);
      const std::uint32_t e = few.below(p);
      EXPECT_EQ(e == EdgeBelow::kNone ? e : edges[e].id, best);
    }
  }
}

TEST(SpatialOrder, KeepsNeighboursTogetherAndLosesNone) {
  Rng rng(31);
  Region scattered;
  for (int k = 0; k < 2000; ++k) {
    const Point at(100 * rng.unit(), 30 * rng.unit());
    scattered.polygons.push_back({{at, at + Point(0.1, 0), at + Point(0, 0.1)}, {}});
  }
  const auto walked = [](const Region& region) {
    double sum = 0;
    for (std::size_t k = 1; k < region.polygons.size(); ++k)
      sum += distance(region.polygons[k - 1].outer[0], region.polygons[k].outer[0]);
    return sum;
  };
  Region ordered = scattered;
  put_neighbours_together(ordered);
  EXPECT_LT(walked(ordered), walked(scattered) / 15);
  const auto left = [](const Polygon& p) { return std::pair(p.outer[0].x(), p.outer[0].y()); };
  std::ranges::sort(ordered.polygons, {}, left);
  std::ranges::sort(scattered.polygons, {}, left);
  ASSERT_EQ(ordered.polygons.size(), scattered.polygons.size());
  for (std::size_t k = 0; k < ordered.polygons.size(); ++k)
    EXPECT_EQ(ordered.polygons[k].outer, scattered.polygons[k].outer);
  EXPECT_TRUE(spatial_order({Box{}, Box{}}).empty());
}

}  // namespace
}  // namespace oxturn

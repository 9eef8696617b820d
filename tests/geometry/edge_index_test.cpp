#include "geometry/edge_index.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "random_region.hpp"

namespace oxturn {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Squares of a chess board with 8 fields, as polygons that touch in corners.
Region chess_board() {
  Region region;
  for (int j = 0; j < 8; ++j) {
    for (int i = j % 2; i < 8; i += 2) {
      region.polygons.push_back({{{1.0 * i, 1.0 * j}, {i + 1.0, 1.0 * j}, {i + 1.0, j + 1.0}, {1.0 * i, j + 1.0}}, {}});
    }
  }
  return region;
}

/// Even-odd by a ray that is neither level nor aimed at anything; for points well off the boundary.
bool plainly_inside(const std::vector<EdgeIndex::Edge>& edges, const Point& p) {
  const Point d(0.8414709848, 0.5403023058);
  bool in = false;
  for (const EdgeIndex::Edge& e : edges) {
    const double sa = cross(d, e.a - p), sb = cross(d, e.b - p);
    if ((sa > 0) == (sb > 0)) continue;
    const double t = sa / (sa - sb);
    if ((lerp(e.a, e.b, t) - p).dot(d) > 0) in = !in;
  }
  return in;
}

double boundary_distance(const std::vector<EdgeIndex::Edge>& edges, const Point& p) {
  double best = kInf;
  for (const EdgeIndex::Edge& e : edges) best = std::min(best, distance_to_segment(p, e.a, e.b));
  return best;
}

/// Cuts the segment wherever it meets an edge and looks at the middle of each piece.
bool plainly_contains(const std::vector<EdgeIndex::Edge>& edges, const Point& a, const Point& b) {
  std::vector<double> cuts{0, 1};
  const Point d = b - a;
  for (const EdgeIndex::Edge& e : edges) {
    const Point f = e.b - e.a;
    const double across = cross(d, f);
    if (std::abs(across) > 1e-12) {
      const double t = cross(e.a - a, f) / across, s = cross(e.a - a, d) / across;
      if (s >= -1e-9 && s <= 1 + 1e-9) cuts.push_back(t);
    }
    for (const Point& p : {e.a, e.b}) {
      if (distance_to_segment(p, a, b) < 1e-9) cuts.push_back((p - a).dot(d) / d.squaredNorm());
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double s = std::max(0.0, cuts[i - 1]), t = std::min(1.0, cuts[i]);
    if (t - s < 1e-9) continue;
    const Point middle = lerp(a, b, (s + t) / 2);
    if (!plainly_inside(edges, middle) && boundary_distance(edges, middle) > 1e-10) return false;
  }
  return true;
}

std::vector<Region> samples(std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Region> all;
  all.push_back(clutter_box(rng, rng.between(1, 6), rng.between(1, 6), false));
  all.push_back(clutter_box(rng, rng.between(1, 6), rng.between(1, 6), true));
  all.push_back(star_region(rng, rng.between(4, 60)));
  all.push_back(chess_board());
  all.push_back({{{convex_ring(rng, {1e6, -1e6}, 3, 7), {}}, {convex_ring(rng, {1e6 + 9, -1e6}, 3, 7), {}}}});
  return all;
}

Point around(Rng& rng, const Region& region, bool lattice) {
  Box box = bounding_box(region);
  box.grow(0.2 * box.size().norm());
  Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
  if (lattice) p = (p * 8).array().round() / 8;
  return p;
}

TEST(EdgeIndex, NearestAgreesWithAScanOfAllEdges) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const Region& region : samples(seed)) {
      const EdgeIndex index(region);
      Rng rng(seed + 1000);
      for (int q = 0; q < 40; ++q) {
        const Point p = around(rng, region, q % 2 == 0);
        const double truth = boundary_distance(index.edges(), p);
        const auto found = index.nearest(p);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->distance, truth, 1e-12 * (1 + p.norm()));
        EXPECT_NEAR(boundary_distance(index.edges(), found->point), 0, 1e-12 * (1 + p.norm()));
        EXPECT_NEAR(distance(found->from, found->point), found->distance, 1e-12 * (1 + p.norm()));
        EXPECT_FALSE(index.nearest(p, truth * 0.999));
        if (truth > 0) { EXPECT_TRUE(index.nearest(p, truth * 1.001)); }
      }
    }
  }
}

TEST(EdgeIndex, NearestToASegmentAgreesWithAScanOfAllEdges) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const Region& region : samples(seed)) {
      const EdgeIndex index(region);
      Rng rng(seed + 2000);
      for (int q = 0; q < 30; ++q) {
        const Point a = around(rng, region, q % 2 == 0);
        const Point b =
            q % 3 == 0 ? around(rng, region, q % 2 == 0) : Point(a + 0.3 * Point(rng.normal(), rng.normal()));
        double truth = kInf;
        for (const EdgeIndex::Edge& e : index.edges()) {
          const double across = cross(b - a, e.b - e.a);
          if (across != 0) {
            const double t = cross(e.a - a, e.b - e.a) / across, s = cross(e.a - a, b - a) / across;
            if (t >= 0 && t <= 1 && s >= 0 && s <= 1) truth = 0;
          }
          truth = std::min({truth, distance_to_segment(a, e.a, e.b), distance_to_segment(b, e.a, e.b),
                            distance_to_segment(e.a, a, b), distance_to_segment(e.b, a, b)});
        }
        const double eps = 1e-12 * (1 + a.norm());
        const auto found = index.nearest(a, b);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->distance, truth, eps);
        EXPECT_NEAR(distance_to_segment(found->from, a, b), 0, eps);
        EXPECT_NEAR(distance(found->from, found->point), found->distance, eps);
        if (truth > 1e-9) {
          EXPECT_FALSE(index.nearest(a, b, truth * 0.999));
          EXPECT_TRUE(index.nearest(a, b, truth * 1.001));
        }
      }
    }
  }
}

TEST(EdgeIndex, ContainsAPointAsEvenOddSaysAndItsBoundary) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    for (const Region& region : samples(seed)) {
      const EdgeIndex index(region);
      Rng rng(seed + 3000);
      for (int q = 0; q < 60; ++q) {
        const Point p = around(rng, region, q % 2 == 0);
        if (boundary_distance(index.edges(), p) < 1e-7) {
          if (q % 2 == 0 && boundary_distance(index.edges(), p) == 0 && p.norm() < 100) {
            EXPECT_TRUE(index.contains(p)) << p.transpose();
          }
          continue;
        }
        EXPECT_EQ(index.contains(p), plainly_inside(index.edges(), p)) << "seed " << seed << " at " << p.transpose();
      }
      for (const EdgeIndex::Edge& e : index.edges()) EXPECT_TRUE(index.contains(e.a));
    }
  }
}

TEST(EdgeIndex, ContainsASegmentAsItsPiecesSay) {
  int yes = 0, no = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    for (const Region& region : samples(seed)) {
      const EdgeIndex index(region);
      Rng rng(seed + 4000);
      for (int q = 0; q < 60; ++q) {
        const bool lattice = q % 2 == 0;
        const auto end = [&] {
          return rng.chance(0.3) ? index.edges()[rng.below(index.edges().size())].a : around(rng, region, lattice);
        };
        const Point a = end();
        const Point b = rng.chance(0.5) ? end() : Point(a + Point(rng.between(-8, 8), rng.between(-8, 8)) / 8);
        if (a == b || a.norm() > 1000) continue;
        const bool truth = plainly_contains(index.edges(), a, b);
        EXPECT_EQ(index.contains(a, b), truth) << "seed " << seed << ": " << a.transpose() << " to " << b.transpose();
        EXPECT_EQ(index.contains(b, a), truth) << "seed " << seed << ": " << b.transpose() << " to " << a.transpose();
        ++(truth ? yes : no);
      }
    }
  }
  EXPECT_GT(yes, 1000);
  EXPECT_GT(no, 1000);
}

TEST(EdgeIndex, PassesAlongWallsAndThroughTouchingCornersOnlyWhereFree) {
  const Region board = chess_board();
  const EdgeIndex index(board);
  EXPECT_TRUE(index.contains({0, 0}, {8, 8}));   // from square to square through the corners
  EXPECT_FALSE(index.contains({1, 0}, {8, 7}));  // the diagonal of the others
  EXPECT_FALSE(index.contains({1, 1.5}, {2, 0.5}));
  EXPECT_TRUE(index.contains({0, 1}, {8, 1}));  // along walls, free on alternate sides
  EXPECT_TRUE(index.contains({1, 8}, {1, 0}));
  EXPECT_FALSE(index.contains({-1, 1}, {8, 1}));
  EXPECT_FALSE(index.contains({0.5, 0.5}, {1.5, 0.5}));
  // A corner in the middle of another ring's edge.
  const EdgeIndex tee(Region{{{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {}}, {{{2, 2}, {3, 4}, {1, 4}}, {}}}});
  EXPECT_TRUE(tee.contains({2, 0}, {2, 4}));
  EXPECT_FALSE(tee.contains({1, 0}, {1, 4}));
  EXPECT_TRUE(tee.contains({0, 2}, {4, 2}));
  EXPECT_TRUE(tee.contains({0, 2}, {2, 2}));
  EXPECT_FALSE(tee.contains({1, 1}, {3, 3}));
}

TEST(EdgeIndex, NearListsEveryEdgeThatMeetsTheBox) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    for (const Region& region : samples(seed)) {
      const EdgeIndex index(region);
      Rng rng(seed);
      Box box;
      box.add(around(rng, region, false));
      box.add(around(rng, region, false));
      std::vector<std::size_t> listed;
      index.for_each_near(box, [&](std::size_t e) { listed.push_back(e); });
      EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end()));
      const std::set<std::size_t> set(listed.begin(), listed.end());
      EXPECT_EQ(set.size(), listed.size());
      for (std::size_t e = 0; e < index.edges().size(); ++e) {
        for (int i = 0; i <= 20; ++i) {
          if (box.contains(lerp(index.edges()[e].a, index.edges()[e].b, i / 20.0))) { EXPECT_EQ(set.count(e), 1u); }
        }
      }
    }
  }
}

TEST(EdgeIndex, AnswersForEmptyRegionsAndForPointsThatAreNotFinite) {
  const EdgeIndex none{Region{}};
  EXPECT_FALSE(none.nearest({0, 0}));
  EXPECT_FALSE(none.contains({0, 0}));
  EXPECT_FALSE(none.contains({0, 0}, {1, 1}));
  const EdgeIndex index(chess_board());
  const double nan = std::nan("");
  EXPECT_FALSE(index.nearest({nan, 0}));
  EXPECT_FALSE(index.contains({nan, 0}));
  EXPECT_FALSE(index.contains({0, 0}, {kInf, nan}));
  EXPECT_TRUE(index.nearest({1e9, -1e9}));
}

}  // namespace
}  // namespace oxturn

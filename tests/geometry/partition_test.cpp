#include "geometry/mesh/partition.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>

#include "geometry/edge_index.hpp"
#include "geometry/predicates.hpp"
#include "random_region.hpp"

namespace oxturn {
namespace {

using Parts = std::vector<Ring>;

double total(const Parts& parts) {
  double sum = 0;
  for (const Ring& r : parts) sum += signed_area(r);
  return sum;
}

bool convex(const Ring& r) {
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (orientation(r[i], r[(i + 1) % r.size()], r[(i + 2) % r.size()]) < 0) return false;
  }
  return signed_area(r) > 0;
}

/// Heights rise and fall once round the ring (level stretches allowed).
bool y_monotone(const Ring& r) {
  int turns = 0;
  int last = 0;
  std::vector<int> signs;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double d = r[(i + 1) % r.size()].y() - r[i].y();
    if (d != 0) signs.push_back(d > 0 ? 1 : -1);
  }
  for (const int s : signs) {
    if (last != 0 && s != last) ++turns;
    last = s;
  }
  if (!signs.empty() && signs.front() != last) ++turns;
  return turns <= 2;
}

bool before_points(const Point& a, const Point& b) { return before(a, b); }

void own_corners_only(const Region& region, const Parts& parts) {
  std::set<Point, bool (*)(const Point&, const Point&)> corners(before_points);
  for_each_ring(region, [&](const Ring& r) { corners.insert(r.begin(), r.end()); });
  for (const Ring& r : parts) {
    for (const Point& p : r) EXPECT_EQ(corners.count(p), 1u);
  }
}

/// Every random point off the parts' edges is in exactly one part if it is in the region, else in none. (With the sum
/// of areas this says that interiors are disjoint.)
void covers_once(const Region& region, const Parts& parts, Rng& rng) {
  const EdgeIndex index(region);
  const Box box = bounding_box(region);
  for (int q = 0; q < 30; ++q) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    int in = 0;
    for (const Ring& r : parts) in += contains(Region{{{r, {}}}}, p) ? 1 : 0;
    EXPECT_EQ(in, index.contains(p) ? 1 : 0);
  }
  EXPECT_NEAR(total(parts), area(region), 1e-9 * area(region));
}

void on_samples(int most, const std::function<void(const Region&, Rng&)>& check) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    check(clutter_box(rng, rng.between(1, most), rng.between(1, most), false), rng);
    check(clutter_box(rng, rng.between(1, most), rng.between(1, most), true), rng);
    check(star_region(rng, rng.between(4, 15 * most)), rng);
  }
}

Region touching() {
  return {{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}},
            {{{1, 4}, {2, 5}, {3, 4}, {2, 3}},
             {{3, 4}, {4, 5}, {5, 4}, {4, 3}},
             {{2, 5}, {1, 6}, {2, 7}, {3, 6}},
             {{7, 7}, {9, 8}, {8, 6}},
             {{6, 2}, {8, 2}, {7, 0}}}},
           {{{9, 9}, {10, 9}, {10, 10}, {9, 10}}, {}}}};
}

std::size_t reflex_count(const Region& region) {
  std::size_t n = 0;
  for_each_ring(region, [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      n += orientation(r[i], r[(i + 1) % r.size()], r[(i + 2) % r.size()]) < 0 ? 1 : 0;
    }
  });
  return n;
}

TEST(Partition, ApproximateConvexPartsAreConvexAndAtMostFourTimesTooMany) {
  const auto check = [](const Region& region, Rng& rng) {
    const Parts parts = convex_partition_approximate(region);
    for (const Ring& r : parts) EXPECT_TRUE(convex(r));
    own_corners_only(region, parts);
    covers_once(region, parts, rng);
    // Each diagonal kept is needed by a reflex corner, and no corner needs more than two.
    EXPECT_LE(parts.size(), 2 * reflex_count(region) + 1);
  };
  on_samples(6, check);
  Rng rng(1);
  check(touching(), rng);
}

TEST(Partition, OptimalConvexPartsAreConvexAndNoMoreThanApproximate) {
  const auto check = [](const Region& region, Rng& rng) {
    const Parts parts = convex_partition_optimal(region);
    for (const Ring& r : parts) EXPECT_TRUE(convex(r));
    own_corners_only(region, parts);
    covers_once(region, parts, rng);
    if (hole_count(region) == 0) {
      EXPECT_LE(parts.size(), convex_partition_approximate(region).size());
      EXPECT_GE(4 * parts.size(), convex_partition_approximate(region).size());
      EXPECT_GE(parts.size(), (reflex_count(region) + 1) / 2 + 1);
    }
  };
  on_samples(2, check);
  Rng rng(1);
  check(touching(), rng);
}

TEST(Partition, OptimalFindsTheLeastNumber) {
  EXPECT_EQ(convex_partition_optimal(box_region({0, 0}, {2, 1})).size(), 1u);
  EXPECT_EQ(convex_partition_optimal(Region{{{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}}}}).size(), 2u);
  // A plus sign: four reflex corners, one cut for two of them.
  EXPECT_EQ(
      convex_partition_optimal(
          Region{
              {{{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}, {}}}})
          .size(),
      3u);
}

TEST(Partition, OptimalRefusesManyCornersWithASentence) {
  Rng rng(3);
  const Region region = star_region(rng, 151);
  EXPECT_THROW(convex_partition_optimal(region), std::invalid_argument);
  EXPECT_NO_THROW(convex_partition_optimal(region, 151));
}

/// Reflex corners with both neighbours above or both below.
std::size_t cusp_count(const Region& region) {
  std::size_t n = 0;
  for_each_ring(region, [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      const Point &a = r[i], &v = r[(i + 1) % r.size()], &b = r[(i + 2) % r.size()];
      const auto up = [&](const Point& p) { return p.y() > v.y() || (p.y() == v.y() && p.x() > v.x()); };
      n += orientation(a, v, b) < 0 && up(a) == up(b) ? 1 : 0;
    }
  });
  return n;
}

TEST(Partition, MonotonePartsAreMonotoneAndNoMoreThanCuspsAsk) {
  const auto check = [](const Region& region, Rng& rng) {
    const Parts parts = monotone_partition(region);
    EXPECT_LE(parts.size(), cusp_count(region) + region.polygons.size());
    for (const Ring& r : parts) EXPECT_TRUE(y_monotone(r));
    own_corners_only(region, parts);
    covers_once(region, parts, rng);
  };
  on_samples(6, check);
  Rng rng(1);
  check(touching(), rng);
}

TEST(Partition, TrapezoidsHaveVerticalSidesAndFitTogether) {
  const auto check = [](const Region& region, Rng& rng) {
    const Parts parts = trapezoid_partition(region);
    for (const Ring& r : parts) {
      ASSERT_GE(r.size(), 3u);
      ASSERT_LE(r.size(), 4u);
      std::set<double> sides;
      for (const Point& p : r) sides.insert(p.x());
      EXPECT_EQ(sides.size(), 2u);
    }
    covers_once(region, parts, rng);
  };
  on_samples(6, check);
  Rng rng(1);
  check(touching(), rng);
  // n corners in general position, h holes: n + h - 1 trapezoids for one polygon.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng more(seed);
    const Region region = transformed(clutter_box(more, 4, 4, false), 0.3, {0, 0});
    EXPECT_EQ(trapezoid_partition(region).size(), vertex_count(region) + hole_count(region) - 1);
  }
}

TEST(Partition, NothingGivesNothing) {
  EXPECT_TRUE(convex_partition_approximate(Region{}).empty());
  EXPECT_TRUE(convex_partition_optimal(Region{}).empty());
  EXPECT_TRUE(monotone_partition(Region{}).empty());
  EXPECT_TRUE(trapezoid_partition(Region{}).empty());
}

// Regression: CGAL 5.5 gave a part that crosses itself for this ring, and only some builds noticed.
TEST(ConvexOptimal, NeverReturnsAPartThatIsNotConvex) {
  const Ring ring{{0.392, 3.608},   {0.392, 0.392},   {3.608, 0.392}, {3, 1.608},       {2.392, 1.608},   {2.392, 1},
                  {2.2772, 0.7228}, {2, 0.608},       {1, 0.608},     {0.7228, 0.7228}, {0.608, 1},       {0.608, 2},
                  {0.7228, 2.2772}, {1, 2.392},       {1.608, 2.392}, {1.608, 3},       {1.7228, 3.2772}, {2, 3.392},
                  {3, 3.392},       {3.2772, 3.2772}, {3.392, 3},     {3.608, 3.608}};
  for (std::size_t first = 0; first < ring.size(); ++first) {
    SCOPED_TRACE(first);
    Ring turned(ring);
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    std::vector<Ring> parts;
    try {
      parts = convex_partition_optimal({{{turned, {}}}});
    } catch (const std::runtime_error&) {
      continue;  // said, not hidden
    }
    double sum = 0;
    for (const Ring& part : parts) {
      sum += signed_area(part);
      for (std::size_t i = 0; i < part.size(); ++i)
        EXPECT_GE(orientation(part[i], part[(i + 1) % part.size()], part[(i + 2) % part.size()]), 0);
    }
    EXPECT_NEAR(sum, signed_area(ring), 1e-9);
  }
}

}  // namespace
}  // namespace oxturn

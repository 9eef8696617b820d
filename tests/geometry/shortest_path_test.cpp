#include "geometry/shortest_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "geometry/edge_index.hpp"
#include "geometry/predicates.hpp"
#include "random_region.hpp"
#include "taut_paths.hpp"

namespace oxturn {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Visibility graph over all corners and Dijkstra: O(n^3), shares nothing with the mesh.
double oracle(const Region& region, const EdgeIndex& index, const Point& a, const Point& b) {
  std::vector<Point> nodes{a, b};
  for_each_ring(region, [&](const Ring& r) { nodes.insert(nodes.end(), r.begin(), r.end()); });
  std::vector<double> far(nodes.size(), kInf);
  std::vector<bool> done(nodes.size(), false);
  far[0] = 0;
  while (true) {
    std::size_t at = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!done[i] && far[i] < kInf && (at == nodes.size() || far[i] < far[at])) at = i;
    }
    if (at == nodes.size() || at == 1) return far[1];
    done[at] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double d = far[at] + distance(nodes[at], nodes[i]);
      if (!done[i] && d < far[i] && index.contains(nodes[at], nodes[i])) far[i] = d;
    }
  }
}

Point free_point(Rng& rng, const EdgeIndex& index, const Box& box) {
  while (true) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    if (index.contains(p)) return p;
  }
}

void expect_valid(const Polyline& path, const Point& a, const Point& b, const EdgeIndex& index) {
  ASSERT_GE(path.size(), 2u);
  EXPECT_EQ(path.front(), a);
  EXPECT_EQ(path.back(), b);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_TRUE(index.contains(path[i - 1], path[i])) << "leg " << i;
}

void compare(const Region& region, Rng& rng, int queries) {
  const EdgeIndex index(region);
  const ShortestPaths paths(region, 1e-9);
  const Box box = bounding_box(region);
  for (int q = 0; q < queries; ++q) {
    const auto end = [&]() -> Point {
      if (rng.chance(0.6)) return free_point(rng, index, box);
      const EdgeIndex::Edge& e = index.edges()[rng.below(index.edges().size())];
      return rng.chance(0.5) ? e.a : Point((e.a + e.b) / 2);
    };
    const Point a = end(), b = end();
    SCOPED_TRACE(testing::Message() << "query " << q << " from " << a.transpose() << " to " << b.transpose());
    const auto path = paths.path(a, b);
    ASSERT_TRUE(path);
    const auto back = paths.path(b, a);
    ASSERT_TRUE(back);
    EXPECT_NEAR(length(*path), length(*back), 1e-9 * (1 + length(*path)));
    if (!index.contains(a) || !index.contains(b)) continue;  // a rounded middle of an edge may lie outside by 1e-16
    expect_valid(*path, a, b, index);
    const double best = oracle(region, index, a, b);
    EXPECT_NEAR(length(*path), best, 1e-9 * (1 + best));
  }
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphAmongConvexHoles) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(clutter_box(rng, rng.between(1, 4), rng.between(1, 4), false), rng, 6);
  }
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphOnALattice) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(clutter_box(rng, rng.between(1, 4), rng.between(1, 4), true), rng, 6);
  }
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphInStars) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(star_region(rng, rng.between(5, 40)), rng, 6);
  }
}

TEST(ShortestPaths, TiesAmongManyEqualBlocksStayCheap) {
  Polygon p{{{0, 0}, {40, 0}, {40, 40}, {0, 40}}, {}};
  for (int j = 0; j < 40; ++j) {
    for (int i = 0; i < 40; ++i)
      p.holes.push_back({{i + .25, j + .25}, {i + .25, j + .75}, {i + .75, j + .75}, {i + .75, j + .25}});
  }
  const Region region{{p}};
  const ShortestPaths paths(region, 1e-9);
  const EdgeIndex index(region);
  const auto path = paths.path({0, 0}, {40, 40});
  ASSERT_TRUE(path);
  expect_valid(*path, {0, 0}, {40, 40}, index);
  EXPECT_GT(length(*path), 40 * std::sqrt(2.0));
  EXPECT_LT(length(*path), 65);
}

TEST(ShortestPaths, GoesRoundASingleBlockByItsCorners) {
  const Region region{{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 2}, {4, 9}, {6, 9}, {6, 2}}}}}};
  const ShortestPaths paths(region, 1e-9);
  const auto path = paths.path({1, 5}, {9, 5});
  ASSERT_TRUE(path);
  const Polyline expected{{1, 5}, {4, 2}, {6, 2}, {9, 5}};
  EXPECT_EQ(*path, expected);
}

TEST(ShortestPaths, PartsThatTouchInAPointAreNotConnected) {
  Region region{{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {}}}};
  const ShortestPaths paths(region, 1e-9);
  EXPECT_FALSE(paths.path({0.5, 0.5}, {1.5, 1.5}));
  EXPECT_TRUE(paths.path({0.5, 0.5}, {1, 1}));
  EXPECT_TRUE(paths.path({1, 1}, {1.5, 1.5}));
}

TEST(ShortestPaths, RefusesWhatIsTooLongOrOutside) {
  const Region region{{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 2}, {4, 9}, {6, 9}, {6, 2}}}}}};
  const ShortestPaths paths(region, 1e-3);
  const double exact = 2 * std::sqrt(18.0) + 2;
  EXPECT_TRUE(paths.path({1, 5}, {9, 5}, exact + 1e-9));
  EXPECT_FALSE(paths.path({1, 5}, {9, 5}, exact - 1e-9));
  EXPECT_FALSE(paths.path({5, 5}, {9, 5}));
  EXPECT_FALSE(paths.path({1, 5}, {11, 5}));
  EXPECT_FALSE(paths.path({1, 5}, {std::nan(""), 5}));
  EXPECT_FALSE(ShortestPaths(Region{}, 1).path({0, 0}, {0, 0}));
  EXPECT_THROW(ShortestPaths(region, -1), std::invalid_argument);
}

TEST(ShortestPaths, EndsALittleOutsideAreTakenAsOnTheBoundaryAndKept) {
  const Region region{{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 2}, {4, 9}, {6, 9}, {6, 2}}}}}};
  const ShortestPaths paths(region, 1e-3);
  const Point a(-0.0009, 5), b(5.9992, 5), corner(-0.0005, -0.0005);
  const auto path = paths.path(a, b);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->front(), a);
  EXPECT_EQ(path->back(), b);
  EXPECT_EQ(path->size(), 4u);
  EXPECT_TRUE(paths.path(corner, b));
  EXPECT_FALSE(paths.path({-0.002, 5}, b));
}

TEST(ShortestPaths, DoesNotDependOnPlaceTurnOrScale) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region region = clutter_box(rng, 5, 5, false);
    const EdgeIndex index(region);
    const Point a = free_point(rng, index, bounding_box(region)), b = free_point(rng, index, bounding_box(region));
    const double angle = rng.between(0.0, 6.0);
    const Point shift(rng.between(-1e4, 1e4), rng.between(-1e4, 1e4));
    const auto here = ShortestPaths(region, 1e-9).path(a, b);
    const auto there = ShortestPaths(transformed(region, angle, shift), 1e-7)
                           .path(rotated(a, angle) + shift, rotated(b, angle) + shift);
    ASSERT_TRUE(here && there);
    EXPECT_NEAR(length(*here), length(*there), 1e-9 * length(*here) + 1e-8);
  }
}

void compare_classes(const Region& region, Rng& rng, std::size_t& classes) {
  const EdgeIndex index(region);
  const ShortestPaths paths(region, 1e-9);
  TautPaths oracle(region);
  const Box box = bounding_box(region);
  const auto end = [&] {  // often in line with corners of lattices
    Point p = free_point(rng, index, box);
    if (const Point q(std::round(p.x() * 8) / 8, std::round(p.y() * 8) / 8); rng.chance(0.5) && index.contains(q))
      p = q;
    return p;
  };
  const Point a = end(), b = end();
  const double longest = length(*paths.path(a, b)) + rng.between(0.5, 4.0);
  std::vector<Polyline> expected = oracle.from(a, b, longest), found;
  EXPECT_TRUE(paths.for_each_taut_path(a, b, longest, 1000000, [&](const Polyline& line) {
    EXPECT_GE(length(line), found.empty() ? 0 : length(found.back()) * (1 - 1e-12));
    found.push_back(line);
    return true;
  }));
  classes += expected.size();
  const auto text = [](const Polyline& line) {
    std::ostringstream out;
    for (const Point& p : line) out << p.transpose() << "; ";
    return out.str();
  };
  std::vector<std::string> expected_texts, found_texts;
  for (const Polyline& line : expected) expected_texts.push_back(text(line));
  for (const Polyline& line : found) found_texts.push_back(text(line));
  EXPECT_THAT(found_texts, testing::UnorderedElementsAreArray(expected_texts));
}

TEST(ShortestPaths, AllClassesAgreeWithTheVisibilityGraph) {
  std::size_t classes = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare_classes(clutter_box(rng, rng.between(1, 3), rng.between(1, 2), seed % 2 == 0), rng, classes);
  }
  EXPECT_GT(classes, 2500u);
}

TEST(ShortestPaths, ClassesEndWhereTheVisitorOrTheBudgetDoes) {
  const Region region{{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 2}, {4, 9}, {6, 9}, {6, 2}}}}}};
  const ShortestPaths paths(region, 1e-9);
  const auto count = [&](std::size_t wanted, std::size_t budget, double longest, bool& all) {
    std::size_t n = 0;
    all = paths.for_each_taut_path({1, 5}, {9, 5}, longest, budget, [&](const Polyline&) { return ++n < wanted; });
    return n;
  };
  bool all = false;
  EXPECT_EQ(count(5, 100000, kInf, all), 5u);  // round and round: endlessly many
  EXPECT_TRUE(all);
  EXPECT_EQ(count(100, 100000, 15, all), 2u);
  EXPECT_TRUE(all);
  EXPECT_LT(count(1000, 50, kInf, all), 50u);
  EXPECT_FALSE(all);
  // Nothing that first bends at a lower corner.
  std::vector<double> lengths;
  EXPECT_TRUE(paths.for_each_taut_path(
      {1, 5}, {9, 5}, 15, 100000, [&](const Polyline& line) { return lengths.push_back(length(line)), true; },
      [](const Polyline& beginning) { return beginning.back().y() > 5; }));
  ASSERT_EQ(lengths.size(), 1u);
  EXPECT_NEAR(lengths[0], 2 + 10, 1e-12);
}

}  // namespace
}  // namespace oxturn

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "algorithms/transit/component_links.hpp"
#include "algorithms/transit/connector.hpp"
#include "algorithms/transit/nearest_component.hpp"
#include "algorithms/transit/triangle_groups.hpp"
#include "base/disjoint_sets.hpp"
#include "base/graph_search.hpp"
#include "base/random.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

TEST(Connector, GoesStraightWherePossible) {
  const Problem p = drawn({"....", "....", "...."});
  const Connector c(p);
  EXPECT_TRUE(c.straight({0.5, 0.5}, {3.5, 2.5}));
  EXPECT_EQ(c.path({0.5, 0.5}, {3.5, 2.5}).size(), 2u);
  EXPECT_DOUBLE_EQ(c.length({0.5, 0.5}, {3.5, 0.5}), 3);
}

// Around the end of a wall 1 m thick with a robot of 0.2 m. Oracle: tangents and arcs.
TEST(Connector, GoesAroundTheEndOfAWall) {
  const Problem p = drawn({"S....", ".....", "..#..", "..#..", "..#.."});
  const Connector c(p);
  const Point a(1.5, 0.5), b(3.5, 0.5);
  EXPECT_FALSE(c.straight(a, b));
  // From a to the arc around (2, 3), the corner of the wall: a tangent and the arc; 1 m along the wall; the mirror
  // image.
  const double d = std::hypot(0.5, 2.5), r = 0.2;
  const double tangent = std::sqrt(d * d - r * r);
  const double turn = std::atan2(2.5, 0.5) + std::asin(r / d);
  EXPECT_NEAR(c.length(a, b), 2 * (tangent + r * turn) + 1, 2e-3);
  EXPECT_NEAR(length(c.path(a, b)), c.length(a, b), 1e-12);
  EXPECT_EQ(c.length(a, b, 3), std::numeric_limits<double>::infinity());
}

TEST(Connector, PointsThatAreNotConnectedAreOneSentence) {
  const Problem p = drawn({"S#."});
  const Connector c(p);
  EXPECT_THAT(
      [&] {
        c.path({0.5, 0.5}, {2.5, 0.5});
      },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("no path from (0.5, 0.5) to (2.5, 0.5)")));
}

Problem with_scattered_walls(Rng& rng, std::size_t rows = 9, std::size_t columns = 12) {
  std::vector<std::string> drawing(rows, std::string(columns, '.'));
  for (std::string& row : drawing)
    for (char& c : row)
      if (rng.chance(0.25)) c = '#';
  drawing[4][6] = 'S';
  return drawn(drawing);
}

Point free_point(const Problem& problem, Rng& rng, const Box& box = {{0, 0}, {12, 9}}) {
  for (;;)
    if (const Point p = box.low + box.size().cwiseProduct(Point(rng.unit(), rng.unit())); problem.walls().contains(p))
      return p;
}

// --- nearest component ---

/// Metres to the nearest entry that is left, by the paths to all.
double metres_to_nearest(const Problem& problem, const Point& from, const std::vector<Point>& entries,
                         const std::vector<bool>& left) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (const auto path = problem.transit().path(from, entries[k]); left[k] && path)
      least = std::min(least, length(*path));
  return least;
}

TEST(NearestComponent, IsNearestByPath) {
  std::size_t queries = 0, nearest_of_all = 0;
  for (const auto seed : seeds(100)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Problem problem = with_scattered_walls(rng);
    NearestComponent nearest(problem);
    std::vector<Point> entries;
    for (int k = 0; k < 16; ++k) {
      entries.push_back(free_point(problem, rng));
      nearest.add(entries.back(), k / 2, entries.size() - 1);
    }
    std::vector<bool> left(entries.size(), true);
    for (int k = 0; k < 8; ++k, ++queries) {
      const Point from = free_point(problem, rng);
      const double least = metres_to_nearest(problem, from, entries, left);
      const auto found = nearest.from(from);
      ASSERT_EQ(found.has_value(), std::isfinite(least));
      if (!found) break;
      ASSERT_TRUE(left[found->id]) << "removed";
      EXPECT_EQ(found->path.front(), from);
      EXPECT_EQ(found->path.back(), entries[found->id]);
      EXPECT_LE(length(found->path), 1.3 * least + 1e-9);
      nearest_of_all += length(found->path) <= least * (1 + 1e-9);
      left[found->id / 2 * 2] = left[found->id / 2 * 2 + 1] = false;
      nearest.remove(static_cast<int>(found->id / 2));
    }
  }
  EXPECT_GE(nearest_of_all, 0.99 * static_cast<double>(queries));
}

/// The same by sight and by the wave, whose paths are those through the triangles by which it came.
TEST(NearestComponent, WithoutAPathIsAboutTheNearest) {
  double found = 0, shortest = 0;
  for (const auto seed : seeds(100)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Problem problem = with_scattered_walls(rng);
    NearestComponent nearest(problem);
    std::vector<Point> entries;
    for (int k = 0; k < 16; ++k) {
      entries.push_back(free_point(problem, rng));
      nearest.add(entries.back(), k, entries.size() - 1);
    }
    const Point from = free_point(problem, rng);
    const double least = metres_to_nearest(problem, from, entries, std::vector<bool>(entries.size(), true));
    const auto id = nearest.nearest(from);
    ASSERT_EQ(id.has_value(), std::isfinite(least));
    if (!id) continue;
    const double metres = length(*problem.transit().path(from, entries[*id]));
    EXPECT_LE(metres, 1.5 * least + 0.5);
    found += metres;
    shortest += least;
  }
  EXPECT_LE(found, 1.03 * shortest);
}

/// Beyond thousands of triangles it is found by groups of them.
TEST(NearestComponent, IsFoundFarAway) {
  double found = 0, shortest = 0;
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Problem problem = with_scattered_walls(rng, 80, 160);
    ASSERT_GT(problem.transit().mesh().triangles().size(), 8192u) << "more than a wave looks at";
    NearestComponent nearest(problem);
    std::vector<Point> entries;
    for (int k = 0; k < 6; ++k) {
      entries.push_back(free_point(problem, rng, {{150, 0}, {160, 80}}));
      nearest.add(entries.back(), k, entries.size() - 1);
    }
    std::vector<bool> left(entries.size(), true);
    for (int k = 0; k < 3; ++k) {
      const Point from = free_point(problem, rng, {{0, 0}, {20, 80}});
      const double least = metres_to_nearest(problem, from, entries, left);
      const auto id = nearest.nearest(from);
      const auto with_path = nearest.from(from);
      ASSERT_EQ(id.has_value(), std::isfinite(least));
      ASSERT_EQ(with_path.has_value(), std::isfinite(least));
      if (!id) continue;
      ASSERT_TRUE(left[*id] && left[with_path->id]) << "removed";
      EXPECT_EQ(with_path->path.back(), entries[with_path->id]);
      EXPECT_LE(length(*problem.transit().path(from, entries[*id])), 1.1 * least);
      found += length(with_path->path);
      shortest += least;
      left[with_path->id] = false;
      nearest.remove(static_cast<int>(with_path->id));
    }
  }
  EXPECT_LE(found, 1.01 * shortest);
}

TEST(NearestComponent, OfNoneIsNone) {
  const Problem problem = drawn({"S..#.", "...#."});
  NearestComponent nearest(problem);
  EXPECT_FALSE(nearest.from({0.5, 0.5}));
  nearest.add({4.5, 0.5}, 0, 7);  // behind the wall
  EXPECT_FALSE(nearest.from({0.5, 0.5}));
  nearest.add({1.5, 0.5}, 1, 8);
  EXPECT_EQ(nearest.from({0.5, 0.5})->id, 8u);
}

// --- groups of triangles ---

// Each is connected and small enough, and its neighbours are those with which it shares a side.
TEST(TriangleGroups, AreConnectedAndKnowTheirNeighbours) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Problem problem = with_scattered_walls(rng, 20, 30);
    const Mesh& mesh = problem.transit().mesh();
    const std::size_t n = mesh.triangles().size(), size = 1 + rng.below(40);
    const TriangleGroups groups(mesh, size);
    std::vector<std::size_t> members(groups.count(), 0);
    std::set<std::pair<std::uint32_t, std::uint32_t>> beside, named;
    const auto for_each_side = [&](std::size_t t, const auto& f) {
      for (const std::int32_t next : mesh.triangles()[t].neighbour)
        if (next != Mesh::kWall) f(static_cast<std::size_t>(next));
    };
    for (std::size_t t = 0; t < n; ++t) {
      ++members.at(groups.of(t));
      for_each_side(t, [&](std::size_t next) {
        if (groups.of(next) != groups.of(t)) beside.emplace(groups.of(t), groups.of(next));
      });
    }
    for (std::uint32_t g = 0; g < groups.count(); ++g)
      for (const std::uint32_t next : groups.neighbours(g)) named.emplace(g, next);
    EXPECT_EQ(named, beside);
    EXPECT_GE(std::ranges::min(members), 1u);
    EXPECT_LE(std::ranges::max(members), size);
    const auto parts = connected_components(n, [&](std::size_t t, const auto& reach) {
      for_each_side(t, [&](std::size_t next) {
        if (groups.of(next) == groups.of(t)) reach(next);
      });
    });
    EXPECT_EQ(static_cast<std::size_t>(parts.count), groups.count());
  }
}

// --- links ---

/// Length of a minimum spanning tree of the components, by the shortest paths between all pairs of their points.
double spanning_length(const Problem& problem, const std::vector<Point>& points, const std::vector<int>& component) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> edges;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (const auto path = problem.transit().path(points[a], points[b])) edges.emplace_back(length(*path), a, b);
  std::sort(edges.begin(), edges.end());
  DisjointSets joined(points.size());
  double sum = 0;
  for (const auto& [away, a, b] : edges)
    if (joined.unite(static_cast<std::size_t>(component[a]), static_cast<std::size_t>(component[b]))) sum += away;
  return sum;
}

TEST(ComponentLinks, AreASpanningTreeHardlyLongerThanTheShortest) {
  double found = 0, shortest = 0;
  for (const auto seed : seeds(300)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Problem problem = with_scattered_walls(rng);
    const int components = rng.between(1, 8);
    std::vector<Point> points;
    std::vector<int> component;
    ComponentLinks links(problem);
    while (points.size() < 24) {
      const Point p = free_point(problem, rng);
      component.push_back(points.size() < static_cast<std::size_t>(components) ? static_cast<int>(points.size())
                                                                               : rng.between(0, components - 1));
      links.add(p, component.back(), points.size());
      points.push_back(p);
    }
    std::set<int> reached{0};
    double sum = 0;
    for (const ComponentLinks::Link& link : links.tree(0)) {
      EXPECT_TRUE(reached.contains(component[link.from])) << "parents come first";
      EXPECT_TRUE(reached.insert(component[link.to]).second) << "reached twice";
      EXPECT_EQ(link.path.front(), points[link.from]);
      EXPECT_EQ(link.path.back(), points[link.to]);
      sum += length(link.path);
    }
    EXPECT_EQ(reached.size(), static_cast<std::size_t>(components));
    const double least = spanning_length(problem, points, component);
    EXPECT_GE(sum, least * (1 - 1e-9));
    EXPECT_LE(sum, least * 2 + 0.5);
    found += sum;
    shortest += least;
  }
  EXPECT_LE(found, 1.05 * shortest);
}

// Entry points of the largest component that are far from all others are left out at first.
TEST(ComponentLinks, ConnectComponentsFarApart) {
  Robot robot;
  const Problem problem(Map{"corridor", {{{{{0, 0}, {90, 0}, {90, 2}, {0, 2}}, {}}}}, "", ""}, robot, Point(1, 1));
  for (const int root : {0, 1, 2}) {
    ComponentLinks links(problem);
    links.add({1, 1}, 0, 0);
    links.add({2, 1}, 0, 1);
    links.add({3, 1}, 0, 2);
    links.add({88, 1}, 1, 3);
    links.add({45, 1}, 2, 4);
    double sum = 0;
    for (const ComponentLinks::Link& link : links.tree(root)) sum += length(link.path);
    EXPECT_NEAR(sum, 85, 1e-6);
  }
}

TEST(ComponentLinks, OfARootWithoutEntriesAreNone) {
  const Problem problem = drawn({"S..", "..."});
  EXPECT_TRUE(ComponentLinks(problem).tree(3).empty());
}

}  // namespace
}  // namespace oxturn

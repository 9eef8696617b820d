#include "geometry/paths/shortest_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/predicates.hpp"
#include "geometry/raster.hpp"
#include "geometry/tether/geodesic_field.hpp"
#include "paths_oracle.hpp"
#include "random_region.hpp"
#include "taut_paths.hpp"

namespace oxturn {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

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

/// Ends anywhere, at corners, on walls, and on edges of the mesh.
Point any_end(Rng& rng, const PathsOracle& oracle, const Mesh& mesh, const Box& box) {
  for (int k = 0; k < 10; ++k) {
    const auto on = [&](const Point& p, const Point& q) { return lerp(p, q, rng.chance(0.5) ? 0.5 : rng.unit()); };
    const auto corner = [&] { return oracle.corners()[rng.below(oracle.corners().size())]; };
    Point p = corner();
    switch (rng.between(0, 4)) {
      case 0:
        return p;
      case 1: {
        const EdgeIndex::Edge& e = oracle.index().edges()[rng.below(oracle.index().edges().size())];
        p = on(e.a, e.b);
        break;
      }
      case 2:
        p = on(p, corner());
        break;
      case 3: {
        const Mesh::Triangle& t = mesh.triangles()[rng.below(mesh.triangles().size())];
        const auto at = [&](std::size_t i) { return mesh.points()[static_cast<std::size_t>(t.vertex[i % 3])]; };
        const std::size_t i = rng.below(3);
        p = on(at(i), at(i + 1));
        break;
      }
      default:
        p = Point(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
        if (!oracle.pinches().empty() && rng.chance(0.3)) p = oracle.pinches()[rng.below(oracle.pinches().size())];
    }
    if (oracle.index().contains(p)) return p;
  }
  return oracle.corners().front();  // little free space
}

/// Paths from each of `starts` points to six others, against the oracle: as long, in the region, none where there is
/// none.
void compare(const Region& region, Rng& rng, int starts) {
  if (region.empty()) return;
  const PathsOracle oracle(region);
  const ShortestPaths paths(region, 1e-9);
  const Box box = bounding_box(region);
  for (int q = 0; q < 6 * starts;) {
    const Point a = any_end(rng, oracle, paths.mesh(), box);
    const std::vector<double> far = oracle.from(a);
    for (int k = 0; k < 6; ++k, ++q) {
      const Point b = any_end(rng, oracle, paths.mesh(), box);
      SCOPED_TRACE(testing::Message() << "query " << q << " from " << a.transpose() << " to " << b.transpose());
      const double best = oracle.between(far, a, b);
      const auto path = paths.path(a, b), back = paths.path(b, a);
      ASSERT_EQ(path.has_value(), best < PathsOracle::kFar);
      ASSERT_EQ(back.has_value(), path.has_value());
      if (!path) continue;
      expect_valid(*path, a, b, oracle.index());
      EXPECT_NEAR(length(*path), best, 1e-9 * best + 1e-12);
      EXPECT_NEAR(length(*back), best, 1e-9 * best + 1e-12);
      EXPECT_EQ(paths.path(a, b, length(*path)), path);
      if (best > 0) { EXPECT_FALSE(paths.path(a, b, best * (1 - 1e-8))); }
    }
  }
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphAmongConvexHoles) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(clutter_box(rng, rng.between(1, 4), rng.between(1, 4), false), rng, 2);
  }
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphOnALattice) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(clutter_box(rng, rng.between(1, 4), rng.between(1, 4), true), rng, 2);
  }
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphInStars) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(star_region(rng, rng.between(5, 40)), rng, 2);
  }
}

Region noise(Rng& rng, int most, double walls) {
  BitGrid grid({0, 0}, 1, rng.between(1, most), rng.between(1, most));
  for (auto& bit : grid.bits) bit = rng.chance(1 - walls);
  return trace(grid);
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphBetweenCells) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(noise(rng, 8, rng.between(0.05, 0.5)), rng, 2);
  }
}

// Space of a robot nearly as wide as its passages, down to 1e-8 of them.
TEST(ShortestPaths, AgreesWithAVisibilityGraphInNarrowSpace) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region cells = noise(rng, 5, rng.between(0.05, 0.35));
    const double radius = 0.5 - std::pow(10, rng.between(-8.0, -1.0));
    Region space = erode(cells, radius, 0.02, Bound::inside);
    if (rng.chance(0.3)) space = transformed(space, rng.between(0.0, 6.0), {rng.between(-99.0, 99.0), 7});
    compare(space, rng, 2);
  }
}

// Holes that touch each other and the outer ring, at corners and along the middle of edges; some close free space off.
TEST(ShortestPaths, AgreesWithAVisibilityGraphWhereRingsTouch) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const int columns = rng.between(1, 4), rows = rng.between(1, 4);
    Polygon p{{{0, 0}, {1.0 * columns, 0}, {1.0 * columns, 1.0 * rows}, {0, 1.0 * rows}}, {}};
    const auto quarter = [&] { return 0.25 * rng.between(1, 3); };
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        if (!rng.chance(0.7)) continue;
        Ring hole{{0, quarter()}, {quarter(), 1}, {1, quarter()}, {quarter(), 0}};  // clockwise
        const double size = rng.chance(0.7) ? 1 : 0.5;
        for (Point& c : hole) c = Point(i, j) + Point(0.5, 0.5) + size * (c - Point(0.5, 0.5));
        p.holes.push_back(hole);
      }
    compare({{p}}, rng, 2);
  }
}

TEST(ShortestPaths, AgreesWithAVisibilityGraphInPetalsThatTouchInOnePoint) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const int petals = rng.between(2, 5);
    Ring ring;
    for (int k = 0; k < petals; ++k) {
      ring.push_back({0, 0});
      const int corners = rng.between(2, 5);
      for (int i = 0; i < corners; ++i) {
        const double angle = 2 * kPi * (k + 0.1 + 0.7 * (i + 0.5 * rng.unit()) / corners) / petals;
        ring.push_back(rng.between(0.5, 3.0) * Point(std::cos(angle), std::sin(angle)));
      }
    }
    compare({{{ring, {}}}}, rng, 2);
  }
}

// Regression: without holes, a path from an inner edge of the mesh went round by that edge's end.
TEST(ShortestPaths, LeavesAnEdgeOfTheMeshOnBothSides) {
  const Region bend{{{{{0, 0}, {4, 0}, {4, 1.25}, {2, 1.5}, {1.5, 2}, {1.25, 4}, {0, 4}}, {}}}};
  const ShortestPaths paths(bend, 1e-9);
  for (const Point& b : {Point(3.5, 0.25), Point(0.25, 3.5)})
    for (const Point& a : {Point(1, 0.75), Point(0.75, 1)}) {
      EXPECT_EQ(paths.path(a, b), (Polyline{a, b}));
      EXPECT_EQ(paths.path(b, a), (Polyline{b, a}));
    }
}

// Regression: with both ends in line with an edge of the mesh, one on either side of it by rounding, the search took
// the path for too long.
TEST(ShortestPaths, TheStraightPathAlongAnEdgeOfTheMeshIsNotTooLong) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region region = star_region(rng, 6);
    const ShortestPaths paths(region, 1e-9);
    const Mesh::Triangle& t = paths.mesh().triangles()[rng.below(paths.mesh().triangles().size())];
    const std::size_t i = rng.below(3);
    if (t.neighbour[i] == Mesh::kWall) continue;
    const auto at = [&](std::size_t k) { return paths.mesh().points()[static_cast<std::size_t>(t.vertex[k % 3])]; };
    const Point a = lerp(at(i + 1), at(i + 2), rng.unit()), b = lerp(at(i + 1), at(i + 2), rng.unit());
    double first = kInf;
    EXPECT_TRUE(paths.for_each_taut_path(a, b, distance(a, b) * (1 + 1e-9), 10000, [&](const Polyline& line) {
      first = length(line);
      return false;
    }));
    EXPECT_NEAR(first, distance(a, b), 1e-9);
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

// From nothing known to the exact length: a bound decides only what is searched.
TEST(ShortestPaths, ALowerBoundOfTheRestChangesNoLength) {
  Rng rng(5);
  for (int round = 0; round < 30; ++round) {
    const Region region = clutter_box(rng, 6, 6, round % 2 == 0);
    const EdgeIndex index(region);
    const ShortestPaths paths(region, 0);
    for (int k = 0; k < 10; ++k) {
      const Point a(rng.between(0.0, 6.0), rng.between(0.0, 6.0)), b(rng.between(0.0, 6.0), rng.between(0.0, 6.0));
      const auto plain = paths.path(a, b);
      if (!plain) continue;
      const GeodesicField field(region, b, {}, 1e-9);
      const double share = rng.chance(0.5) ? 1 : rng.unit();
      int asked = 0;
      const auto path = paths.path(a, b, std::numeric_limits<double>::infinity(), [&](const Point& p) {
        ++asked;
        return share * field.distance(p);
      });
      ASSERT_TRUE(path.has_value());
      expect_valid(*path, a, b, index);
      EXPECT_NEAR(length(*path), length(*plain), 1e-9);
      EXPECT_TRUE(asked > 0 || path->size() == 2);
    }
  }
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

TEST(ShortestPaths, DoesNotDependOnPositionTurnOrScale) {
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

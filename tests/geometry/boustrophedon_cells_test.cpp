#include <gtest/gtest.h>

#include <stdexcept>

#include "geometry/edge_index.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/mesh/partition.hpp"
#include "random_region.hpp"

namespace oxturn {
namespace {

double cell_area(const BoustrophedonCell& c) {
  Ring ring = c.lower;
  ring.insert(ring.end(), c.upper.rbegin(), c.upper.rend());
  return signed_area(ring);
}

double height_at(const Polyline& chain, double x) {
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (chain[i].x() >= x && chain[i].x() > chain[i - 1].x()) {
      return lerp(chain[i - 1], chain[i], (x - chain[i - 1].x()) / (chain[i].x() - chain[i - 1].x())).y();
    }
  }
  return chain.back().y();
}

std::size_t cell_components(const std::vector<BoustrophedonCell>& cells) {
  std::vector<bool> seen(cells.size(), false);
  std::size_t count = 0;
  for (std::size_t s = 0; s < cells.size(); ++s) {
    if (seen[s]) continue;
    ++count;
    std::vector<std::size_t> stack{s};
    seen[s] = true;
    while (!stack.empty()) {
      const std::size_t i = stack.back();
      stack.pop_back();
      for (const std::size_t n : cells[i].neighbours) {
        if (seen[n]) continue;
        seen[n] = true;
        stack.push_back(n);
      }
    }
  }
  return count;
}

std::size_t mesh_components(const Region& region) {
  const Mesh mesh(region);
  std::vector<bool> seen(mesh.triangles().size(), false);
  std::size_t count = 0;
  for (std::size_t s = 0; s < seen.size(); ++s) {
    if (seen[s]) continue;
    ++count;
    std::vector<std::size_t> stack{s};
    seen[s] = true;
    while (!stack.empty()) {
      const std::size_t i = stack.back();
      stack.pop_back();
      for (const std::int32_t n : mesh.triangles()[i].neighbour) {
        if (n == Mesh::kWall || seen[static_cast<std::size_t>(n)]) continue;
        seen[static_cast<std::size_t>(n)] = true;
        stack.push_back(static_cast<std::size_t>(n));
      }
    }
  }
  return count;
}

std::vector<BoustrophedonCell> check(const Region& region) {
  const auto cells = boustrophedon_cells(region);
  const double whole = area(region);
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const BoustrophedonCell& c = cells[i];
    EXPECT_GE(c.lower.size(), 2u);
    EXPECT_GE(c.upper.size(), 2u);
    EXPECT_EQ(c.lower.front().x(), c.upper.front().x());
    EXPECT_EQ(c.lower.back().x(), c.upper.back().x());
    EXPECT_LT(c.lower.front().x(), c.lower.back().x());
    for (const Polyline* chain : {&c.lower, &c.upper}) {
      for (std::size_t k = 1; k < chain->size(); ++k) {
        EXPECT_LE((*chain)[k - 1].x(), (*chain)[k].x());
        EXPECT_NE((*chain)[k - 1], (*chain)[k]);
      }
      EXPECT_LT(chain->front().x(), (*chain)[1].x());
      EXPECT_LT((*chain)[chain->size() - 2].x(), chain->back().x());
    }
    for (int k = 1; k < 8; ++k) {
      const double x = c.lower.front().x() + k / 8.0 * (c.lower.back().x() - c.lower.front().x());
      EXPECT_LE(height_at(c.lower, x), height_at(c.upper, x) + 1e-9);
    }
    sum += cell_area(c);
    EXPECT_TRUE(std::is_sorted(c.neighbours.begin(), c.neighbours.end()));
    for (const std::size_t n : c.neighbours) {
      EXPECT_NE(n, i);
      const auto& back = cells[n].neighbours;
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), i));
      const bool right = c.lower.back().x() == cells[n].lower.front().x();
      const bool left = c.lower.front().x() == cells[n].lower.back().x();
      EXPECT_TRUE(left || right);
    }
  }
  EXPECT_NEAR(sum, whole, 1e-9 * whole);
  EXPECT_EQ(cell_components(cells), mesh_components(region));
  return cells;
}

TEST(BoustrophedonCells, ConvexHolesInGeneralPositionGiveThreeMoreEach) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region region = clutter_box(rng, rng.between(1, 7), rng.between(1, 7), false);
    EXPECT_EQ(check(region).size(), 3 * hole_count(region) + 1);
  }
}

TEST(BoustrophedonCells, LatticesStarsAndTurnedLattices) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region lattice = clutter_box(rng, rng.between(1, 7), rng.between(1, 7), true);
    EXPECT_LE(check(lattice).size(), 3 * hole_count(lattice) + 1);
    const Region turned = transformed(lattice, rng.between(0.1, 1.4), {1e3, -1e3});
    EXPECT_EQ(check(turned).size(), 3 * hole_count(lattice) + 1);
    check(transformed(lattice, kPi / 2, {0, 0}));  // nearly vertical walls
    check(star_region(rng, rng.between(4, 60)));
  }
}

TEST(BoustrophedonCells, ARectangleIsOneCellWithTwoChains) {
  const auto cells = check(box_region({1, 2}, {5, 4}));
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].lower, (Polyline{{1, 2}, {5, 2}}));
  EXPECT_EQ(cells[0].upper, (Polyline{{1, 4}, {5, 4}}));
}

TEST(BoustrophedonCells, StepsInFloorAndCeilingDoNotCut) {
  const auto cells = check(
      Region{{{{{0, 0}, {2, 0}, {2, 1}, {4, 1}, {4, 0}, {6, 0}, {6, 5}, {5, 5}, {5, 4}, {3, 4}, {3, 5}, {0, 5}}, {}}}});
  EXPECT_EQ(cells.size(), 1u);
}

TEST(BoustrophedonCells, ASquareHoleHasFourCellsInARing) {
  const auto cells = check(Region{{{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}});
  ASSERT_EQ(cells.size(), 4u);
  for (const auto& c : cells) EXPECT_EQ(c.neighbours.size(), 2u);
  // Two square holes above one another cut at the same x, in three lanes.
  EXPECT_EQ(check(Region{{{{{0, 0}, {3, 0}, {3, 5}, {0, 5}},
                           {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{1, 3}, {1, 4}, {2, 4}, {2, 3}}}}}})
                .size(),
            5u);
}

TEST(BoustrophedonCells, TakesRingsThatTouch) {
  // Holes that meet in corners (side by side and one above the other), in a border's middle, and polygons that meet.
  check(Region{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                 {{{1, 4}, {2, 5}, {3, 4}, {2, 3}},
                  {{3, 4}, {4, 5}, {5, 4}, {4, 3}},
                  {{2, 5}, {1, 6}, {2, 7}, {3, 6}},
                  {{7, 7}, {9, 8}, {8, 6}},
                  {{6, 2}, {8, 2}, {7, 0}}}}}});
  Region board;
  for (int j = 0; j < 6; ++j) {
    for (int i = j % 2; i < 6; i += 2) {
      board.polygons.push_back({{{1.0 * i, 1.0 * j}, {i + 1.0, 1.0 * j}, {i + 1.0, j + 1.0}, {1.0 * i, j + 1.0}}, {}});
    }
  }
  EXPECT_EQ(check(board).size(), 18u);
  EXPECT_EQ(check(transformed(board, 0.5, {0, 0})).size(), 18u);
}

TEST(BoustrophedonCells, EdgesThatCrossAreOneSentence) {
  EXPECT_TRUE(boustrophedon_cells(Region{}).empty());
  EXPECT_THROW(boustrophedon_cells(Region{{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}}), std::invalid_argument);
  EXPECT_THROW(boustrophedon_cells(Region{{{{{0, 0}, {std::nan(""), 2}, {2, 0}}, {}}}}), std::invalid_argument);
}

// All cuts undone that no critical point asks for: what is left are the boustrophedon cells.
TEST(TrapezoidCells, JoinedTheyAreTheBoustrophedonCells) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    const Region region = transformed(clutter_box(rng, 4, 4, false), 0.3, {0, 0});
    const auto by_corner = [](const BoustrophedonCell& a, const BoustrophedonCell& b) {
      return before(a.lower.front(), b.lower.front());
    };
    auto joined = trapezoid_cells(region, 1e9), cells = boustrophedon_cells(region);
    ASSERT_EQ(joined.size(), cells.size()) << seed;
    std::sort(joined.begin(), joined.end(), by_corner);
    std::sort(cells.begin(), cells.end(), by_corner);
    for (std::size_t k = 0; k < cells.size(); ++k) EXPECT_NEAR(cell_area(joined[k]), cell_area(cells[k]), 1e-9);
  }
}

TEST(TrapezoidCells, AreThePartitionWithNeighbours) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    const Region region = transformed(clutter_box(rng, 4, 4, false), 0.3, {0, 0});
    const auto cells = trapezoid_cells(region);
    EXPECT_EQ(cells.size(), trapezoid_partition(region).size());
    EXPECT_EQ(cell_components(cells), mesh_components(region));
  }
}

TEST(TrapezoidCells, NarrowOnesAreJoinedWhereNoCriticalPointIsBetween) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    const Region region = transformed(clutter_box(rng, 4, 4, false), 0.3, {0, 0});
    const auto narrow = [](const std::vector<BoustrophedonCell>& cells, double width) {
      return std::count_if(cells.begin(), cells.end(), [&](const BoustrophedonCell& c) {
        return c.lower.back().x() - c.lower.front().x() < width;
      });
    };
    const auto cells = trapezoid_cells(region, 0.4);
    EXPECT_LE(narrow(cells, 0.4), narrow(boustrophedon_cells(region), 0.4));
    double all = 0;
    for (const BoustrophedonCell& c : cells) all += cell_area(c);
    EXPECT_NEAR(all, area(region), 1e-9 * area(region));
  }
}

}  // namespace
}  // namespace oxturn

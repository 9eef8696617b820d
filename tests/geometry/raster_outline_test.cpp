#include <gtest/gtest.h>

#include <set>

#include "geometry/overlay/validity.hpp"
#include "geometry/raster.hpp"
#include "geometry/trace.hpp"
#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

BitGrid drawn(const std::vector<std::string>& rows) {  // the first row is the top
  BitGrid g({0, 0}, 1, static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int j = 0; j < g.rows; ++j)
    for (int i = 0; i < g.columns; ++i)
      g.set(i, j, rows[static_cast<std::size_t>(g.rows - 1 - j)][static_cast<std::size_t>(i)] == '.');
  return g;
}

std::size_t flood_parts(const BitGrid& grid) {  // 4-connected
  BitGrid left = grid;
  std::size_t parts = 0;
  std::vector<std::pair<int, int>> todo;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      if (!left.get(i, j)) continue;
      ++parts;
      todo.push_back({i, j});
      while (!todo.empty()) {
        const auto [x, y] = todo.back();
        todo.pop_back();
        if (!left.get(x, y)) continue;
        left.set(x, y, false);
        for (const auto& [u, v] : {std::pair(x + 1, y), std::pair(x - 1, y), std::pair(x, y + 1), std::pair(x, y - 1)})
          todo.push_back({u, v});
      }
    }
  return parts;
}

TEST(Trace, DrawnShapes) {
  EXPECT_TRUE(trace(drawn({"##", "##"})).empty());
  const Region box = trace(drawn({"....", "....", "...."}));
  ASSERT_EQ(box.polygons.size(), 1u);
  EXPECT_EQ(box.polygons[0].outer.size(), 4u);
  const Region nested = trace(drawn({".......", ".#####.", ".#...#.", ".#.#.#.", ".#...#.", ".#####.", "......."}));
  ASSERT_EQ(nested.polygons.size(), 2u);
  EXPECT_EQ(nested.polygons[0].holes.size(), 1u);
  EXPECT_EQ(nested.polygons[1].holes.size(), 1u);
  EXPECT_EQ(area(nested), 24 + 8);
}

TEST(Trace, CellsThatShareACornerAreApart) {
  EXPECT_EQ(trace(drawn({"#.", ".#"})).polygons.size(), 2u);
  EXPECT_EQ(trace(drawn({".#", "#."})).polygons.size(), 2u);
  // Two clear cells that share a corner: two holes that touch.
  const Region two = trace(drawn({"....", ".#..", "..#.", "...."}));
  EXPECT_EQ(hole_count(two), 2u);
  // A clear cell that touches the outside in a corner: a hole, and an outer ring that does not meet itself.
  const Region pinched = trace(drawn({"...", ".#.", "#.."}));
  ASSERT_EQ(pinched.polygons.size(), 1u);
  EXPECT_EQ(hole_count(pinched), 1u);
  EXPECT_EQ(pinched.polygons[0].outer.size(), 6u);
}

TEST(Trace, GivesTheSameCellsBack) {
  Rng rng(61);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    BitGrid grid = samples::speckled(rng, rng.between(3, 60), 0.05, 30, 6);
    if (round % 2)  // noise: every kind of corner
      for (auto& b : grid.bits) b = rng.chance(0.5) ? 1 : 0;
    const Region r = trace(grid);
    EXPECT_NEAR(area(r), static_cast<double>(grid.count()) * 0.05 * 0.05, 1e-9);
    EXPECT_FALSE(find_flaw(r));
    EXPECT_EQ(r.polygons.size(), flood_parts(grid));
    for (const CellRule rule : {CellRule::centre, CellRule::inside, CellRule::touches})
      EXPECT_EQ(rasterise(r, grid.origin, grid.cell, grid.columns, grid.rows, rule).bits, grid.bits);
    for_each_ring(r, [&](const Ring& ring) {
      std::set<std::pair<double, double>> seen;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
        EXPECT_TRUE(seen.insert({a.x(), a.y()}).second) << "a ring meets itself";
        EXPECT_NE(a.x() == b.x(), b.x() == c.x()) << "a corner in line";
      }
    });
    for (const Polygon& p : r.polygons) {
      EXPECT_GT(signed_area(p.outer), 0);
      for (const Ring& h : p.holes) EXPECT_LT(signed_area(h), 0);
    }
  }
}

}  // namespace
}  // namespace oxturn

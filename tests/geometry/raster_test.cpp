#include "geometry/raster.hpp"

#include <gtest/gtest.h>

#include "geometry/overlay/boolean.hpp"
#include "geometry/raster_rows.hpp"
#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

// The truth: how much of each cell the region fills.
TEST(Rasterise, AgreesWithTheAreaOfEveryCell) {
  Rng rng(51);
  for (int round = 0; round < 12; ++round) {
    const Region r = samples::holed_star(rng, {2, 1.5}, 1.4);
    const Point origin(rng.between(-0.3, 0.3), rng.between(-0.3, 0.3));
    const double cell = rng.between(0.1, 0.3);
    const int columns = 20, rows = 12;
    const BitGrid centre = rasterise(r, origin, cell, columns, rows, CellRule::centre);
    const BitGrid inside = rasterise(r, origin, cell, columns, rows, CellRule::inside);
    const BitGrid touches = rasterise(r, origin, cell, columns, rows, CellRule::touches);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const Point low = origin + cell * Point(i, j);
        const double filled = area(intersect(r, box_region(low, low + Point(cell, cell)))) / (cell * cell);
        if (filled > 1e-6) { EXPECT_TRUE(touches.get(i, j)) << i << ' ' << j; }
        if (filled < 1 - 1e-6) { EXPECT_FALSE(inside.get(i, j)) << i << ' ' << j; }
        if (filled > 1 - 1e-12) { EXPECT_TRUE(touches.get(i, j)); }
        if (inside.get(i, j)) { EXPECT_NEAR(filled, 1, 1e-6) << i << ' ' << j; }
        if (!touches.get(i, j)) { EXPECT_NEAR(filled, 0, 1e-6) << i << ' ' << j; }
        const Point c = centre.centre(i, j);
        if (samples::distance_to_boundary(r, c) > 1e-9) { EXPECT_EQ(centre.get(i, j), samples::sees_all_round(r, c)); }
        if (samples::distance_to_boundary(r, c) > cell) { EXPECT_EQ(inside.get(i, j), touches.get(i, j)); }
      }
  }
}

/// The cells of runs, which must be disjoint and in order.
std::vector<std::uint8_t> cells_of(const RasterRows& rows) {
  std::vector<std::uint8_t> cells;
  for (int j = 0; j < rows.rows(); ++j) {
    std::vector<std::uint8_t> row(static_cast<std::size_t>(rows.columns()));
    int end = -1;
    for (const RasterRows::Run& run : rows.row(j)) {
      EXPECT_LT(end, run.low);
      EXPECT_LT(run.low, run.high);
      end = run.high;
      std::fill(row.begin() + run.low, row.begin() + run.high, std::uint8_t{1});
    }
    cells.insert(cells.end(), row.begin(), row.end());
  }
  return cells;
}

// Also where the region sticks out of the raster, and where edges run through centres, along rows and across.
TEST(RasterRows, HoldTheCellsOfTheRaster) {
  Rng rng(52);
  for (int round = 0; round < 60; ++round) {
    const bool on_centres = round % 2 == 0;
    const Region r = on_centres ? subtract(box_region({0.5, 0.5}, {11.5, 9.5}), box_region({2.5, 3}, {7, 6.5}))
                                : samples::holed_star(rng, {6, 5}, 5);
    const Point origin = on_centres ? Point(round % 4, -1) : Point(rng.between(-2.0, 3.0), rng.between(-2.0, 3.0));
    const double cell = on_centres ? 1 : rng.between(0.05, 0.5);
    const BitGrid grid = rasterise(r, origin, cell, 17, 13, CellRule::centre);
    EXPECT_EQ(cells_of(RasterRows(r, origin, cell, 17, 13)), grid.bits) << round;
  }
}

TEST(Rasterise, CellsOnTheBorderFollowTheRule) {
  const Region box = box_region({1, 1}, {3, 3});
  // Edges along grid lines cut nothing.
  for (const CellRule rule : {CellRule::centre, CellRule::inside, CellRule::touches})
    EXPECT_EQ(rasterise(box, {0, 0}, 1, 4, 4, rule).count(), 4u);
  // Edges through centres: the closed region has those centres.
  EXPECT_EQ(rasterise(box, {0.5, 0.5}, 1, 4, 4, CellRule::centre).count(), 9u);
  EXPECT_EQ(rasterise(box, {0.5, 0.5}, 1, 4, 4, CellRule::inside).count(), 1u);
  EXPECT_EQ(rasterise(box, {0.5, 0.5}, 1, 4, 4, CellRule::touches).count(), 9u);
  const Region diamond{{Polygon{{{2, 0}, {4, 2}, {2, 4}, {0, 2}}, {}}}};
  EXPECT_EQ(rasterise(diamond, {0, 0}, 1, 4, 4, CellRule::inside).count(), 4u);
  EXPECT_EQ(rasterise(diamond, {0, 0}, 1, 4, 4, CellRule::touches).count(), 12u);  // corner cells only touch a corner
  EXPECT_EQ(rasterise(diamond, {0, 0}, 1, 4, 4, CellRule::centre).count(), 12u);   // centres on the slanted edges
}

TEST(Rasterise, CornersAtTheHeightOfCentres) {
  const Region diamond{{Polygon{{{2, 0}, {4, 2}, {2, 4}, {0, 2}}, {}}}};
  const BitGrid g = rasterise(diamond, {-1.5, -1.5}, 1, 8, 7, CellRule::centre);
  for (int j = 0; j < g.rows; ++j)
    for (int i = 0; i < g.columns; ++i)
      EXPECT_EQ(g.get(i, j), std::abs(i - 1 - 2) + std::abs(j - 1 - 2) <= 2) << i << ' ' << j;
}

TEST(Rasterise, TheGridMayBeAnywhere) {
  const Region box = box_region({0, 0}, {10, 10});
  EXPECT_EQ(rasterise(box, {4, 4}, 1, 3, 3, CellRule::inside).count(), 9u);
  EXPECT_EQ(rasterise(box, {-5, 2}, 1, 7, 3, CellRule::centre).count(), 6u);
  EXPECT_EQ(rasterise(box, {20, 20}, 1, 7, 3, CellRule::touches).count(), 0u);
  EXPECT_EQ(rasterise(Region{}, {0, 0}, 1, 7, 3, CellRule::touches).count(), 0u);
  EXPECT_EQ(rasterise(box, {0, 0}, 1, 0, 0, CellRule::centre).count(), 0u);
}

}  // namespace
}  // namespace oxturn

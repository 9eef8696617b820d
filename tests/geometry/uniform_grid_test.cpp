// Which cells a grid visits, against brute force.
#include "geometry/uniform_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "base/math.hpp"
#include "base/random.hpp"
#include "geometry/convex_hull.hpp"
#include "geometry/path.hpp"
#include "geometry/predicates.hpp"
#include "geometry/region.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Point random_point(Rng& rng, double far) { return {rng.between(-far, far), rng.between(-far, far)}; }

double distance_of_segments(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (crossing(a, b, c, d) != Crossing::none) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

/// Of a convex polygon from a box.
double distance_to_box(const std::vector<Point>& shape, const Box& box) {
  const std::vector<Point> sides{box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
  if (box.contains(shape[0])) return 0;
  if (shape.size() > 2 && contains(Region{{{shape, {}}}}, box.low)) return 0;
  double least = 1e300;
  for (std::size_t i = 0; i < shape.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      least =
          std::min(least, distance_of_segments(shape[i], shape[(i + 1) % shape.size()], sides[k], sides[(k + 1) % 4]));
  return least;
}

Box cell_box(const UniformGrid& grid, int i, int j) {
  return {grid.low() + grid.cell() * Point(i, j), grid.low() + grid.cell() * Point(i + 1, j + 1)};
}

/// A point, a segment or a convex polygon, often of the size of a few cells.
std::vector<Point> random_shape(Rng& rng, double cell) {
  const int corners = rng.between(1, 7);
  const Point at = random_point(rng, 12);
  std::vector<Point> points;
  for (int k = 0; k < corners; ++k) points.push_back(at + random_point(rng, rng.chance(0.7) ? 2 * cell : 6));
  return points.size() > 2 ? convex_hull(points) : points;
}

TEST(UniformGrid, VisitsEveryCellNearAShapeOnce) {
  std::size_t shapes_across = 0;
  for (const auto seed : seeds(300)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<Point> points(static_cast<std::size_t>(rng.between(1, 60)));
    for (Point& p : points) p = random_point(rng, 10);
    const UniformGrid grid(points.size(), [&](std::size_t i) { return std::array{points[i]}; });
    for (int round = 0; round < 20; ++round) {
      const std::vector<Point> shape = random_shape(rng, grid.cell());
      const double pad = rng.chance(0.5) ? 0 : rng.unit() * grid.cell();
      std::vector<std::size_t> visited;
      grid.visit(shape, pad, [&](std::size_t cell) {
        visited.push_back(cell);
        return false;
      });
      std::vector<std::uint32_t> in_cells, items;
      for (const std::size_t cell : visited) std::ranges::copy(grid.items(cell), std::back_inserter(in_cells));
      grid.visit_items(shape, pad, [&](std::uint32_t item) {
        items.push_back(item);
        return false;
      });
      EXPECT_EQ(items, in_cells);
      EXPECT_TRUE(std::ranges::is_sorted(visited));
      const std::set<std::size_t> once(visited.begin(), visited.end());
      EXPECT_EQ(once.size(), visited.size());
      std::size_t near = 0, almost = 0;
      for (int j = 0; j < grid.rows(); ++j)
        for (int i = 0; i < grid.columns(); ++i) {
          const double off = distance_to_box(shape, cell_box(grid, i, j));
          almost += off <= std::sqrt(2.0) * (pad + grid.cell());
          if (off > pad) continue;
          ++near;
          EXPECT_EQ(once.count(grid.index(i, j)), 1u) << i << " " << j;
        }
      EXPECT_LE(visited.size(), std::max<std::size_t>(16, almost));
      shapes_across += near > 16;
    }
  }
  EXPECT_GT(shapes_across, 100u);
}

TEST(UniformGrid, StopsWhereAskedTo) {
  const std::vector<Point> points{{0, 0}, {10, 10}, {3, 7}};
  const UniformGrid grid(points.size(), [&](std::size_t i) { return std::array{points[i]}; });
  for (const double far : {0.1, 10.0}) {
    int calls = 0;
    EXPECT_TRUE(grid.visit(std::array{Point(0, 0), Point(far, far)}, 0, [&](std::size_t) { return ++calls == 1; }));
    EXPECT_EQ(calls, 1);
  }
  int items = 0;
  EXPECT_TRUE(
      grid.visit_items(std::array{Point(0, 0), Point(10, 10)}, 10, [&](std::uint32_t) { return ++items == 2; }));
  EXPECT_EQ(items, 2);
  EXPECT_FALSE(grid.visit(std::array{Point(0, 0)}, 0, [](std::size_t) { return false; }));
  EXPECT_FALSE(grid.visit(std::array{Point(20, 0)}, 1, [](std::size_t) { return true; }));
  EXPECT_FALSE(grid.visit(std::array{Point(std::nan(""), 0)}, 1, [](std::size_t) { return true; }));
  EXPECT_FALSE(UniformGrid().visit(std::array{Point(0, 0)}, 1, [](std::size_t) { return true; }));
}

}  // namespace
}  // namespace oxturn

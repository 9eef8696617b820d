#include "geometry/edge_rows.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "random_region.hpp"

namespace oxturn {
namespace {

/// At random points, at vertices, beside them and level with them.
void expect_the_same(const Region& region, Rng& rng, const Box& around) {
  const EdgeRows rows(region);
  const auto compare = [&](const Point& p) { ASSERT_EQ(rows.contains(p), contains(region, p)) << to_text(p); };
  for (int k = 0; k < 200; ++k) compare(around.low + around.size().cwiseProduct(Point(rng.unit(), rng.unit())));
  for_each_edge(region, [&](const Point& a, const Point& b) {
    compare(a);
    compare((a + b) / 2);
    compare({around.low.x() + around.size().x() * rng.unit(), a.y()});
    compare(a + 1e-12 * Point(rng.unit() - 0.5, rng.unit() - 0.5));
  });
}

TEST(EdgeRows, AgreeWithAllEdges) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const int columns = rng.between(1, 6), rows = rng.between(1, 6);
    expect_the_same(clutter_box(rng, columns, rows, rng.chance(0.5)), rng, {{-1, -1}, {columns + 1.0, rows + 1.0}});
    expect_the_same(star_region(rng, rng.between(3, 60)), rng, {{-3, -3}, {3, 3}});
  }
}

TEST(EdgeRows, AreNoMoreThanEdges) {
  // Two slivers, far apart: by their height there would be a million rows.
  const auto sliver = [](double y) { return Polygon{{{0, y}, {1, y}, {1, y + 1e-4}, {0, y + 1e-4}}, {}}; };
  const Region region{{sliver(0), sliver(1e6)}};
  const EdgeRows rows(region);
  for (const Point& p : {Point(0.5, 5e-5), Point(0.5, 1e6 + 5e-5)}) EXPECT_TRUE(rows.contains(p));
  for (const Point& p :
       {Point(0.5, 5e5), Point(0.5, -1), Point(2, 5e-5), Point(0.5, std::numeric_limits<double>::quiet_NaN())})
    EXPECT_FALSE(rows.contains(p));
}

TEST(EdgeRows, OfNothingContainNothing) { EXPECT_FALSE(EdgeRows(Region{}).contains({0, 0})); }

}  // namespace
}  // namespace oxturn

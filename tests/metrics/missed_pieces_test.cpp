// Uncovered pieces of the target: how many, how large, and where.
#include <gtest/gtest.h>

#include "metrics/score.hpp"
#include "shapes.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

double outline_area(const MissedPiece& piece) {
  double sum = 0;
  for (const Ring& ring : piece.outline) sum += area(Region{{Polygon{ring, {}}}});
  return sum;
}

TEST(MissedPieces, OneHoleBetweenLanes) {
  // A tool one metre wide drives round a square; inside, a box of 3 x 3 remains.
  const SweptArea s =
      swept_area(box_region({0, 0}, {5, 5}), 0, 1, work({{0.5, 0.5}, {4.5, 0.5}, {4.5, 4.5}, {0.5, 4.5}, {0.5, 0.5}}));
  ASSERT_EQ(s.missed.size(), 5u);
  EXPECT_NEAR(s.missed[0].area_m2, 9, 1e-6);
  EXPECT_NEAR(outline_area(s.missed[0]), 9, 1e-6);
  EXPECT_TRUE(contains(box_region({1, 1}, {4, 4}), s.missed[0].at));
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(s.missed[i].area_m2, (4 - kPi) / 16, 1e-3) << "a corner of the room";
}

TEST(MissedPieces, NothingCoveredIsOnePieceForEachComponent) {
  for (const double angle : {0.0, 0.3}) {
    Region target = transformed(two_holes(), angle, {3, 1});
    for (const Polygon& p : transformed(box_region({20, 0}, {21, 1}), angle, {3, 1}).polygons)
      target.polygons.push_back(p);
    const SweptArea s = swept_area(target, 0, 0.4, Path{{Leg{false, {{1, 1}, {9, 1}}}}});
    ASSERT_EQ(s.missed.size(), 2u);
    EXPECT_NEAR(s.missed[0].area_m2, area(two_holes()), 1e-6);
    EXPECT_NEAR(outline_area(s.missed[0]), area(two_holes()), 1e-6);
    EXPECT_NEAR(s.missed[1].area_m2, 1, 1e-6);
    for (const MissedPiece& piece : s.missed) EXPECT_TRUE(contains(target, piece.at));
  }
}

TEST(MissedPieces, AreTheSameWithoutOutlines) {
  const Region target = transformed(two_holes(), 0.3, {3, 1});
  const Path path = work({{3, 2}, {8, 4}, {7, 6}});
  const SweptArea with = swept_area(target, 0, 0.4, path),
                  without = swept_area(target, 0, 0.4, path, 0.001, MissedOutlines::left_out);
  ASSERT_EQ(without.missed.size(), with.missed.size());
  ASSERT_FALSE(with.missed.empty());
  for (std::size_t i = 0; i < with.missed.size(); ++i) {
    EXPECT_EQ(without.missed[i].area_m2, with.missed[i].area_m2);
    EXPECT_EQ(without.missed[i].at, with.missed[i].at);
    EXPECT_FALSE(with.missed[i].outline.empty());
    EXPECT_TRUE(without.missed[i].outline.empty());
  }
}

TEST(MissedPieces, AThinWallSeparates) {
  // 1 mm of wall down the middle: two pieces, though one tile contains both sides.
  Region target = box_region({0, 0}, {4, 4});
  target.polygons.push_back(box_region({4.001, 0}, {8, 4}).polygons[0]);
  const SweptArea s = swept_area(target, 0, 0.4, Path{{Leg{false, {{1, 1}, {3, 1}}}}});
  ASSERT_EQ(s.missed.size(), 2u);
  EXPECT_NEAR(s.missed[0].area_m2, 16, 1e-6);
  EXPECT_NEAR(s.missed[1].area_m2, 3.999 * 4, 1e-6);
}

TEST(MissedPieces, SliversAreIgnored) {
  // Lanes from wall to wall that abut exactly.
  Polyline lanes;
  for (int k = 0; k < 8; ++k) {
    lanes.push_back({k % 2 ? 13.0 : -1.0, 0.5 + k});
    lanes.push_back({k % 2 ? -1.0 : 13.0, 0.5 + k});
  }
  EXPECT_TRUE(swept_area(box_region({0, 0}, {12, 8}), 0, 1, work(lanes)).missed.empty());
  // A gap of 2 cm between two lanes is one long piece.
  for (std::size_t k = 8; k < lanes.size(); ++k) lanes[k].y() += 0.02;
  const SweptArea s = swept_area(box_region({0, 0}, {12, 8}), 0, 1, work(lanes));
  ASSERT_EQ(s.missed.size(), 1u);
  EXPECT_NEAR(s.missed[0].area_m2, 12 * 0.02, 1e-6);
}

/// Pieces by flood fill on a grid of points; areas, largest first.
std::vector<double> by_flood_fill(const Region& target, const Path& path, double width, double pitch) {
  const Box box = bounding_box(target);
  const auto nx = static_cast<std::size_t>(box.size().x() / pitch),
             ny = static_cast<std::size_t>(box.size().y() / pitch);
  std::vector<char> open(nx * ny);
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      const Point p = box.low + pitch * Point(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      bool covered = false;
      for (const Leg& leg : path.legs)
        for (std::size_t k = 1; leg.tool && !covered && k < leg.points.size(); ++k)
          covered = distance_to_segment(p, leg.points[k - 1], leg.points[k]) <= width / 2;
      open[j * nx + i] = !covered && contains(target, p);
    }
  std::vector<double> areas;
  for (std::size_t seed = 0; seed < open.size(); ++seed) {
    if (!open[seed]) continue;
    std::vector<std::size_t> stack{seed};
    open[seed] = 0;
    double cells = 0;
    while (!stack.empty()) {
      const std::size_t c = stack.back();
      stack.pop_back();
      ++cells;
      const auto visit = [&](bool there, std::size_t n) {
        if (there && open[n]) open[n] = 0, stack.push_back(n);
      };
      visit(c % nx > 0, c - 1), visit(c % nx + 1 < nx, c + 1), visit(c >= nx, c - nx),
          visit(c + nx < open.size(), c + nx);
    }
    areas.push_back(cells * pitch * pitch);
  }
  std::sort(areas.rbegin(), areas.rend());
  return areas;
}

TEST(MissedPieces, AsByFloodFill) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region target = two_holes();
    const Path path = random_walk(rng, Box{{0, 0}, {10, 8}}, 2, 6, 8);
    const double width = 0.9;
    const SweptArea s = swept_area(target, 0, width, path);
    const std::vector<double> truth = by_flood_fill(target, path, width, 0.02);
    // A passage narrower than the grid's pitch may join or part pieces; so compare sums and the number of clear ones.
    double missed = 0, all = 0;
    for (const MissedPiece& piece : s.missed) {
      EXPECT_NEAR(outline_area(piece), piece.area_m2, 1e-9 * piece.area_m2 + 1e-9);
      EXPECT_TRUE(contains(target, piece.at));
      missed += piece.area_m2;
    }
    for (const double a : truth) all += a;
    EXPECT_NEAR(missed, (1 - s.coverage.middle()) * area(target), 0.01 * area(target));
    EXPECT_NEAR(all, (1 - s.coverage.middle()) * area(target), 0.01 * area(target));
    const double clear = 0.05;
    const auto count = [&](const auto& list, const auto& size) {
      return std::count_if(list.begin(), list.end(), size);
    };
    const auto ours = count(s.missed, [&](const MissedPiece& p) { return p.area_m2 > clear; });
    const auto theirs = count(truth, [&](double a) { return a > clear; });
    EXPECT_NEAR(static_cast<double>(ours), static_cast<double>(theirs), 1);
    if (ours == theirs && ours > 0) { EXPECT_NEAR(s.missed[0].area_m2, truth[0], 0.03 * truth[0] + 0.05); }
  }
}

// Finer arcs cost memory: 2.5 kB a cell on large maps. Their pieces are the same.
TEST(MissedPieces, AreNotCutFinerForACertainInterval) {
  Polyline bends;
  for (int k = 0; k < 40; ++k) bends.push_back({1 + 0.2 * k, 1 + 2.5 * (k % 2)});
  const auto parts = [&](double certainty) {
    std::size_t sum = 0;
    for (const MissedPiece& piece : swept_area(two_holes(), 0, 0.4, work(bends), certainty).missed)
      sum += piece.outline.size();
    return sum;
  };
  EXPECT_GT(parts(0.01), 100u);
  EXPECT_LE(parts(1e-5), 1.1 * parts(0.01));
}

}  // namespace
}  // namespace oxturn

#include "algorithms/drawing/transit_router.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"

namespace oxturn {
namespace {

/// Rings with a gap, and the stroke that closes it: what is inside is enclosed when both are finished.
std::vector<DrawnPiece> gapped_rings(Rng& rng) {
  std::vector<DrawnPiece> pieces;
  for (const Point& centre : {Point(3, 3), Point(7, 3), Point(3, 7), Point(7, 7)}) {
    const double gap = rng.between(0.0, 2 * kPi);
    Polyline ring;
    for (int k = 1; k < 24; ++k) {
      const double angle = gap + 2 * kPi * k / 24;
      ring.push_back(centre + 1.2 * Point(std::cos(angle), std::sin(angle)));
    }
    pieces.push_back({ring, 0.05});
    pieces.push_back({{ring.back(), ring.front()}, 0.05});
  }
  return pieces;
}

Problem canvas() {
  Robot robot;
  robot.radius = 0.1, robot.tool_width = 0.2;
  return {Map{"canvas", Region{{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}}}, "test", ""}, robot, Point(1, 1)};
}

// What a router remembers of paths and of ends that are enclosed is as good as what a new one finds.
TEST(TransitRouter, RemembersOnlyWhatStillHolds) {
  const Problem problem = canvas();
  int enclosed = 0, clear = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Rng rng(seed);
    FinishedWork work(gapped_rings(rng), 0.1);
    TransitRouter router(problem, work, 0.1, nullptr);
    const std::vector<Pose> ends{{{3, 3}}, {{7, 3}}, {{3, 7}}, {{7, 7}}, {{5, 5}}, {{1, 9}}};
    for (int k = 0; k < 60; ++k) {
      const std::size_t piece = rng.below(work.pieces().size());
      work.finished(piece) && rng.chance(0.6) ? work.undo(piece) : work.finish(piece);
      const Pose from = ends[rng.below(ends.size())], to = ends[rng.below(ends.size())];
      const Transit known = router.route(from, to), found = TransitRouter(problem, work, 0.1, nullptr).route(from, to);
      ASSERT_NEAR(known.price(), found.price(), 0.02 * found.price() + 1e-6) << "seed " << seed << ", transit " << k;
      EXPECT_NEAR(known.crossing_m, work.crossing_m(known.path), 1e-9);
      ++(found.crossing_m > 0 ? enclosed : clear);
    }
  }
  EXPECT_GT(enclosed, 30);
  EXPECT_GT(clear, 30);
}

// A search that asks for the same transit again and again spends no effort on ends that stay enclosed.
TEST(TransitRouter, SearchesOnceForAWayOutOfARing) {
  Rng rng(1);
  FinishedWork work(gapped_rings(rng), 0.1);
  const Problem problem = canvas();
  TransitRouter router(problem, work, 0.1, nullptr);
  for (const std::size_t piece : {0, 1}) work.finish(piece);
  for (int k = 0; k < 2000; ++k) {
    k % 2 == 0 ? work.finish(6) : work.undo(6);
    ASSERT_GT(router.route(Pose{{3, 3}}, Pose{{5, 5}}).crossing_m, 0.05);
  }
  EXPECT_FALSE(router.exhausted());
}

}  // namespace
}  // namespace oxturn

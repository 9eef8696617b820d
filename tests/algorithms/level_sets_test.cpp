// What level sets and the passes along the cut leave between them, by brute force on random points.
#include "algorithms/tethered/level_sets.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "algorithms/tethered/needed_boundary.hpp"
#include "base/random.hpp"
#include "geometry/region.hpp"
#include "tests/support/seeds.hpp"
#include "tether_checks.hpp"

namespace oxturn {
namespace {

constexpr int kPoints = 1500;
constexpr double kSpare = 0.01;  // tool widths: chords, and strips that stand for the cut

double distance_to(const std::vector<Polyline>& lines, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Polyline& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

std::vector<Polyline> rings_of(const Region& region) {
  std::vector<Polyline> lines;
  for_each_ring(region, [&](const Ring& ring) {
    lines.push_back(ring);
    lines.back().push_back(ring.front());
  });
  return lines;
}

/// Calls f(space, boundary, tool width, trace) for small maps, with narrow and wide tools.
template <class F>
void for_each_cut_space(CutEdges edges, F f) {
  for (const auto seed : seeds(2))
    for (const Map& map : tether_maps(seed))
      for (const auto& [radius, tool] : {std::pair(0.2, 0.4), std::pair(0.15, 0.6), std::pair(0.2, 0.2)}) {
        SCOPED_TRACE(fmt::format("{} tool {}", map.source, tool));
        const Problem problem(map, tethered_robot(1.2, radius, tool));
        const TetherSpace space(problem, "test");
        f(space, needed_boundary(space, edges), tool);
      }
}

/// Random points of the box.
template <class F>
void for_each_point(const Region& region, F f) {
  const Box box = bounding_box(region);
  Rng rng(3);
  for (int k = 0; k < kPoints; ++k) {
    const double x = rng.between(box.low.x(), box.high.x()), y = rng.between(box.low.y(), box.high.y());
    f(Point(x, y));
  }
}

// The header's promise. Laps that are trimmed without a margin break it beside walls.
TEST(LevelSets, EveryPointIsNearALevelSetOrTheBoundary) {
  for_each_cut_space(CutEdges::across_tether, [](const TetherSpace& space, const NeededBoundary& boundary, double w) {
    std::vector<Polyline> driven = rings_of(boundary.inner);
    for (const LevelSet& set : level_sets(space, boundary.space, boundary.inner, w, w / 1000))
      driven.push_back(set.line);
    for_each_point(boundary.inner, [&](const Point& p) {
      if (!contains(boundary.inner, p)) return;
      EXPECT_LE(distance_to(driven, p), (0.5 + kSpare) * w) << p.transpose();
    });
  });
}

// The floor between the passes on both sides of the cut, which no level set covers; pockets are small.
TEST(NeededBoundary, ThePassesCoverWhatLiesBetweenThem) {
  for_each_cut_space(CutEdges::all, [](const TetherSpace&, const NeededBoundary& boundary, double w) {
    std::vector<Polyline> driven = rings_of(boundary.rings);
    driven.insert(driven.end(), boundary.chains.begin(), boundary.chains.end());
    EXPECT_LE(area(boundary.pockets), 0.005 * area(boundary.space));
    for_each_point(boundary.space, [&](const Point& p) {
      if (!contains(boundary.space, p) || contains(boundary.inner, p) || contains(boundary.pockets, p)) return;
      EXPECT_LE(distance_to(driven, p), (0.5 + kSpare) * w) << p.transpose();
    });
  });
}

// Passes too far apart leave a strip between them, which then needs a third one.
TEST(NeededBoundary, TwoPassesAreEnoughInTheOpen) {
  int samples = 0, near = 0;
  for_each_cut_space(CutEdges::all, [&](const TetherSpace& space, const NeededBoundary& boundary, double w) {
    const EdgeIndex& walls = space.problem().walls();
    std::vector<Polyline> driven = rings_of(boundary.rings);
    driven.insert(driven.end(), boundary.chains.begin(), boundary.chains.end());
    for (const Polyline& line : space.cut())
      for (std::size_t i = 1; i < line.size(); ++i) {
        const int parts = 1 + static_cast<int>(distance(line[i - 1], line[i]) / w);
        for (int k = 0; k < parts; ++k) {
          const Point at = lerp(line[i - 1], line[i], (k + 0.5) / parts);
          if (!walls.contains(at) || walls.nearest(at, at, 1.5 * w)) continue;
          ++samples;
          near += distance_to(driven, at) < 0.3 * w;
        }
      }
  });
  EXPECT_GT(samples, 50);
  EXPECT_LE(near, samples / 20);
}

}  // namespace
}  // namespace oxturn

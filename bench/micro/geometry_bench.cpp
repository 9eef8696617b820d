// Geometry that planners lean on: mesh, shortest paths, edge index, cells. Corners are counted in range(0).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "geometry/coarse_arcs.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/mesh/partition.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/paths/shortest_path.hpp"
#include "geometry/paths/visibility.hpp"
#include "geometry/raster.hpp"
#include "geometry/tether/geodesic_field.hpp"
#include "geometry/tether/taut_tether.hpp"

namespace oxturn {
namespace {

/// A square hall with about `corners` corners on blocks of 4 to 16, one in each square metre.
Region hall(std::int64_t corners) {
  Rng rng(17);
  const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(corners) / 10)));
  Polygon p;
  p.outer = {{0, 0}, {1.0 * side, 0}, {1.0 * side, 1.0 * side}, {0, 1.0 * side}};
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      Ring hole;
      const int n = rng.between(4, 16);
      const double radius = rng.between(0.15, 0.45);
      for (int k = 0; k < n; ++k) {
        const double angle = -2 * kPi * (k + 0.7 * rng.unit()) / n;
        hole.push_back(Point(i + 0.5, j + 0.5) + radius * Point(std::cos(angle), std::sin(angle)));
      }
      p.holes.push_back(hole);
    }
  }
  return {{p}};
}

/// One corridor that winds to and fro: every path across is long and bends often.
Region meander(std::int64_t corners) {
  const int turns = std::max<int>(1, static_cast<int>(corners / 4));
  Polygon p;
  Polyline lower, upper;
  for (int i = 0; i < turns; ++i) {
    const double low = i % 2 == 0 ? 0 : 9, x = i;
    lower.push_back({x, low});
    lower.push_back({x + 0.6, low});
    upper.push_back({x, low + 10});
    upper.push_back({x + 0.6, low + 10});
  }
  p.outer = lower;
  p.outer.insert(p.outer.end(), upper.rbegin(), upper.rend());
  return {{p}};
}

Point free_point(Rng& rng, const EdgeIndex& index, const Box& box) {
  while (true) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    if (index.contains(p)) return p;
  }
}

void BM_EdgeIndexBuild(benchmark::State& state) {
  const Region region = hall(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(EdgeIndex(region));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_EdgeIndexBuild)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Complexity()->Unit(benchmark::kMillisecond);

void BM_NearestToSegment(benchmark::State& state) {  // a metre long, within 0.2 m
  const Region region = hall(state.range(0));
  const EdgeIndex index(region);
  Rng rng(1);
  const Box box = bounding_box(region);
  for (auto _ : state) {
    const Point a(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    benchmark::DoNotOptimize(index.nearest(a, a + Point(0.8, 0.6), 0.2));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_NearestToSegment)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Complexity();

void BM_ContainsPoint(benchmark::State& state) {
  const Region region = hall(state.range(0));
  const EdgeIndex index(region);
  Rng rng(1);
  const Box box = bounding_box(region);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        index.contains(Point(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()))));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_ContainsPoint)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Complexity();

void BM_MeshBuild(benchmark::State& state) {
  const Region region = hall(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Mesh(region));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_MeshBuild)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Complexity()->Unit(benchmark::kMillisecond);

void BM_ShortestPathNear(benchmark::State& state) {  // ends about three metres apart
  const Region region = hall(state.range(0));
  const EdgeIndex index(region);
  const ShortestPaths paths(region, 1e-9);
  Rng rng(2);
  std::vector<std::pair<Point, Point>> ends;
  while (ends.size() < 256) {
    const Point a = free_point(rng, index, bounding_box(region));
    const double angle = rng.between(0.0, 2 * kPi);
    const Point b = a + 3 * Point(std::cos(angle), std::sin(angle));
    if (index.contains(b)) ends.emplace_back(a, b);
  }
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = ends[i++ % ends.size()];
    benchmark::DoNotOptimize(paths.path(a, b));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_ShortestPathNear)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Complexity()->Unit(benchmark::kMicrosecond);

void BM_ShortestPathAcross(benchmark::State& state) {  // corner to corner of the hall
  const Region region = hall(state.range(0));
  const ShortestPaths paths(region, 1e-9);
  const Box box = bounding_box(region);
  for (auto _ : state) benchmark::DoNotOptimize(paths.path(box.low, box.high));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_ShortestPathAcross)
    ->RangeMultiplier(4)
    ->Range(1 << 9, 1 << 17)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

void BM_ShortestPathMeander(benchmark::State& state) {
  const Region region = meander(state.range(0));
  const ShortestPaths paths(region, 1e-9);
  const Point start = region.polygons[0].outer.front(), goal = bounding_box(region).high;
  const Point end(goal.x() - 0.1, region.polygons[0].outer[region.polygons[0].outer.size() / 2].y());
  for (auto _ : state) benchmark::DoNotOptimize(paths.path(start, end));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_ShortestPathMeander)
    ->RangeMultiplier(4)
    ->Range(1 << 9, 1 << 17)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

void BM_Visibility(benchmark::State& state) {  // what is seen between blocks does not grow with the hall
  const Region region = hall(state.range(0));
  const EdgeIndex index(region);
  const Visibility visibility(region);
  Rng rng(3);
  std::vector<Point> eyes;
  while (eyes.size() < 256) eyes.push_back(free_point(rng, index, bounding_box(region)));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(visibility.from(eyes[i++ % eyes.size()]));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_Visibility)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Complexity()->Unit(benchmark::kMicrosecond);

/// A walk of `moves` straight pieces at random, up to `step` metres each, that keeps its heading where it can.
Polyline walk(const EdgeIndex& index, const Box& box, int moves, double step) {
  Rng rng(4);
  Polyline path{free_point(rng, index, box)};
  double heading = 0;
  while (static_cast<int>(path.size()) <= moves) {
    const Point to = path.back() + step * rng.unit() * Point(std::cos(heading), std::sin(heading));
    if (index.contains(path.back(), to)) {
      path.push_back(to);
    } else {
      heading = rng.between(0.0, 2 * kPi);
    }
  }
  return path;
}

/// range(1): metres of a piece at most, in tenths. Simulated whole in each iteration.
void BM_TautTether(benchmark::State& state) {
  const Region region = hall(state.range(0));
  const TautSpace space(region);
  constexpr int kMoves = 100000;
  const double step = 0.1 * static_cast<double>(state.range(1));
  const Polyline path = walk(EdgeIndex(region), bounding_box(region), kMoves, step);
  std::size_t bends = 0, most = 0;
  for (auto _ : state) {
    TautTether tether(space, path[0]);
    bends = most = 0;
    for (const Point& p : path) {
      tether.drive(p);
      bends += tether.bends().size();
      most = std::max(most, tether.bends().size());
    }
    benchmark::DoNotOptimize(tether.length());
  }
  state.counters["corners"] = static_cast<double>(vertex_count(region));
  state.counters["bends_mean"] = static_cast<double>(bends) / kMoves;
  state.counters["bends_max"] = static_cast<double>(most);
  state.counters["per_move"] =
      benchmark::Counter(kMoves, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_TautTether)->Args({2000, 3})->Args({2000, 30})->Unit(benchmark::kMillisecond);
BENCHMARK(BM_TautTether)
    ->ArgsProduct({benchmark::CreateRange(1 << 9, 1 << 17, 4), {10}})
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

/// The worst for the index: an empty aisle between rows of blocks, and the string as long as the aisle in each move.
void BM_TautTetherAcross(benchmark::State& state) {
  Region region = hall(state.range(0));
  const double side = bounding_box(region).high.x(), middle = std::floor(side / 2);
  std::erase_if(region.polygons[0].holes, [&](const Ring& r) { return std::floor(r[0].y()) == middle; });
  const TautSpace space(region);
  TautTether tether(space, {0.5, middle + 0.5});
  tether.drive(Point(side - 0.5, middle + 0.5));
  Rng rng(5);
  for (auto _ : state) tether.drive(Point(side - rng.unit(), middle + rng.unit()));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_TautTetherAcross)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Complexity();

void BM_BoustrophedonCells(benchmark::State& state) {
  const Region region = hall(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(boustrophedon_cells(region));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_BoustrophedonCells)
    ->RangeMultiplier(4)
    ->Range(1 << 9, 1 << 17)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

template <std::vector<Ring> (*Partition)(const Region&)>
void BM_Partition(benchmark::State& state) {
  const Region region = hall(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Partition(region));
  state.SetComplexityN(state.range(0));
}
BENCHMARK_TEMPLATE(BM_Partition, convex_partition_approximate)
    ->RangeMultiplier(4)
    ->Range(1 << 9, 1 << 17)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(BM_Partition, monotone_partition)
    ->RangeMultiplier(4)
    ->Range(1 << 9, 1 << 17)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(BM_Partition, trapezoid_partition)
    ->RangeMultiplier(4)
    ->Range(1 << 9, 1 << 17)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

void BM_ConvexPartitionOptimal(benchmark::State& state) {
  const Region region = meander(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(convex_partition_optimal(region));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_ConvexPartitionOptimal)->RangeMultiplier(2)->Range(16, 128)->Complexity()->Unit(benchmark::kMillisecond);

// The geodesic field of an anchor in a corner, with paths around both sides of every block.
constexpr double kBarred = 0.15;  // a disc of this diameter: about one gap in five is too narrow

void BM_Barriers(benchmark::State& state) {
  const Region region = hall(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(barriers(region, kBarred));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_Barriers)->RangeMultiplier(4)->Range(1 << 9, 1 << 15)->Complexity()->Unit(benchmark::kMillisecond);

void BM_GeodesicBuild(benchmark::State& state) {
  const Region region = hall(state.range(0));
  const std::vector<Polyline> lines = barriers(region, kBarred);
  for (auto _ : state) benchmark::DoNotOptimize(GeodesicField(region, {0.01, 0.02}, lines, 1e-9));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_GeodesicBuild)->RangeMultiplier(4)->Range(1 << 9, 1 << 15)->Complexity()->Unit(benchmark::kMillisecond);

void BM_GeodesicDistance(benchmark::State& state) {
  const Region region = hall(state.range(0));
  const GeodesicField field(region, {0.01, 0.02}, barriers(region, kBarred), 1e-9);
  const EdgeIndex index(region);
  Rng rng(3);
  std::vector<Point> points(1024);
  for (Point& p : points) p = free_point(rng, index, bounding_box(region));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(field.distance(points[i++ % points.size()]));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_GeodesicDistance)->RangeMultiplier(4)->Range(1 << 9, 1 << 15)->Complexity();

void BM_GeodesicLevel(benchmark::State& state) {
  const Region region = hall(state.range(0));
  const GeodesicField field(region, {0.01, 0.02}, barriers(region, kBarred), 1e-9);
  const double half = field.farthest() / 2;
  for (auto _ : state) benchmark::DoNotOptimize(field.level_set(half));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_GeodesicLevel)->RangeMultiplier(4)->Range(1 << 9, 1 << 15)->Complexity()->Unit(benchmark::kMillisecond);

void BM_GeodesicCut(benchmark::State& state) {
  const Region region = hall(state.range(0));
  const GeodesicField field(region, {0.01, 0.02}, barriers(region, kBarred), 1e-9);
  for (auto _ : state) benchmark::DoNotOptimize(field.cut_locus(1e-3));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_GeodesicCut)->RangeMultiplier(4)->Range(1 << 9, 1 << 15)->Complexity()->Unit(benchmark::kMillisecond);

void BM_CutAlong(benchmark::State& state) {  // along the whole cut
  const Region region = hall(state.range(0));
  const std::vector<Polyline> lines = GeodesicField(region, {0.01, 0.02}, {}, 1e-9).cut_locus(1e-3);
  for (auto _ : state) benchmark::DoNotOptimize(cut_along(region, lines, 2e-3));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_CutAlong)->RangeMultiplier(4)->Range(1 << 9, 1 << 15)->Complexity()->Unit(benchmark::kMillisecond);

/// Cells of 0.4 m, a tenth of them blocked at random: a laser map at its worst.
Region speckled(std::int64_t cells) {
  Rng rng(1);
  const int n = static_cast<int>(std::lround(std::sqrt(static_cast<double>(cells))));
  BitGrid grid({0, 0}, 0.4, n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) grid.set(i, j, !rng.chance(0.1));
  return trace(grid);
}

void BM_ErodeSpeckled(benchmark::State& state) {  // to configuration space
  const Region free = speckled(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(erode(free, 0.19, 0.4e-3, Bound::inside));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_ErodeSpeckled)->RangeMultiplier(4)->Range(1 << 10, 1 << 18)->Complexity()->Unit(benchmark::kMillisecond);

void BM_CoarserArcs(benchmark::State& state) {  // of a configuration space
  const Region space = erode(speckled(state.range(0)), 0.19, 0.4e-3, Bound::inside);
  for (auto _ : state) benchmark::DoNotOptimize(with_coarser_arcs(space, 0.0019, 0.2));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_CoarserArcs)->RangeMultiplier(4)->Range(1 << 10, 1 << 18)->Complexity()->Unit(benchmark::kMillisecond);

void BM_DilateSpeckled(benchmark::State& state) {  // configuration space to target: holes made of fine arcs
  const Region space = erode(speckled(state.range(0)), 0.19, 0.4e-3, Bound::inside);
  for (auto _ : state) benchmark::DoNotOptimize(dilate(space, 0.2, 0.02e-3, Bound::inside));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_DilateSpeckled)->RangeMultiplier(4)->Range(1 << 10, 1 << 18)->Complexity()->Unit(benchmark::kMillisecond);

void BM_SubtractSwath(benchmark::State& state) {  // of lanes through a hall, by their number
  Rng rng(1);
  const double side = 0.4 * std::sqrt(10.0 * static_cast<double>(state.range(0)));
  std::vector<Polyline> lanes;
  for (std::int64_t k = 0; k < state.range(0); ++k) {
    const Point from(side * rng.unit(), side * rng.unit());
    lanes.push_back({from, from + Point(0, 2)});
  }
  const Region hall = box_region({0, 0}, {side, side});
  for (auto _ : state) benchmark::DoNotOptimize(subtract(hall, swath_parts(lanes, 0.2, 1.6e-3, Bound::outside)));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_SubtractSwath)->RangeMultiplier(4)->Range(1 << 8, 1 << 16)->Complexity()->Unit(benchmark::kMillisecond);

void BM_DilateOneArc(benchmark::State& state) {  // a round hole of so many corners, grown by about its radius
  Polygon ring{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{}}};
  for (std::int64_t k = 0; k < state.range(0); ++k) {
    const double angle = -2 * kPi * static_cast<double>(k) / static_cast<double>(state.range(0));
    ring.holes[0].push_back(Point(1.5, 1.5) + Point(std::cos(angle), std::sin(angle)));
  }
  for (auto _ : state) benchmark::DoNotOptimize(dilate({{ring}}, 0.99, 1e-5, Bound::inside));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_DilateOneArc)->RangeMultiplier(4)->Range(1 << 6, 1 << 14)->Complexity()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace oxturn

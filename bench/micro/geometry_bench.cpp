// Geometry that planners lean on: mesh, shortest paths, edge index, cells. Corners are counted in range(0).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "geometry/edge_index.hpp"
#include "geometry/mesh.hpp"
#include "geometry/partition.hpp"
#include "geometry/random.hpp"
#include "geometry/shortest_path.hpp"

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

/// One corridor that winds to and fro: every way across is long and bends often.
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

Point free_place(Rng& rng, const EdgeIndex& index, const Box& box) {
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
    const Point a = free_place(rng, index, bounding_box(region));
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
BENCHMARK_TEMPLATE(BM_Partition, bridged)
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

}  // namespace
}  // namespace oxturn

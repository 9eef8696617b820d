// Grid planners on open floors of 2^12 to 2^20 cells, and on rooms: all linear in the cells.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "geometry/raster.hpp"
#include "maps/generators.hpp"

namespace oxturn {
namespace {

Problem open_floor(std::int64_t cells, double side) {
  const double width = std::sqrt(static_cast<double>(cells)) * side + 0.4;
  Problem problem({"floor", box_region({0, 0}, {width, width}), "bench", ""}, Robot{}, Point(1, 1));
  benchmark::DoNotOptimize(problem.transit());
  return problem;
}

void plan(benchmark::State& state, const char* name, const Problem& problem, const Settings& settings) {
  const auto planner = find_planner(zoo(), name).make(settings);
  for (auto _ : state) {
    Context context;
    benchmark::DoNotOptimize(planner->plan(problem, context));
  }
  state.SetComplexityN(state.range(0));
}

void BM_Stc(benchmark::State& state) { plan(state, "stc", open_floor(state.range(0), 0.4 / std::sqrt(2.0)), {}); }
BENCHMARK(BM_Stc)->RangeMultiplier(16)->Range(1 << 12, 1 << 20)->Complexity()->Unit(benchmark::kMillisecond);

void BM_Rectangles(benchmark::State& state) { plan(state, "rectangles", open_floor(state.range(0), 0.2), {}); }
BENCHMARK(BM_Rectangles)->RangeMultiplier(16)->Range(1 << 12, 1 << 20)->Complexity()->Unit(benchmark::kMillisecond);

// The worst case of the header: many rectangles and walls. Rooms of about 12 m^2; range = sub-cells of the floor.
void BM_StcRooms(benchmark::State& state) {
  const double side = std::sqrt(static_cast<double>(state.range(0)) * 0.08);
  const auto rooms = static_cast<std::int64_t>(side * side / 12);
  const Problem problem(generate("rooms", {{"width", side}, {"height", side}, {"rooms", rooms}}, 1), Robot{});
  benchmark::DoNotOptimize(problem.transit());
  plan(state, "stc", problem, {});
}
BENCHMARK(BM_StcRooms)->RangeMultiplier(4)->Range(1 << 14, 1 << 18)->Complexity()->Unit(benchmark::kMillisecond);

// Rectangles where they are smallest: a tenth of the cells blocked at random, a robot nearly as wide as a cell.
Problem speckled_floor(std::int64_t cells) {
  const int n = static_cast<int>(std::sqrt(static_cast<double>(cells) / 0.9));
  BitGrid grid({0, 0}, 0.4, n, n);
  Rng rng(1);
  for (auto& bit : grid.bits) bit = rng.chance(0.9);
  Robot robot;
  robot.radius = 0.19;
  Region free = trace(grid);
  const auto largest =
      std::max_element(free.polygons.begin(), free.polygons.end(),
                       [](const Polygon& a, const Polygon& b) { return a.holes.size() < b.holes.size(); });
  return Problem({"speckled", {{*largest}}, "bench", ""}, robot);
}

void plan_speckled(benchmark::State& state, const Settings& more) {
  Settings settings{{"cell_size", 0.4}};
  settings.insert(more.begin(), more.end());
  const Problem problem = speckled_floor(state.range(0));
  benchmark::DoNotOptimize(problem.walls());
  plan(state, "rectangles", problem, settings);
}
void BM_RectanglesSpeckled(benchmark::State& state) { plan_speckled(state, {}); }
void BM_RectanglesSpeckledNearest(benchmark::State& state) {
  plan_speckled(state, {{"choose", std::string("nearest")}});
}
void BM_RectanglesSpeckledRevisit(benchmark::State& state) {
  plan_speckled(state, {{"choose", std::string("nearest")}, {"revisit_skipped", true}});
}
BENCHMARK(BM_RectanglesSpeckled)
    ->RangeMultiplier(4)
    ->Range(1 << 14, 1 << 20)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RectanglesSpeckledNearest)
    ->RangeMultiplier(4)
    ->Range(1 << 14, 1 << 20)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RectanglesSpeckledRevisit)
    ->RangeMultiplier(4)
    ->Range(1 << 14, 1 << 20)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

// Habits: linear in the length driven.
void BM_Habit(benchmark::State& state, const char* name) {
  const Problem problem(generate("rooms", {}, 1), Robot{});
  benchmark::DoNotOptimize(problem.walls());
  plan(state, name, problem, {{"length_limit", static_cast<double>(state.range(0))}, {"passes", 1000.0}});
}
BENCHMARK_CAPTURE(BM_Habit, random_walk, "random-walk")->RangeMultiplier(8)->Range(1 << 9, 1 << 15)->Complexity();
BENCHMARK_CAPTURE(BM_Habit, spiral_out, "spiral-out")->RangeMultiplier(8)->Range(1 << 9, 1 << 15)->Complexity();
BENCHMARK_CAPTURE(BM_Habit, wall_follow, "wall-follow")->RangeMultiplier(8)->Range(1 << 9, 1 << 15)->Complexity();
BENCHMARK_CAPTURE(BM_Habit, vacuum_mix, "vacuum-mix")->RangeMultiplier(8)->Range(1 << 9, 1 << 15)->Complexity();

}  // namespace
}  // namespace oxturn

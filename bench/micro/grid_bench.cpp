// Grid planners on open floors of 2^12 to 2^20 cells, on rooms, and on lattices of 2^10 to 10^6 cells of which a tenth
// is blocked at random: all linear in the cells.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>

#include "algorithms/coverage_planner.hpp"
#include "base/random.hpp"
#include "geometry/raster.hpp"
#include "maps/generators.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

namespace oxturn {
namespace {

Problem open_floor(std::int64_t cells, double side) {
  const double width = std::sqrt(static_cast<double>(cells)) * side + 0.4;
  Problem problem({"floor", box_region({0, 0}, {width, width}), "bench", ""}, Robot{}, Point(1, 1));
  benchmark::DoNotOptimize(problem.transit());
  return problem;
}

void plan(benchmark::State& state, const char* name, const Problem& problem, const Settings& settings) {
  const auto planner = built_in_planner(name, settings);
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

// Cells of 1 m, a tenth of them walls. Eroding 10^5 obstacles takes longer than planning, so a problem is kept.
const Problem& scattered(std::int64_t cells) {
  static std::map<std::int64_t, std::unique_ptr<Problem>> kept;
  std::unique_ptr<Problem>& problem = kept[cells];
  if (problem) return *problem;
  const int n = static_cast<int>(std::lround(std::sqrt(static_cast<double>(cells) / 0.9)));
  Rng rng(1);
  BitGrid grid({0, 0}, 1, n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      grid.set(i, j, !rng.chance(0.1) || (std::abs(i - n / 2) < 2 && std::abs(j - n / 2) < 2));
  Robot robot;
  robot.radius = 0.2;
  robot.tool_width = std::sqrt(2.0);
  const Point middle(n / 2 + 0.5, n / 2 + 0.5);
  problem = std::make_unique<Problem>(Map{"scattered", trace(grid), "bench", ""}, robot, middle);
  return *problem;
}

// With `moves`: driven cells per cell.
void BM_Scattered(benchmark::State& state, const char* name, Settings settings) {
  const Problem& problem = scattered(state.range(0));
  settings["cell_size"] = 1.0;
  const auto planner = built_in_planner(name, settings);
  double cells = 0, length = 0;
  for (auto _ : state) {
    Context::Sinks sinks;
    sinks.record = [&](const std::string& figure, double value) {
      if (figure == "cells") cells = value;
    };
    Context context(1, 1e9, sinks);
    length = planner->plan(problem, context).length();
  }
  state.SetComplexityN(state.range(0));
  if (cells > 0) state.counters["per_cell"] = length / cells;
}
#define OXTURN_SCATTERED(label, ...)                  \
  BENCHMARK_CAPTURE(BM_Scattered, label, __VA_ARGS__) \
      ->Arg(1 << 10)                                  \
      ->Arg(1 << 13)                                  \
      ->Arg(1 << 16)                                  \
      ->Arg(1000000)                                  \
      ->Complexity(benchmark::oN)                     \
      ->Unit(benchmark::kMillisecond)
OXTURN_SCATTERED(bsa, "bsa", Settings{});
OXTURN_SCATTERED(bsa_latest, "bsa", Settings{{"backtrack", std::string("latest")}});
OXTURN_SCATTERED(linked_spiral, "linked-spiral", Settings{});
OXTURN_SCATTERED(ba_star, "ba-star", Settings{});
OXTURN_SCATTERED(smart_dfs, "smart-dfs", Settings{});
OXTURN_SCATTERED(cell_explore, "cell-explore", Settings{});
OXTURN_SCATTERED(wavefront, "wavefront", (Settings{{"shift_x", 0.3}, {"shift_y", 0.3}}));
OXTURN_SCATTERED(wavefront_path, "wavefront",
                 (Settings{{"shift_x", 0.3}, {"shift_y", 0.3}, {"transform", std::string("path")}}));
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
// Hyun: on lines alone (range = lines), on a field of obstacles (range = obstacles), and in the world of the paper.
void plan_hyun(benchmark::State& state, const Problem& problem, const Settings& settings = {}) {
  benchmark::DoNotOptimize(problem.transit());
  benchmark::DoNotOptimize(problem.walls());
  plan(state, "hyun", problem, settings);
}

void BM_HyunLines(benchmark::State& state) {
  const double height = static_cast<double>(state.range(0)) * 0.2 + 0.4;
  plan_hyun(state, Problem({"floor", box_region({0, 0}, {20, height}), "bench", ""}, Robot{}, Point(1, 1)));
}
BENCHMARK(BM_HyunLines)->RangeMultiplier(4)->Range(1 << 8, 1 << 14)->Complexity()->Unit(benchmark::kMillisecond);

void BM_HyunObstacles(benchmark::State& state) {
  const int n = static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)))));
  Region free = box_region({0, 0}, {2.0 * n, 2.0 * n});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point at(2 * i + 1 + 0.1 * (j % 3), 2 * j + 1 + 0.1 * (i % 3));
      free.polygons[0].holes.push_back(
          {at + Point(-0.3, 0), at + Point(0, 0.3), at + Point(0.3, 0), at + Point(0, -0.3)});
    }
  plan_hyun(state, Problem({"field", free, "bench", ""}, Robot{}), {{"transit", std::string("visibility")}});
}
BENCHMARK(BM_HyunObstacles)->RangeMultiplier(4)->Range(1 << 4, 1 << 12)->Complexity()->Unit(benchmark::kMillisecond);

void BM_HyunWorld(benchmark::State& state) {
  Robot robot;
  robot.footprint = parse_footprint("octagon:1");
  robot.tool_width = 1;
  const char* const transits[] = {"tlppa", "visibility"};
  const auto planner = built_in_planner("hyun", {{"transit", std::string(transits[state.range(0)])}});
  for (auto _ : state) {  // all of it: configuration space, triangulation, plan
    const Problem problem(generate("hyun", {}, 1), robot);
    Context context;
    benchmark::DoNotOptimize(planner->plan(problem, context));
  }
  state.SetLabel(transits[state.range(0)]);
}
BENCHMARK(BM_HyunWorld)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
// --- the spanning trees on cells of which a tenth is blocked at random; range = cells ---

// Cells of 0.4 m, the robot a little narrower; five by five cells about the middle, where it starts, are free.
const Problem& tenth_blocked(std::int64_t cells) {
  static std::map<std::int64_t, std::unique_ptr<Problem>> made;
  std::unique_ptr<Problem>& problem = made[cells];
  if (problem) return *problem;
  const int n = static_cast<int>(std::lround(std::sqrt(static_cast<double>(cells) / 0.9)));
  BitGrid grid({0, 0}, 0.4, n, n);
  Rng rng(1);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      grid.set(i, j, !rng.chance(0.1) || std::max(std::abs(i - n / 2), std::abs(j - n / 2)) <= 2);
  Robot robot;
  robot.radius = 0.19;
  problem = std::make_unique<Problem>(Map{"tenth", trace(grid), "bench", ""}, robot, grid.centre(n / 2, n / 2));
  benchmark::DoNotOptimize(problem->walls());
  return *problem;
}

void BM_TenthBlocked(benchmark::State& state, const char* name, Settings settings) {
  settings["cell_size"] = 0.4;
  plan(state, name, tenth_blocked(state.range(0)), settings);
}
#define OXTURN_UP_TO_A_MILLION(function, label, ...) \
  BENCHMARK_CAPTURE(function, label, __VA_ARGS__)    \
      ->RangeMultiplier(8)                           \
      ->Range(1 << 14, 1 << 20)                      \
      ->Complexity()                                 \
      ->Unit(benchmark::kMillisecond)
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc, "stc", {});
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc_start, "stc", {{"components", std::string("start")}});
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc_partial, "stc", {{"components", std::string("start")}, {"partial", true}});
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc_spiral, "stc-spiral", {});
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc_spiral_partial, "stc-spiral", {{"partial", true}});
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc_scan, "stc-scan", {});
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc_scan_partial, "stc-scan", {{"partial", true}});
OXTURN_UP_TO_A_MILLION(BM_TenthBlocked, stc_loops, "stc-loops", {});

// The same with the default cell, which fits the obstacles nowhere: the lattice falls apart into thousands of
// components that only paths among the walls connect. n log n.
const Problem& speckle(std::int64_t cells) {
  static std::map<std::int64_t, std::unique_ptr<Problem>> made;
  std::unique_ptr<Problem>& problem = made[cells];
  if (problem) return *problem;
  const double side = std::sqrt(static_cast<double>(cells) * 0.08);
  Robot robot;
  robot.radius = 0.19;
  const Settings tight{{"width", side}, {"height", side}, {"robot", 0.19}, {"passage", 1.05}, {"cell", 0.4}};
  problem = std::make_unique<Problem>(generate("speckle", tight, 1), robot);
  benchmark::DoNotOptimize(problem->walls());
  benchmark::DoNotOptimize(problem->transit());
  return *problem;
}
void BM_Speckle(benchmark::State& state, const char* name, const Settings& settings) {
  plan(state, name, speckle(state.range(0)), settings);
}
OXTURN_UP_TO_A_MILLION(BM_Speckle, stc, "stc", Settings{});
OXTURN_UP_TO_A_MILLION(BM_Speckle, stc_partial, "stc", Settings{{"partial", true}});
OXTURN_UP_TO_A_MILLION(BM_Speckle, stc_loops, "stc-loops", Settings{});
OXTURN_UP_TO_A_MILLION(BM_Speckle, contour, "contour", Settings{});
OXTURN_UP_TO_A_MILLION(BM_Speckle, completed, "completed", Settings{});
#undef OXTURN_UP_TO_A_MILLION

}  // namespace
}  // namespace oxturn

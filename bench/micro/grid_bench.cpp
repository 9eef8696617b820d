// Grid planners on open floors of 2^12 to 2^20 cells, on rooms, and on lattices of 2^10 to 10^6 cells of which a tenth is
// blocked at random: all linear in the cells.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>

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
  const auto planner = find_planner(zoo(), name).make(settings);
  double cells = 0, length = 0;
  for (auto _ : state) {
    Context::Sinks sinks;
    sinks.report = [&](const std::string& figure, double value) {
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

}  // namespace
}  // namespace oxturn

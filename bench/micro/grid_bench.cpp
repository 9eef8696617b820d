// Grid planners on open floors of 2^12 to 2^20 cells, and on rooms: all linear in the cells.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>

#include "algorithms/coverage_planner.hpp"
#include "geometry/random.hpp"
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
  benchmark::DoNotOptimize(problem->transit());
  benchmark::DoNotOptimize(problem->walls());
  return *problem;
}

void BM_TenthBlocked(benchmark::State& state, const char* name, Settings settings) {
  settings["cell_size"] = 0.4;
  plan(state, name, tenth_blocked(state.range(0)), settings);
}
#define OXTURN_TENTH_BLOCKED(label, ...)                 \
  BENCHMARK_CAPTURE(BM_TenthBlocked, label, __VA_ARGS__) \
      ->RangeMultiplier(8)                               \
      ->Range(1 << 14, 1 << 20)                          \
      ->Complexity()                                     \
      ->Unit(benchmark::kMillisecond)
OXTURN_TENTH_BLOCKED(stc, "stc", {{"components", std::string("start")}});
OXTURN_TENTH_BLOCKED(stc_partial, "stc", {{"components", std::string("start")}, {"partial", true}});
OXTURN_TENTH_BLOCKED(stc_spiral, "stc-spiral", {});
OXTURN_TENTH_BLOCKED(stc_spiral_partial, "stc-spiral", {{"partial", true}});
OXTURN_TENTH_BLOCKED(stc_scan, "stc-scan", {});
OXTURN_TENTH_BLOCKED(stc_scan_partial, "stc-scan", {{"partial", true}});
OXTURN_TENTH_BLOCKED(stc_loops, "stc-loops", {});
#undef OXTURN_TENTH_BLOCKED

}  // namespace
}  // namespace oxturn

// Grid planners on open floors of 2^12 to 2^20 cells, and on rooms: all linear in the cells.
#include <benchmark/benchmark.h>

#include <cmath>

#include "algorithms/coverage_planner.hpp"
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

}  // namespace
}  // namespace oxturn

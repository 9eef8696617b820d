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
  robot.footprint = named_footprint("octagon:1");
  robot.tool_width = 1;
  const char* const transits[] = {"tlppa", "visibility"};
  const auto planner = find_planner(zoo(), "hyun").make({{"transit", std::string(transits[state.range(0)])}});
  for (auto _ : state) {  // all of it: configuration space, triangulation, plan
    const Problem problem(generate("hyun", {}, 1), robot);
    Context context;
    benchmark::DoNotOptimize(planner->plan(problem, context));
  }
  state.SetLabel(transits[state.range(0)]);
}
BENCHMARK(BM_HyunWorld)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace oxturn

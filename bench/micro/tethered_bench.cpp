// Tethered planners on halls with more and more obstacles; N is the number of corners (area grows with them).
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "algorithms/coverage_planner.hpp"
#include "maps/generators.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

namespace oxturn {
namespace {

// Polygons of up to seven corners, about one for every 5 m^2.
Problem hall_with(std::int64_t corners) {
  const double side = std::sqrt(static_cast<double>(corners) / 500);
  Robot robot;
  robot.tether = Tether{0, 1.1};
  return Problem(generate("clutter", {{"width", 30 * side}, {"height", 24 * side}, {"discs", 0.0}}, 1), robot);
}

void plan_hall(benchmark::State& state, const std::string& name, const Settings& settings) {
  const Problem problem = hall_with(state.range(0));
  problem.walls();  // belongs to the problem, not to the planner
  problem.transit();
  const auto planner = built_in_planner(name, settings);
  for (auto _ : state) {
    Context context(1);
    benchmark::DoNotOptimize(planner->plan(problem, context));
  }
  const auto n = static_cast<std::int64_t>(vertex_count(problem.map().free));
  state.SetComplexityN(n);
  state.counters["corners"] = static_cast<double>(n);
}

void BM_BergComplete(benchmark::State& state) { plan_hall(state, "berg-complete", {}); }
void BM_BergCompleteDepthFirst(benchmark::State& state) {
  plan_hall(state, "berg-complete", {{"order", std::string("dfs")}});
}
void BM_Leashed(benchmark::State& state) { plan_hall(state, "leashed", {}); }
BENCHMARK(BM_BergComplete)->RangeMultiplier(2)->Range(250, 4000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(BM_BergCompleteDepthFirst)->RangeMultiplier(2)->Range(250, 4000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(BM_Leashed)->RangeMultiplier(2)->Range(250, 4000)->Unit(benchmark::kMillisecond)->Complexity();

// Cells of speckle; the cut isolates more and more components.
void plan_speckle(benchmark::State& state, const std::string& name) {
  const double side = std::sqrt(static_cast<double>(state.range(0)) * 0.08);
  Robot robot;
  robot.tether = Tether{0, 1.2};
  const Problem problem(generate("speckle", {{"width", side}, {"height", side}}, 1), robot);
  const auto planner = built_in_planner(name);
  for (auto _ : state) {
    Context context(1);
    benchmark::DoNotOptimize(planner->plan(problem, context));
  }
  state.SetComplexityN(state.range(0));
}
#define OXTURN_SPECKLE(label, name)            \
  BENCHMARK_CAPTURE(plan_speckle, label, name) \
      ->RangeMultiplier(4)                     \
      ->Range(1 << 10, 1 << 16)                \
      ->Complexity()                           \
      ->Unit(benchmark::kMillisecond)
OXTURN_SPECKLE(berg_complete, "berg-complete");
OXTURN_SPECKLE(leashed, "leashed");
OXTURN_SPECKLE(berg, "berg");
OXTURN_SPECKLE(tether_tree, "tether-tree");
OXTURN_SPECKLE(tethered_stc, "tethered-stc");
#undef OXTURN_SPECKLE
// One shortest path a cell, across the map: the path itself grows as n^1.5.
BENCHMARK_CAPTURE(plan_speckle, shnaps_rimon, "shnaps-rimon")
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 14)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_speckle, shnaps_rimon_banded, "shnaps-rimon-banded")
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 14)
    ->Complexity()
    ->Unit(benchmark::kMillisecond);

void BM_TetheredProblem(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(hall_with(state.range(0)).tether()->geodesics().farthest());
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_TetheredProblem)->RangeMultiplier(2)->Range(250, 4000)->Unit(benchmark::kMillisecond)->Complexity();

}  // namespace
}  // namespace oxturn

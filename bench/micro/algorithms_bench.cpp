// Polygon planners on fields with more and more ponds (corners, lanes and cells grow together).
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "algorithms/coverage_planner.hpp"
#include "maps/generators.hpp"

namespace oxturn {
namespace {

// About n corners: 15 ponds have 71; the area grows with them.
Problem field_with(std::int64_t ponds) {
  const double side = std::sqrt(static_cast<double>(ponds) / 15);
  Robot robot;
  robot.radius = 0.5;
  robot.tool_width = 1;
  return Problem(generate("field", {{"width", 60 * side}, {"height", 40 * side}, {"ponds", ponds}, {"robot", 0.5}}, 1),
                 robot);
}

void plan_field(benchmark::State& state, const std::string& name, const Settings& settings) {
  const Problem problem = field_with(state.range(0));
  problem.transit();  // belongs to the problem, not to the planner
  problem.walls();
  const auto planner = find_planner(zoo(), name).make(settings);
  for (auto _ : state) {
    Context context(1);
    benchmark::DoNotOptimize(planner->plan(problem, context));
  }
  state.SetComplexityN(state.range(0));
}

void BM_Boustrophedon(benchmark::State& state) { plan_field(state, "boustrophedon", {}); }
void BM_BoustrophedonExact(benchmark::State& state) {
  plan_field(state, "boustrophedon", {{"cells", std::string("exact")}});
}
void BM_Zigzag(benchmark::State& state) { plan_field(state, "zigzag", {}); }
BENCHMARK(BM_Boustrophedon)->RangeMultiplier(4)->Range(4, 1024)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(BM_BoustrophedonExact)->RangeMultiplier(4)->Range(4, 1024)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(BM_Zigzag)->RangeMultiplier(4)->Range(4, 1024)->Unit(benchmark::kMillisecond)->Complexity();

}  // namespace
}  // namespace oxturn

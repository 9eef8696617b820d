// Polygon planners on fields with more and more ponds (corners, lanes and cells grow together), and on larger maps of
// scattered obstacles.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/online/survey_then_plan.hpp"
#include "maps/generators.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

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
  const auto planner = built_in_planner(name, settings);
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
BENCHMARK_CAPTURE(plan_field, field, "field", {})
    ->RangeMultiplier(4)
    ->Range(4, 256)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK_CAPTURE(plan_field, field_predictive, "field-predictive", {})
    ->RangeMultiplier(4)
    ->Range(4, 256)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

// Among thousands of small obstacles, by cells (squares of side tool width / sqrt 2); and in an empty rectangle.
Problem scattered(const std::string& generator, std::int64_t cells) {
  Robot robot;
  robot.radius = 0.2;
  robot.tool_width = 0.4;
  const double side = std::sqrt(0.08 * static_cast<double>(cells));
  return Problem(generate(generator, {{"width", side}, {"height", side}}, 1), robot);
}

void plan_scattered(benchmark::State& state, const std::string& generator, const std::string& name) {
  const Problem problem = scattered(generator, state.range(0));
  problem.transit();
  problem.walls();
  const auto planner = built_in_planner(name, {});
  for (auto _ : state) {
    Context context(1);
    benchmark::DoNotOptimize(planner->plan(problem, context));
  }
  state.SetComplexityN(state.range(0));
}

void by_cells(benchmark::internal::Benchmark* benchmark) {
  benchmark->RangeMultiplier(4)->Range(1 << 10, 1 << 16)->Unit(benchmark::kMillisecond)->Complexity();
}
BENCHMARK_CAPTURE(plan_scattered, smooth_spiral, "speckle", "smooth-spiral")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, skeleton_spiral, "speckle", "skeleton-spiral")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, connected_fermat, "speckle", "connected-fermat")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, contour, "speckle", "contour")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, completed, "speckle", "completed")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, rectangles, "speckle", "rectangles")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, wavefront, "speckle", "wavefront")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, oarp, "speckle", "oarp")->Apply(by_cells);
BENCHMARK_CAPTURE(plan_scattered, oarp_rectangle, "rectangle", "oarp")->Apply(by_cells);

// Online: rooms of 10 m x 8 m, by rays.
Problem rooms_with_lidar(std::int64_t rays) {
  Robot robot;
  robot.lidar = Lidar{8, static_cast<int>(rays), 0};
  return Problem(generate("rooms", {{"width", 10.0}, {"height", 8.0}}, 1), robot);
}

/// Places on a walk through the rooms.
Polyline walk(const Problem& problem) {
  Polyline points;
  for (const Ring& ring : {problem.configuration_space().polygons[0].outer})
    for (std::size_t k = 0; k < ring.size(); ++k)
      for (int s = 0; s < 10; ++s) points.push_back(lerp(ring[k], ring[(k + 1) % ring.size()], s / 10.0));
  return points;
}

void BM_LidarScan(benchmark::State& state) {
  const Problem problem = rooms_with_lidar(state.range(0));
  const LidarSimulator lidar(problem.map().free, *problem.robot().lidar);
  const Polyline points = walk(problem);
  Rng unused(1);
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(lidar.scan(points[k++ % points.size()], unused));
  state.SetComplexityN(state.range(0));
}

void BM_BeliefAdd(benchmark::State& state) {
  const Problem problem = rooms_with_lidar(state.range(0));
  const LidarSimulator lidar(problem.map().free, *problem.robot().lidar);
  std::vector<Scan> scans;
  Rng unused(1);
  for (const Point& p : walk(problem)) scans.push_back(lidar.scan(p, unused));
  Belief belief(problem.robot(), problem.start());
  std::size_t k = 0;
  for (auto _ : state) belief.add(scans[k++ % scans.size()]);
  state.SetComplexityN(state.range(0));
}

void BM_BoustrophedonOnline(benchmark::State& state) {
  const Problem problem = rooms_with_lidar(state.range(0));
  const auto planner = built_in_planner("boustrophedon", {});
  for (auto _ : state) {
    Context context(1);
    benchmark::DoNotOptimize(plan_online(
        problem, context, [&](const Problem& believed, Context& inside) { return planner->plan(believed, inside); }));
  }
}
BENCHMARK(BM_LidarScan)->RangeMultiplier(2)->Range(90, 1440)->Unit(benchmark::kMicrosecond)->Complexity(benchmark::oN);
BENCHMARK(BM_BeliefAdd)->RangeMultiplier(2)->Range(90, 1440)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_BoustrophedonOnline)->Arg(360)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace oxturn

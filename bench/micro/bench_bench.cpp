// What the harness adds to a run, and what its own parts cost.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "algorithms/coverage_planner.hpp"
#include "base/temporary_folder.hpp"
#include "bench/isolate.hpp"
#include "bench/run_suite.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "reports/built_in_registry.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

class OneLeg final : public CoveragePlanner {
 public:
  Path plan(const Problem& problem, Context&) const override {
    return {{{true, {problem.start(), problem.start() + Point(0.1, 0)}}}};
  }
};
// Time of a suite with n runs of a planner that does nothing, less planning and scoring, for each run. Includes
// making the map, building the problem, starting processes, drawing and writing files. Must stay below 5 ms.
void BM_SuiteOverhead(benchmark::State& state) {
  Suite suite;
  suite.name = "overhead";
  suite.repeats = static_cast<int>(state.range(0));
  suite.robots.push_back(Robot{});
  MapSpec map;
  map.generator = "clutter";
  suite.maps.push_back(map);
  suite.planners.push_back({"one_leg", {}});
  Registry registry = built_in_registry();
  PlannerInfo planner;
  planner.name = "one_leg";
  planner.make = [](const Settings&, const Planners&) { return std::make_unique<OneLeg>(); };
  registry.planners.add(planner);
  const TemporaryFolder folder;
  double beyond = 0, runs = 0;
  for (auto _ : state) {
    SuiteRunOptions options;
    options.folder = folder.file("out");
    options.progress = false;
    const auto before = std::chrono::steady_clock::now();
    const Results results = run_suite(suite, registry, options);
    beyond += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    for (const Row& row : results.rows)
      beyond -= row.number("plan_wall_s").value_or(0) + row.number("score_s").value_or(0);
    runs += static_cast<double>(results.rows.size());
    state.PauseTiming();
    std::filesystem::remove_all(options.folder);
    state.ResumeTiming();
  }
  state.counters["ms_per_run"] = 1e3 * beyond / runs;
}
BENCHMARK(BM_SuiteOverhead)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

// A process and back, with a path of so many points.
class ManyPoints final : public CoveragePlanner {
 public:
  explicit ManyPoints(std::int64_t points) : points_(points) {}
  Path plan(const Problem& problem, Context&) const override {
    return {{{true, Polyline(static_cast<std::size_t>(points_), problem.start())}}};
  }

 private:
  std::int64_t points_;
};
void BM_Isolated(benchmark::State& state) {
  const auto make = [n = state.range(0)] { return std::make_unique<ManyPoints>(n); };
  const Problem problem(generate("rectangle", {}, 1), Robot{});
  for (auto _ : state) {
    const Planned planned = plan_isolated(make, problem, {});
    if (planned.outcome != Outcome::ok) state.SkipWithError(planned.reason.c_str());
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_Isolated)
    ->RangeMultiplier(16)
    ->Range(16, 1 << 20)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);

}  // namespace
}  // namespace oxturn

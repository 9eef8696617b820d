// oxturn missing: which runs of a suite have no result yet.
#include <fmt/format.h>

#include <memory>
#include <set>

#include "bench/merge.hpp"
#include "bench/shard.hpp"
#include "cli/commands.hpp"
#include "cli/programs.hpp"
#include "cli/suites.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string suite;
  std::vector<std::string> folders, programs;
  std::size_t shards = 0;
};

/// "1,4,5": what `sbatch --array` takes.
std::string shards_of(const std::vector<MissingRun>& missing, std::size_t shards, std::size_t runs) {
  std::set<std::size_t> all;
  for (std::size_t k = 1; k <= shards; ++k) {
    const auto [first, last] = Shard{k, shards}.range(runs);
    for (const MissingRun& run : missing)
      if (run.index >= first && run.index < last) all.insert(k);
  }
  return fmt::format("{}", fmt::join(all, ","));
}

int run(const Options& options, const Registry& built_in) {
  const auto [registry, programs] = with_programs(built_in, options.programs);
  Suite suite = read_suite(find_suite(options.suite), registry);
  add_unnamed(programs, suite);
  Planners planners = registry.planners;
  for (const PlannerInfo& program : suite.programs) planners.add(program);
  const std::vector<MissingRun> missing = missing_runs(suite, planners, options.folders);
  if (options.shards > 0 && !missing.empty()) {
    fmt::print("{}\n", shards_of(missing, options.shards, run_count(suite)));
  } else if (options.shards == 0) {
    for (const MissingRun& m : missing) fmt::print("{} {} {} {}\n", m.map, m.robot, m.variant, m.repeat);
  }
  return missing.empty() ? 0 : 1;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("SUITE", options->suite, "the suite, as `oxturn run` was given it")->required()->type_name("");
  app.add_option("DIR", options->folders, "its results folders")->required()->type_name("");
  add_programs(app, options->programs);
  app.add_option("--shards", options->shards,
                 "print the numbers of those of N shards that have runs to do, as `sbatch --array` takes them")
      ->check(CLI::Range(1, 1000000).description(""))
      ->type_name("N");
  return [options, &registry] { return run(*options, registry); };
}

}  // namespace

Command missing_command() {
  return {"missing", "name the runs of a suite that have no result yet",
          "  oxturn missing quick out                     map, robot, planner and repeat, a line each\n"
          "  oxturn missing my.toml out/* --shards 16\n"
          "\nExit code 1 if a run is missing.\n",
          attach};
}

}  // namespace oxturn::cli

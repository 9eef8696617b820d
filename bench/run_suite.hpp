/// Runs a suite: every run in its own process, one row each, whatever the planner does.
///
///   const Registry registry = built_in_registry();
///   const Results results = run_suite(read_suite("quick.toml", registry), registry, {.folder = "out", .jobs = 2});
///
/// The output folder: runs.csv; metrics.csv (figures that planners recorded, if any did); trace.csv
/// (coverage along the paths); columns.json; session.json;
/// paths/RUN_ID.geojson; maps/PROBLEM_HASH.geojson (problem file: map, robot, start; readable by `oxturn plan` and by
/// Shapely); pictures/RUN_ID.svg; traces/RUN_ID.json; tethers/RUN_ID.csv; logs/RUN_ID.log (what the planner printed).
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "bench/registry.hpp"
#include "bench/results.hpp"
#include "bench/shard.hpp"
#include "bench/suite.hpp"

namespace oxturn {

struct SuiteRunOptions {
  std::string folder;
  int jobs = 1;
  Shard shard = {};      // of the suite's runs; all of them by default
  bool resume = false;   // keep existing rows (except cancelled and infrastructure), run the missing ones
  bool traces = false;   // also ask planners for drawings of their inside (costs them time) and keep them
  bool pictures = true;  // draw every path
  bool progress = true;  // a bar on a terminal, plain lines otherwise, on standard error
  std::vector<std::string> command_line;  // for session.json
};
/// The user pressed Ctrl-C: finished rows are kept, runs in progress become `cancelled`.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Every run leaves one row; rows stand in suite order whatever -j. A map that cannot be made, or in which the
/// robot fits nowhere, gives `infeasible` rows with the reason. The caller must be single-threaded.
/// Throws std::invalid_argument for a folder that already holds results (without resume), holds those of another
/// suite (with it) or is in use; std::runtime_error for one that cannot be written; Interrupted.
Results run_suite(const Suite& suite, const Registry& registry, const SuiteRunOptions& options);
/// The same without reading the rows again: memory does not grow with their number, but for some 30 bytes each.
void run_suite_into_folder(const Suite& suite, const Registry& registry, const SuiteRunOptions& options);

}  // namespace oxturn

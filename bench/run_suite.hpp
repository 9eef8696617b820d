// Runs a suite: every run in its own process, one row each, whatever the planner does.
//
// Layout of the output folder: runs.csv, metrics.csv (what planners report of themselves, if any does), columns.json,
// session.json, paths/RUN_ID.geojson,
// maps/PROBLEM_HASH.geojson (problem file: map, robot, start; readable by `oxturn plan` and by Shapely),
// traces/RUN_ID.json, logs/RUN_ID.log (what the planner printed, only if it did).
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/results.hpp"
#include "bench/suite.hpp"
#include "geometry/trace.hpp"

namespace oxturn {

/// What came of one isolated call of plan().
struct Planned {
  Outcome outcome = Outcome::ok;  // ok means: returned a path (not yet scored)
  std::string reason;
  int exit_code = 0, signal = 0;
  std::optional<Path> path;  // the result, or the last published one
  std::vector<Trace> traces;
  double wall_s = 0, cpu_s = 0;
  double peak_rss_bytes = 0;  // growth of resident memory during plan(), at its peak
  std::vector<std::pair<std::string, double>> reports;  // Context::report, in order; of one name the last
  void report(const std::string& name, double value);
};

struct IsolationOptions {
  Limits limits;
  std::uint64_t seed = 1;
  bool traces = false;
  std::string log_file;                  // planner's stdout and stderr; empty: discarded
  std::function<void(double)> progress;  // optional
};
/// Forks, plans in the child under wall and memory limits, kills its process group when they are broken, and
/// gathers what it sent. Never throws for anything the planner does. The caller must be single-threaded.
Planned plan_isolated(const PlannerInfo& planner, const Settings& settings, const Problem& problem,
                      const IsolationOptions& options);

struct SuiteRunOptions {
  std::string folder;
  int jobs = 1;
  bool resume = false;   // keep rows that are there (except cancelled and infrastructure), run the missing ones
  bool traces = false;   // also ask planners for pictures of their inside (costs them time) and keep them
  bool progress = true;  // a bar on a terminal, plain lines otherwise, on standard error
  std::vector<std::string> command_line;  // for session.json
};
/// Somebody pressed Ctrl-C: the rows that were there are kept, the runs that were under way say `cancelled`.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Every run leaves one row; rows stand in suite order whatever -j. A map that cannot be made, or in which the
/// robot fits nowhere, gives `infeasible` rows with the reason. The caller must be single-threaded.
/// Throws std::invalid_argument for a folder that already holds results (without resume), holds those of another
/// suite (with it) or is in use; std::runtime_error for one that cannot be written; Interrupted.
Results run_suite(const Suite& suite, const std::vector<PlannerInfo>& planners, const SuiteRunOptions& options);

}  // namespace oxturn

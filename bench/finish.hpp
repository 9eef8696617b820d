/// What follows planning: storing, scoring and drawing a path, in a process of its own under limits. Internal to
/// bench/.
///
///   const Finished finished = finish_isolated(task, limits);
///   finished.cells;                 // columns of runs.csv
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/isolate.hpp"
#include "bench/run_suite.hpp"
#include "bench/verdict.hpp"
#include "maps/problem.hpp"
#include "metrics/score.hpp"

namespace oxturn {

struct FinishTask {
  const Problem& problem;
  const Planned& planned;
  const Metrics& metrics;
  const SuiteRunOptions& options;
  std::string problem_file;  // within the results folder
  std::string run_id;
  ScoreOptions scoring;
};

struct Finished {
  std::map<std::string, std::string> cells;  // path_file, path_sha256, score_s and all metrics
  std::optional<Score> score;                // if the path was scored; without curve and missed pieces
  std::vector<std::string> trace;            // of trace.csv: path_m,mission_s,coverage
  std::optional<Verdict> breach;             // storing or scoring broke a limit, or failed
  std::vector<std::string> remarks;          // what went wrong after that: drawing, traces
};

/// Builds what scoring needs of a problem, once for all its paths: each of the processes would build it for itself.
void build_scoring_parts(const Problem& problem);

/// Each stage has the limits for itself.
Finished finish_isolated(const FinishTask& task, const Limits& limits);

}  // namespace oxturn

/// One call of plan() in a process of its own, under limits.
///
///   IsolationOptions options;
///   options.limits.wall_s = 20;
///   const Planned planned = plan_isolated(*planner, problem, options);
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "bench/results.hpp"
#include "geometry/trace.hpp"

namespace oxturn {

struct Limits {
  double wall_s = 60;
  double memory_mb = 4096;
};

/// Figures that a planner recorded (Context::record), in order; of one name the last.
using Records = std::vector<std::pair<std::string, double>>;

/// What came of one isolated call of plan().
struct Planned {
  Outcome outcome = Outcome::ok;  // ok means: returned a path (not yet scored)
  std::string reason;
  int exit_code = 0, signal = 0;
  std::optional<Path> path;  // the result, or the last published one
  std::vector<Trace> traces;
  double wall_s = 0, cpu_s = 0;
  double peak_rss_bytes = 0;  // growth of resident memory during plan(), at its peak
  Records records;
  void record(const std::string& name, double value);
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
/// `make` is called in the child.
Planned plan_isolated(const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem,
                      const IsolationOptions& options);

}  // namespace oxturn

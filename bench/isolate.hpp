/// The stages of a run that could go wrong in any way, each in a process of its own under limits.
///
///   IsolationOptions options;
///   options.limits.wall_s = 20;
///   const Planned planned = plan_isolated([&] { return info.make(settings, planners); }, problem, options);
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "bench/child_process.hpp"
#include "bench/results.hpp"
#include "geometry/trace.hpp"
#include "maps/formats.hpp"

namespace oxturn {

/// Figures that a planner recorded (Context::record), in order; of one name the last. At most kMostRecords.
using Records = std::vector<std::pair<std::string, double>>;
inline constexpr std::size_t kMostRecords = 1000;
/// Traces of a run are kept up to this size in all; what comes after is dropped.
inline constexpr std::size_t kMostTraceBytes = std::size_t{64} << 20;

/// What came of one isolated call of plan().
struct Planned {
  Outcome outcome = Outcome::ok;  // ok means: returned a path (not yet scored)
  std::string reason;
  int exit_code = 0, signal = 0;
  std::optional<Path> path;  // the result, or the last published one
  std::vector<Trace> traces;
  double wall_s = 0, cpu_s = 0;  // 0: plan() did not come back
  double peak_rss_bytes = 0;     // growth of resident memory during plan(), at its peak
  Records records;
  std::optional<Region> promised;  // what the planner has promised to cover (Context::promise)
};

struct IsolationOptions {
  Limits limits;
  std::uint64_t seed = 1;
  int warm_ups = 0;  // calls of plan() before the one that counts, in the same process
  bool traces = false;
  std::string log_file;                  // ChildTask::log_file
  std::function<void(double)> progress;  // optional
};

/// Plans in a child process. Never throws for anything the planner does. `make` is called in the child. Time and memory
/// are measured around plan() alone; the limit on time counts from the start of the child until plan() has returned,
/// and the transfer of the result has the same time once more. The caller must be single-threaded.
Planned plan_isolated(const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem,
                      const IsolationOptions& options);

/// What came of reading a map's file in a child process.
struct ReadResult {
  ChildReport report;           // outcome `error`: bad content, with the reader's sentence as reason
  std::optional<MapFile> file;  // if the outcome is ok
};
ReadResult read_map_isolated(const std::string& file, const Settings& settings, const MapFormats& formats,
                             const Limits& limits);

}  // namespace oxturn

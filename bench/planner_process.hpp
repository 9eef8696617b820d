/// The process that a planner runs in, and what the parent must know of it. Internal to bench/.
#pragma once

#include <sys/types.h>

#include <functional>
#include <memory>

#include "bench/isolate.hpp"

namespace oxturn {

/// A megabyte of Limits::memory_mb.
inline constexpr double kMega = 1e6;

/// Types of the frames (wire.hpp) that the child sends.
namespace frames {
inline constexpr char kPublished = 'P';  // path
inline constexpr char kResult = 'R';     // path
inline constexpr char kMeasures = 'M';   // wall s, cpu s, growth of resident memory in bytes: plan() is over
inline constexpr char kTrace = 'T';
inline constexpr char kRecorded = 'V';    // value, name: Context::report
inline constexpr char kProgressed = 'G';  // fraction
inline constexpr char kFailed = 'X';      // outcome (one byte), text
inline constexpr char kEnd = 'E';
}  // namespace frames

/// Bytes that /proc/.../statm names: the whole address space, or what is resident. 0 if it cannot be read.
double statm_bytes(const char* file, bool resident);

struct Birth {
  pid_t parent = 0;
  int log = -1;   // takes what the planner prints; -1: it is dropped
  int pipe = -1;  // takes the frames
};
/// Everything a child does, from just after the fork.
[[noreturn]] void be_planner(const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem,
                             const IsolationOptions& options, const Birth& birth);

/// Kills the process group of the planner that this process is running, if any. Safe in a signal handler.
void kill_running_planner();

}  // namespace oxturn

/// Work in a process of its own, under limits on time and memory: what reading maps, planning, scoring and drawing
/// share. Internal to bench/.
///
///   ChildTask task;
///   task.limits = {.wall_s = 20};
///   task.work = [&](int fd) { wire::send(fd, 'R', text); };               // in the child
///   task.receive = [&](char type, std::string_view payload) { ... };      // in the parent
///   const ChildReport report = run_child(task);
///
/// The child is forked, so it has everything at hand that the parent has. It leads a process group, dies with its
/// parent, sees /dev/null as standard input and a log as its output (at most 64 MiB of it; so long may its files be as
/// well, unless they are results), leaves no core dump, and where that is possible is in a control group of its own
/// (control_group.hpp). What it finds comes back through a pipe in frames (wire.hpp).
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/results.hpp"

namespace oxturn {

/// Of each stage of a run: reading or making the map and building the problem, planning, scoring, drawing.
struct Limits {
  double wall_s = 60;
  double cpu_s = 0;  // processor time; 0: no limit
  double memory_mb = 4096;
};

/// A megabyte of Limits::memory_mb.
inline constexpr double kMega = 1e6;

/// Frame types that the task's own must not use.
namespace child_frames {
inline constexpr char kFailed = 'X';   // outcome (one byte), exit code and signal (int), text: the work threw
inline constexpr char kEnd = 'E';      // the work is over
inline constexpr char kRestart = 'T';  // the limits on time start anew: another stage begins
}  // namespace child_frames

/// Thrown by the work to say how it ended, where that is not what the exception's type tells: a program that it has
/// started was killed, or took too long.
struct WorkEnded : std::runtime_error {
  WorkEnded(Outcome how, const std::string& reason, int code = 0, int signal_number = 0)
      : std::runtime_error(reason), outcome(how), exit_code(code), signal(signal_number) {}
  Outcome outcome;
  int exit_code, signal;
};

/// As ChildTask::log_file: to standard error.
inline constexpr const char* kLogToStandardError = "-";

struct ChildTask {
  std::function<void(int fd)> work;
  std::function<void(char type, std::string_view payload)> receive;
  Limits limits;
  std::string log_file;         // the child's stdout and stderr; empty: dropped; or kLogToStandardError
  bool control_group = true;    // if one can be made
  bool writes_results = false;  // files of any size; others' are no longer than a log
  std::string what;             // begins reasons: "scoring: no result after 2 s"; empty: "no result after 2 s"
};

struct ChildReport {
  Outcome outcome = Outcome::ok;  // ok: the work returned
  std::string reason;
  int exit_code = 0, signal = 0;
};

/// Never throws for anything the work does; throws std::runtime_error if no process can be started. When it returns,
/// the child and every process that it has started, daemons included, are gone. The caller must be single-threaded.
ChildReport run_child(const ChildTask& task);

/// Adopts processes whose parent has ended, from now on, and tells them from this process's own children.
class Orphans {
 public:
  Orphans();
  /// Process ids of those that have been adopted since, and have not ended. `own`: of children that are none.
  std::vector<int> adopted(const std::vector<int>& own) const;
  /// Kills all that have been adopted since, with their descendants. `own`: process ids of children to be spared.
  void kill_all(const std::vector<int>& own) const;

 private:
  std::vector<int> before_;  // process ids
};

/// Of the child that this process is running, if any: kills its process group and control group. Safe in a signal
/// handler.
void kill_running_child();

/// From the child's side: the peak of resident memory since reset_peak(), and memory at present, in bytes.
void reset_peak();
double peak_bytes();
/// Processor time of this process and of its children that have been waited for.
double own_cpu_seconds();
/// "killed by SIGSEGV (segmentation fault)".
std::string signal_text(int signal);

}  // namespace oxturn

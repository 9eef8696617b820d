/// session.json: what was run, where, when, and with which versions. Read and written here alone. Internal to bench/.
///
///   const SessionFile session = read_session_file("out");
///   session.limits.wall_s;
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bench/child_process.hpp"
#include "bench/control_group.hpp"
#include "bench/shard.hpp"

namespace oxturn {

/// One call of run_suite() for the folder: the first, or one that resumed it.
struct SessionEntry {
  std::string started;             // "2026-05-01T12:00:00Z"
  nlohmann::ordered_json machine;  // machine_description()
  int jobs = 1;
  std::vector<std::string> command_line;
  Confinement isolation = {};  // of the planners' processes
};

/// A planner or metric from outside.
struct OutsideEntry {
  std::string name, origin, identity;  // as PlannerInfo and Metric have them
};

struct SessionFile {
  std::string suite, suite_file;  // name and file of the suite
  Limits limits;
  int warm_ups = 0;
  double target_coverage = 0;
  std::vector<std::pair<std::string, std::string>> robots;  // name, canonical_text()
  nlohmann::ordered_json build;                             // build_description()
  std::vector<OutsideEntry> programs;                       // planners of the suite that are not part of oxturn
  std::vector<OutsideEntry> metrics;                        // metrics that are not
  std::vector<SessionEntry> sessions;                       // in order
  Shard shard = {};                                         // whose runs the folder holds
  std::size_t runs = 0;                                     // of the whole suite
  std::string suite_identity = {};                          // suite_identity()
  nlohmann::ordered_json rescored =
      nullptr;  // build_description() of another build whose rescore() was the last; or null
  /// Of the build that planned, and of the one that scored; "unknown" if it is not said.
  std::string build_identity() const;
  std::string scoring_identity() const;
};

/// Throws std::invalid_argument if there is no such file, or one of other content.
SessionFile read_session_file(const std::string& folder);
/// Throws std::runtime_error if it cannot be written.
void write_session_file(const std::string& folder, const SessionFile& session);

/// What a reader of the tables must know of it: limits, robots, machine and build, a line each.
std::vector<std::string> summary(const SessionFile& session);

/// JSON as text in UTF-8, whatever bytes a command line or a planner had.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace oxturn

/// The results folder around runs.csv: created, locked, resumed. Internal to bench/.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/run_suite.hpp"
#include "bench/session_file.hpp"
#include "bench/wire.hpp"

namespace oxturn {

/// Locks the open runs.csv of a results folder, until the descriptor is closed. Throws std::invalid_argument if another
/// process has locked it.
void lock_results(const wire::Descriptor& runs_csv, const std::string& folder);

/// Writes session.json (what ran, where, when; one entry a session) and columns.json; makes the subfolders.
/// Refuses what run_suite() promises to refuse, before anything is written.
class Session {
 public:
  Session(const Suite& suite, const Planners& planners, const Metrics& metrics, const SuiteRunOptions& options);

  /// Rows that an earlier session left, by run_id, attempts in order.
  const std::map<std::string, std::vector<Row>>& earlier() const { return earlier_; }
  /// Appends a whole line, or throws std::runtime_error and leaves nothing of it.
  void append(const std::string& line);
  /// Replaces all rows by `lines`; the header is added.
  void rewrite(const std::string& lines);

 private:
  void open();
  void take_up(const Suite& suite);
  void compare(const char* kind, const std::vector<OutsideEntry>& entries,
               const std::vector<OutsideEntry>& before) const;
  void describe(const Suite& suite, const SuiteRunOptions& options);

  Columns columns_;
  std::string folder_, file_;
  std::string suite_identity_;
  Shard shard_;
  std::map<std::string, std::vector<Row>> earlier_;
  std::vector<SessionEntry> sessions_;  // earlier ones
  std::vector<OutsideEntry> programs_, metrics_;
  wire::Descriptor out_;
};

}  // namespace oxturn

/// A CSV file beside runs.csv with several lines for each run: metrics.csv (figures that planners recorded) and
/// trace.csv (coverage along the path). In suite order; no file if no run has lines. Internal to bench/.
///
///   RunLines metrics(folder, "metrics.csv", "run_id,metric,value\n");
///   metrics.append(run_id, {"scans,12", "explored_share,0.9"});
#pragma once

#include <map>
#include <string>
#include <vector>

namespace oxturn {

inline constexpr const char* kTraceHeader = "run_id,path_m,mission_s,coverage\n";
inline constexpr const char* kMetricsHeader = "run_id,metric,value\n";

class RunLines {
 public:
  /// Reads what an earlier session left in `folder`, if anything; an incomplete last line is dropped. Throws
  /// std::invalid_argument if the lines have not as many cells as the header.
  /// `keep`: for put_in_order(); without it nothing is kept in memory.
  RunLines(const std::string& folder, const std::string& name, std::string header, bool keep = true);
  /// Replaces what is known of the run; the file stays as it is until put_in_order(). `lines`: without run_id and line
  /// break.
  void set(const std::string& run_id, const std::vector<std::string>& lines) {
    if (keep_) all_[run_id] = lines;
  }
  /// The same, and appends to the file at once.
  void append(const std::string& run_id, const std::vector<std::string>& lines);
  /// Replaces the file as a whole: the runs in this order, without those that are not listed.
  void put_in_order(const std::vector<std::string>& run_ids);

 private:
  std::string file_, header_;
  bool keep_;
  std::map<std::string, std::vector<std::string>> all_;  // by run
};

}  // namespace oxturn

/// metrics.csv: figures that planners recorded (Context::record), which the path does not show. One line
/// `run_id,metric,value` each, in suite order; no file if no planner recorded any. Internal to bench/.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/isolate.hpp"

namespace oxturn {

class MetricsFile {
 public:
  /// Reads what an earlier session left in `folder`, if anything; an incomplete last line is dropped.
  explicit MetricsFile(const std::string& folder);
  /// Replaces what was known of the run, and appends to the file at once.
  void append(const std::string& run_id, const Records& records);
  /// Writes the file again, in this order, without runs that are not listed.
  void put_in_order(const std::vector<std::string>& run_ids);

 private:
  std::string file_;
  std::map<std::string, Records> all_;
};

}  // namespace oxturn

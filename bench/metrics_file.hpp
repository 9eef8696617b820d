// metrics.csv: figures that planners report of themselves (Context::report), which no path shows. One line
// `run_id,metric,value` each, in suite order; no file if no planner reports anything. Internal to bench/.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace oxturn {

using Records = std::vector<std::pair<std::string, double>>;  // name, value

class MetricsFile {
 public:
  /// Reads what an earlier session left in `folder`, if anything; a last line that was cut off is dropped.
  explicit MetricsFile(const std::string& folder);
  /// Takes the place of what was known of the run, and appends it to the file at once.
  void append(const std::string& run_id, const Records& reports);
  /// Writes the whole anew, in this order, without runs that are not listed.
  void put_in_order(const std::vector<std::string>& run_ids);

 private:
  std::string file_;
  std::map<std::string, Records> all_;
};

}  // namespace oxturn

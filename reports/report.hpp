// Tables and pictures from a results folder alone.
#pragma once

#include <string>
#include <vector>

#include "bench/results.hpp"

namespace oxturn {

struct Written {
  std::vector<std::string> files;
};
/// Writes report.md (comparison table over planners, the tether table if a robot has one, then one table per map) and gallery/RUN_ID.svg for every run
/// with a path, plus gallery.html that shows them side by side. Returns what was written.
Written write_report(const Results& results, const std::string& folder);
/// The comparison table as Markdown.
std::string comparison_table(const Results& results);
/// How the planners treat the tether, as Markdown; "" if no run has one that could be followed.
std::string tether_table(const Results& results);

}  // namespace oxturn

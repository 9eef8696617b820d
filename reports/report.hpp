// Tables and pictures from a results folder alone.
#pragma once

#include <string>
#include <vector>

#include "bench/results.hpp"

namespace oxturn {

struct Written {
  std::vector<std::string> files;
};
/// Writes report.md (comparison table over planners, then one table per map) and gallery/RUN_ID.svg for every run
/// with a path, plus gallery.html that shows them side by side. Returns what was written.
Written write_report(const Results& results, const std::string& folder);
/// The comparison table as Markdown.
std::string comparison_table(const Results& results);

}  // namespace oxturn

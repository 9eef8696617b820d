// The parts that make report.md and gallery.html.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/groups.hpp"

namespace oxturn {

/// run_id -> picture, relative to the report's folder.
using Pictures = std::map<std::string, std::string>;

/// One Markdown table: a row a run, of one map and robot.
std::string map_table(const RowGroup& map, const Pictures& pictures);
/// A page with a grid of pictures: rows maps, columns planner variants. No scripts, nothing from outside.
std::string gallery_page(const Results& results, const Pictures& pictures);

}  // namespace oxturn

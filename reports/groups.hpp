/// Rows of a results folder in groups, for reports. Everything keeps the order of the suite.
#pragma once

#include <string>
#include <vector>

#include "bench/results.hpp"

namespace oxturn {

struct RowGroup {
  std::string title;
  std::vector<const Row*> rows;
};

/// One group for each planner variant.
std::vector<RowGroup> by_variant(const Results& results);
/// One group for each map and robot. The title is the map's name, followed by what distinguishes it: the robot if there
/// are several, the beginning of the hash if two maps have the same name.
std::vector<RowGroup> by_map(const Results& results);

}  // namespace oxturn

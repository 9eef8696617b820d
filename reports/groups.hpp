// Rows of a results folder, grouped the ways reports need them. Everything keeps the order of the suite.
#pragma once

#include <string>
#include <vector>

#include "bench/results.hpp"

namespace oxturn {

struct RowGroup {
  std::string title;
  std::vector<const Row*> rows;
};

/// One group a planner variant.
std::vector<RowGroup> by_variant(const Results& results);
/// One group a map and robot. The title is the map's name, followed by what is needed to tell it from others: the
/// robot if there are several, the beginning of the hash if two maps bear one name.
std::vector<RowGroup> by_map(const Results& results);

}  // namespace oxturn

/// A named drawing of something inside an algorithm (cells, a tree, a partition), for pictures.
#pragma once

#include <string>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

struct Trace {
  std::string name;
  std::vector<Polyline> lines;  // closed ones repeat their first point
};

}  // namespace oxturn

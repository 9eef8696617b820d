/// A named drawing of an algorithm's intermediate result (cells, a tree, a partition), for the gallery.
///
///   Trace{"tree", {{a, b}, {b, c}}}
#pragma once

#include "geometry/point.hpp"

namespace oxturn {

struct Trace {
  std::string name;
  std::vector<Polyline> lines;  // a closed one repeats its first point
};

}  // namespace oxturn

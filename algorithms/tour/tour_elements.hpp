/// What a tour is made of: elements, each of which is driven once, in one of its patterns.
///
///   TourElement line{{a, b, length, 1}, {b, a, length, 0}};       // a polyline, from either end
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

/// How an element can be driven. `reverse` is the index of the pattern that drives it backwards, from `exit` to
/// `entry`, at the same cost.
struct Pattern {
  Point entry, exit;
  double cost = 0;
  std::size_t reverse = 0;
};
using TourElement = std::vector<Pattern>;  // at least one pattern
struct TourStop {
  std::size_t element = 0, pattern = 0;
  friend bool operator==(const TourStop&, const TourStop&) = default;
};

}  // namespace oxturn

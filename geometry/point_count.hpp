/// How many points a path has. Not installed.
///
///   points.reserve(point_count(path.legs));
#pragma once

#include <cstddef>
#include <span>

#include "geometry/path.hpp"

namespace oxturn {

inline std::size_t point_count(std::span<const Leg> legs) {
  std::size_t count = 0;
  for (const Leg& leg : legs) count += leg.points.size();
  return count;
}

}  // namespace oxturn

/// A path as one polyline, whatever its legs.
///
///   const FlatPath flat(path, problem.start());
///   for (std::size_t i = 0; i < flat.tool.size(); ++i) ...   // segment from flat.points[i] to flat.points[i + 1]
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point_count.hpp"

namespace oxturn {

struct FlatPath {
  FlatPath(const Path& path, const Point& start) : points{start} {
    const std::size_t n = 1 + point_count(path.legs);
    points.reserve(n);
    tool.reserve(n);
    for (const Leg& leg : path.legs)
      for (std::size_t i = 1; i < leg.points.size(); ++i) {
        points.push_back(leg.points[i]);
        tool.push_back(leg.tool);
      }
  }
  /// Metres.
  double length(std::size_t segment) const { return distance(points[segment], points[segment + 1]); }

  Polyline points;         // from the start on
  std::vector<bool> tool;  // is it on? By segment
};

}  // namespace oxturn

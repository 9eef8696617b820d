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

/// Drives the segments from `first` to before `end`.
inline void drive_segments(const FlatPath& path, std::size_t first, std::size_t end, PathBuilder& builder) {
  constexpr std::size_t kMost = 1024;  // points at a time
  Polyline points;
  while (first < end) {
    const bool tool = path.tool[first];
    points.clear();
    for (; first < end && path.tool[first] == tool && points.size() < kMost; ++first)
      points.push_back(path.points[first + 1]);
    builder.drive(points, tool);
  }
}

}  // namespace oxturn

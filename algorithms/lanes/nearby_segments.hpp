/// Which segments of a path are near a point.
///
///   const NearbySegments segments(path);
///   for (const NearbySegments::Near& near : segments.near(p, 2 * w, 12)) ...    // the nearest first
///
/// Build once: O(n log n) for n segments. A query costs the segments near the point. Where the points are known before,
/// it holds only the segments near them: of a path with millions of segments a few.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {

class NearbySegments {
 public:
  /// `path` must outlive it; at least one point.
  explicit NearbySegments(const Polyline& path);
  /// The same for queries about these points, with `within` metres at most.
  NearbySegments(const Polyline& path, const std::vector<Point>& points, double within);
  struct Near {
    double distance;
    std::size_t segment;
    Point at;  // on the segment
  };
  /// Segments nearer to p than `within`, the nearest first, at most `most`.
  std::vector<Near> near(const Point& p, double within, std::size_t most) const;
  double along(const Near& near) const { return distance(path_[near.segment], near.at); }

 private:
  void build();

  const Polyline& path_;
  std::vector<std::uint32_t> held_;  // segments, ascending
  BoxIndex index_;                   // of their boxes
};

}  // namespace oxturn

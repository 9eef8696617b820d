/// Which segments of a path are near a point.
///
///   const NearbySegments segments(path);
///   for (const NearbySegments::Near& near : segments.near(p, 2 * w, 12)) ...    // the nearest first
///
/// Build once: O(n log n) for n segments. A query costs the segments near the point.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {

class NearbySegments {
 public:
  /// `path` must outlive it; at least one point.
  explicit NearbySegments(const Polyline& path);
  struct Near {
    double distance;
    std::size_t segment;
    Point at;  // on the segment
  };
  /// Segments nearer to p than `within`, the nearest first, at most `most`.
  std::vector<Near> near(const Point& p, double within, std::size_t most) const;
  double along(const Near& near) const { return distance(path_[near.segment], near.at); }

 private:
  const Polyline& path_;
  BoxIndex index_;
};

}  // namespace oxturn

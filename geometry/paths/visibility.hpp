/// What a point sees of a region.
///
///   const Visibility visibility(free_space);
///   const Ring seen = visibility.from(eye);
#pragma once

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

/// Walls block sight, touching a vertex does not. Build once: O(n log n) for n vertices. May be used by several
/// threads.
class Visibility {
 public:
  explicit Visibility(const Region& region) : mesh_(region) {}

  /// The star-shaped polygon that `eye` sees, counter-clockwise. Its vertices are vertices of the region and, rounded,
  /// the points where rays past a vertex end. Exact predicates decide which vertices are seen. O(triangles seen),
  /// usually. An eye outside the region by at most `tolerance` is moved into it; throws std::invalid_argument if it is
  /// farther outside.
  Ring from(const Point& eye, double tolerance = 0) const;

 private:
  std::vector<std::int32_t> home_of(Point& eye, double tolerance) const;
  Mesh mesh_;
};

}  // namespace oxturn

/// What a point sees of a region.
///
///   const Visibility visibility(free_space);
///   const Ring seen = visibility.from(eye);
#pragma once

#include <utility>
#include <vector>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

/// Walls block sight, touching a vertex does not. Build once: O(n log n) for n vertices. May be used by several
/// threads.
class Visibility {
 public:
  explicit Visibility(const Region& region) : mesh_(region) {}
  /// The same for a region that is meshed already; barriers of the mesh block sight as walls do.
  explicit Visibility(Mesh mesh) : mesh_(std::move(mesh)) {}
  const Mesh& mesh() const { return mesh_; }

  /// The star-shaped polygon that `eye` sees, counter-clockwise. Its vertices are vertices of the region and, rounded,
  /// the points where rays past a vertex end. Exact predicates decide which vertices are seen. O(triangles seen),
  /// usually. An eye outside the region by at most `tolerance` is moved into it; throws std::invalid_argument if it is
  /// farther outside.
  /// `near`, if given, gets points of the mesh, ascending: the vertices of all triangles of which something is seen.
  Ring from(const Point& eye, double tolerance = 0, std::vector<std::int32_t>* near = nullptr) const;

  /// Directions from the eye: counter-clockwise from `right` to `left`, by less than pi. Of any length above 0.
  struct ViewSector {
    Point right, left;
  };
  /// The same, but only what is seen in the sector: the polygon begins at the eye. O(triangles seen there). `near` gets
  /// the vertices of all triangles at the eye, too.
  Ring from(const Point& eye, const ViewSector& sector, double tolerance = 0,
            std::vector<std::int32_t>* near = nullptr) const;

 private:
  std::vector<std::int32_t> home_of(Point& eye, double tolerance) const;
  Mesh mesh_;
};

}  // namespace oxturn

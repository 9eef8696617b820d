/// The triangles of an input, by CGAL. Private to geometry, not installed.
#pragma once

#include "geometry/mesh/mesh.hpp"
#include "geometry/mesh/triangulation_input.hpp"

namespace oxturn {

struct Triangulation {
  std::vector<Point> points;  // those of the input, then points in which segments cross
  std::vector<Mesh::Triangle> triangles;
};

/// The triangles inside the region, constrained to its edges and barriers, Delaunay otherwise. O(n log n).
Triangulation triangulate(const TriangulationInput& input, const Region& region);

}  // namespace oxturn

/// The shortest path through a sleeve: triangles of a mesh, each beside the one before. Private to geometry and to what
/// searches its meshes, not installed.
///
///   const Polyline path = shortest_in_sleeve(mesh, start, {4, 7, 8, 2}, goal);
///
/// Source      Lee and Preparata, "Euclidean shortest paths in the presence of rectilinear barriers", 1984 (the funnel)
/// Complexity  O(triangles) in most sleeves, since a bend seldom goes back by more than a few portals
#pragma once

#include <cstdint>
#include <span>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

/// An edge between two triangles of a sleeve, seen in the direction of the path.
struct Portal {
  Point left, right;
};
Portal portal_between(const Mesh& mesh, std::int32_t from, std::int32_t to);

/// From a point of the first triangle to one of the last, both points included; it bends only at vertices. No triangle
/// may occur twice.
Polyline shortest_in_sleeve(const Mesh& mesh, const Point& start, std::span<const std::int32_t> triangles,
                            const Point& goal);

}  // namespace oxturn

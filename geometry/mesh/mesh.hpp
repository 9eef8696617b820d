/// The constrained Delaunay triangulation of a region, as plain arrays: the base of shortest paths, visibility,
/// partitions and geodesic fields.
///
///   const Mesh mesh(free_space);
///   const std::int32_t t = mesh.locate(p, tolerance);      // Mesh::kWall: p is outside
///   for (const std::int32_t n : mesh.triangle(t).neighbour) if (n != Mesh::kWall) visit(n);
///
/// The edges and neighbours of a triangle are numbered by the opposite vertices:
///
///                0
///       edge 2  / \  edge 1
///              /   \   (towards neighbour 1)
///             1-----2
///              edge 0
///
/// Triangulated by CGAL, whose types stay in the .cpp file. Immutable after construction.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "geometry/region.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

class Mesh {
 public:
  /// O(n log n). The triangles cover exactly the region's interior. A barrier is a line that no path crosses: both its
  /// sides are walls. An end of a barrier inside an edge of a ring becomes a point of the mesh, and the edge bends
  /// there by as much as the end was rounded. Throws std::invalid_argument for points that are not finite.
  explicit Mesh(const Region& region, const std::vector<Polyline>& barriers = {});

  static constexpr std::int32_t kWall = -1;  // in place of a triangle: none
  struct Triangle {
    std::array<std::int32_t, 3> vertex;     // counter-clockwise, indices into points()
    std::array<std::int32_t, 3> neighbour;  // across the edge opposite vertex[i]; kWall at the boundary and at barriers
  };
  /// The region's different vertices in input order, then ends and crossings of barriers.
  const std::vector<Point>& points() const { return points_; }
  const Point& point(std::int32_t i) const { return points_[static_cast<std::size_t>(i)]; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const Triangle& triangle(std::int32_t t) const { return triangles_[static_cast<std::size_t>(t)]; }
  /// Vertex k of triangle t; k is taken modulo 3.
  const Point& vertex(std::int32_t t, std::size_t k) const { return point(triangle(t).vertex[k % 3]); }
  /// The first edge of triangle t that leads to triangle n.
  std::size_t edge_towards(std::int32_t t, std::int32_t n) const {
    std::size_t k = 0;
    while (triangle(t).neighbour[k] != n) ++k;
    return k;
  }
  /// Which vertex of triangle t is this point of the mesh?
  std::size_t index_in(std::int32_t t, std::int32_t point) const {
    std::size_t k = 0;
    while (triangle(t).vertex[k] != point) ++k;
    return k;
  }
  /// Is there more than 180 degrees of free space at this point? Only there a shortest path can bend. Where rings touch
  /// or barriers end, each fan of triangles about the point counts by itself: free space on both sides of a single
  /// point is not connected through it.
  bool is_reflex(std::int32_t point) const { return reflex_[static_cast<std::size_t>(point)]; }

  /// A triangle that contains p (its boundary included), or the nearest one if p is outside by at most `tolerance`;
  /// otherwise kWall. Expected O(1), by a grid.
  std::int32_t locate(const Point& p, double tolerance) const;
  /// All triangles that contain p, in ascending order: several for a vertex or a point on an inner edge.
  void locate_all(const Point& p, std::vector<std::int32_t>& found) const;
  /// Moves p into the mesh, by at most `tolerance`, and lists the triangles that contain it up to rounding, in
  /// ascending order. False if p is farther outside. The search begins at what `found` holds: that of a point near by
  /// makes it short.
  bool move_inside(Point& p, double tolerance, std::vector<std::int32_t>& found) const;
  /// Where there is room: the centre of the largest circle inscribed in a triangle, of the centres that are accepted
  /// (without a condition: all); of equal circles the first triangle's. No wall is nearer than the circle's radius.
  /// O(n + k log n) for k centres refused.
  std::optional<Point> roomiest_point(const std::function<bool(const Point&)>& accepted = {}) const;
  /// The point of the triangle nearest to p.
  Point nearest_in(std::int32_t triangle, const Point& p) const;

 private:
  void find_reflex_points();
  bool fan_is_reflex(std::int32_t first, std::size_t k) const;
  std::int32_t walk(const Point& p, std::int32_t from) const;

  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<bool> reflex_;
  UniformGrid grid_;
};

}  // namespace oxturn

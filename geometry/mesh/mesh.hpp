// Constrained Delaunay triangulation of a region, as plain arrays. Base of shortest paths, partitions and
// (later) the taut string. CGAL makes it; nothing of CGAL is seen here.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/uniform_grid.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class Mesh {
 public:
  /// O(n log n). Triangles cover exactly the region's interior. No way leads across a barrier: both sides of it are
  /// walls. Ends of barriers that lie inside an edge of a ring become points of the mesh, and the edge bends there by as
  /// much as they were rounded.
  explicit Mesh(const Region& region, const std::vector<Polyline>& barriers = {});

  static constexpr std::int32_t kWall = -1;
  struct Triangle {
    std::array<std::int32_t, 3> vertex;     // counter-clockwise, into points()
    std::array<std::int32_t, 3> neighbour;  // across the edge opposite vertex[i]; kWall at the boundary and at barriers
  };
  const std::vector<Point>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// True for a point where the boundary turns away from free space (more than 180 degrees of it): the only
  /// places where a shortest path can bend. Where rings touch or barriers end, each fan of triangles counts by itself:
  /// free space that hangs together in one point only is not connected.
  bool is_reflex(std::int32_t point) const { return reflex_[static_cast<std::size_t>(point)]; }

  /// A triangle that holds p (closed), or the nearest one if p is outside by no more than `tolerance`;
  /// else kWall. Expected O(1) by a grid.
  std::int32_t locate(const Point& p, double tolerance) const;
  /// All triangles that hold p (closed), ascending: several for a corner or a point on an inner edge.
  void locate_all(const Point& p, std::vector<std::int32_t>& found) const;
  /// Nearest point of the triangle to p (p itself if it is inside).
  Point nearest_in(std::int32_t triangle, const Point& p) const;

 private:
  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<bool> reflex_;
  UniformGrid grid_;
};

}  // namespace oxturn

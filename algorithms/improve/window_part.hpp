/// The part of a path in a window, which may be changed, and what is outside, which may not.
///
///   const WindowPart part(path, window, walls, tool_width, false);
///   VertexPath inside(part.points(), part.fixed(), tool_width);  // change it
///   const Polyline changed = part.joined(inside);                // the whole path
///
/// Windows are turned as witnesses are. Of the path between two visits of the window, the first and the last vertex
/// are kept beside the visits, so that the path's directions there are known. O(n) for n vertices.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/improve/moves.hpp"
#include "algorithms/improve/vertex_path.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {

class WindowPart {
 public:
  /// `fixed_end`: the path ends where it does now. `walls` must outlive it.
  WindowPart(const Polyline& path, const Box& window, const EdgeIndex& walls, double width, bool fixed_end);

  /// The visits of the window one after the other. Empty: there is none.
  const Polyline& points() const { return points_; }
  const std::vector<std::size_t>& fixed() const { return fixed_; }
  /// The whole path with these points, to know what it covers.
  Polyline parts() const { return assembled(VertexPath(points_, fixed_, width_)); }
  /// The whole path, where points() have become those of `inside`.
  Polyline joined(const VertexPath& inside) const;

 private:
  struct Link {
    std::size_t from, to;  // positions in points()
    Polyline outside;      // between them
  };
  std::optional<Point> cut(const Point& a, const Point& b, double t);
  std::optional<Edge> part_of(const Point& a, const Point& b, const Box& window);
  void add_fixed(const Point& p);
  void begin_visit(Polyline outside);
  void end_visit();
  Polyline assembled(const VertexPath& inside) const;
  Polyline without_made(const Polyline& path) const;

  const EdgeIndex& walls_;
  double width_;
  Polyline points_;
  std::vector<std::size_t> fixed_;
  std::size_t visit_ = 0;  // where the last visit begins
  std::vector<Link> links_;
  Polyline before_, after_;  // outside
  std::vector<Point> made_;  // where edges were cut; sorted
};

}  // namespace oxturn

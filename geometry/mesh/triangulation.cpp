#include "geometry/mesh/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <optional>

#include "geometry/edge_index.hpp"
#include "geometry/mesh/cgal_guard.hpp"

namespace oxturn {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// The number of a vertex or face; kNone in those that CGAL adds by itself.
struct Number {
  static constexpr std::int32_t kNone = -1;
  Number(std::int32_t v = kNone) : value(v) {}
  operator std::int32_t() const { return value; }
  std::int32_t value;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<Number, Kernel>>;
// Constraints that cross, as barriers may and an invalid region's edges do, meet in a rounded point.
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::Exact_predicates_tag>;
using Vertex = Cdt::Vertex_handle;
using Face = Cdt::Face_handle;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
Point point_of(Vertex v) { return {v->point().x(), v->point().y()}; }

class Triangulator {
 public:
  Triangulator(const TriangulationInput& input, const Region& region) : outline_(input), region_(region) {}

  Triangulation run() {
    out_.points = outline_.points;
    insert();
    number_crossings();
    if (cdt_.dimension() == 2) collect(free_faces());
    return std::move(out_);
  }

 private:
  static constexpr std::size_t kWorthIndex = 32;

  /// In CGAL's own order: its insert() of many points sorts numbers in place of the points, and takes a sixth longer.
  void insert_points() {
    using NumberedPoint = std::pair<Kernel::Point_2, std::int32_t>;
    using ByPoint = CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<NumberedPoint>>;
    std::vector<NumberedPoint> input;
    input.reserve(outline_.points.size());
    for (std::size_t i = 0; i < outline_.points.size(); ++i)
      input.emplace_back(Kernel::Point_2(outline_.points[i].x(), outline_.points[i].y()), static_cast<std::int32_t>(i));
    CGAL::spatial_sort(input.begin(), input.end(), ByPoint());
    vertex_.resize(input.size());
    Face near;
    for (const auto& [point, number] : input) {
      const Vertex v = vertex_[at(number)] = cdt_.insert(point, near);
      v->info() = number;
      near = v->face();
    }
  }

  void insert() {
    insert_points();
    for (const auto* segments : {&outline_.edges, &outline_.barriers})
      for (const auto& [a, b] : *segments) cdt_.insert_constraint(vertex_[at(a)], vertex_[at(b)]);
  }

  /// Constraints that cross have made new vertices.
  void number_crossings() {
    if (cdt_.number_of_vertices() <= out_.points.size()) return;
    for (const Vertex v : cdt_.finite_vertex_handles()) {
      const std::int32_t number = v->info();
      if (number != Number::kNone && at(number) < vertex_.size() && vertex_[at(number)] == v) continue;
      v->info() = static_cast<std::int32_t>(out_.points.size());
      out_.points.push_back(point_of(v));
      vertex_.push_back(v);
    }
  }

  /// The faces inside the region, in CGAL's order and numbered so; the others get the number of walls. The constraints
  /// divide the faces into connected components; a component is inside if the centroid of its largest face is. (Not by
  /// counting the constraints crossed: that fails where edges overlap in part.)
  std::vector<Face> free_faces() {
    std::vector<std::optional<Point>> inner;  // by component, the number of its faces
    for (const Face first : cdt_.all_face_handles())
      if (first->info() == Number::kNone)
        inner.push_back(number_component(first, static_cast<std::int32_t>(inner.size())));
    const std::vector<bool> free = in_region(inner);
    std::vector<Face> faces;
    for (const Face f : cdt_.all_face_handles()) {
      const bool inside = free[at(f->info())];
      f->info() = inside ? static_cast<std::int32_t>(faces.size()) : Mesh::kWall;
      if (inside) faces.push_back(f);
    }
    return faces;
  }
  std::vector<bool> in_region(const std::vector<std::optional<Point>>& points) const {
    std::optional<EdgeIndex> index;  // costs as much as some dozen passes over all edges
    if (points.size() > kWorthIndex) index.emplace(region_);
    std::vector<bool> inside;
    for (const std::optional<Point>& p : points)
      inside.push_back(p && (index ? index->contains(*p) : contains(region_, *p)));
    return inside;
  }
  /// Numbers the faces of a component and returns the centroid of the largest; nullopt for the unbounded one.
  std::optional<Point> number_component(Face first, std::int32_t number) {
    bool unbounded = false;
    double largest = -1;
    Point centroid{0, 0};
    first->info() = number;
    std::vector<Face> stack{first};
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      if (cdt_.is_infinite(f)) {
        unbounded = true;
      } else {
        const Point a = point_of(f->vertex(0)), b = point_of(f->vertex(1)), c = point_of(f->vertex(2));
        const double size = cross(b - a, c - a);
        if (size > largest) {
          largest = size;
          centroid = a + ((b - a) + (c - a)) / 3;
        }
      }
      for (int i = 0; i < 3; ++i) {
        const Face n = f->neighbor(i);
        if (n->info() != Number::kNone || f->is_constrained(i)) continue;
        n->info() = number;
        stack.push_back(n);
      }
    }
    if (unbounded) return std::nullopt;
    return centroid;
  }

  /// Does the edge between points a and b lie on a barrier? A barrier that passes through points or crosses other
  /// constraints lies on several edges.
  bool on_barrier(std::int32_t a, std::int32_t b) const {
    const auto& barriers = outline_.barriers;
    if (std::binary_search(barriers.begin(), barriers.end(), TriangulationInput::Segment(std::minmax(a, b))))
      return true;
    const Point &p = out_.points[at(a)], &q = out_.points[at(b)];
    return std::any_of(barriers.begin(), barriers.end(), [&](const TriangulationInput::Segment& barrier) {
      const Point &s = out_.points[at(barrier.first)], &e = out_.points[at(barrier.second)];
      const double near = 1e-12 * (s.norm() + e.norm());
      return distance_to_segment(p, s, e) <= near && distance_to_segment(q, s, e) <= near;
    });
  }

  void collect(const std::vector<Face>& faces) {
    out_.triangles.reserve(faces.size());
    for (const Face f : faces) {
      Mesh::Triangle t{};
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        t.vertex[k] = f->vertex(i)->info();
        t.neighbour[k] = f->neighbor(i)->info();
        if (t.neighbour[k] != Mesh::kWall && f->is_constrained(i) &&
            on_barrier(f->vertex(Cdt::cw(i))->info(), f->vertex(Cdt::ccw(i))->info()))
          t.neighbour[k] = Mesh::kWall;
      }
      out_.triangles.push_back(t);
    }
  }

  const TriangulationInput& outline_;
  const Region& region_;
  Cdt cdt_;
  std::vector<Vertex> vertex_;  // by number
  Triangulation out_;
};

}  // namespace

Triangulation triangulate(const TriangulationInput& input, const Region& region) {
  Triangulation result;
  cgal_guarded("triangulation", [&] { result = Triangulator(input, region).run(); });
  return result;
}

}  // namespace oxturn

#include "geometry/mesh/straight_skeleton.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "geometry/mesh/cgal_guard.hpp"

namespace oxturn {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<Kernel>;
using Skeleton = CGAL::Straight_skeleton_2<Kernel>;

CgalPolygon to_cgal(const Ring& ring) {
  CgalPolygon polygon;
  for (const Point& p : ring) polygon.push_back({p.x(), p.y()});
  return polygon;
}

Point to_point(const Kernel::Point_2& p) { return {p.x(), p.y()}; }

StraightSkeleton converted(const Skeleton& skeleton) {
  StraightSkeleton result;
  std::map<int, std::size_t> node, face;  // by CGAL's number
  for (auto v = skeleton.vertices_begin(); v != skeleton.vertices_end(); ++v) {
    node[v->id()] = result.nodes.size();
    result.nodes.push_back({to_point(v->point()), v->time()});
  }
  for (auto f = skeleton.faces_begin(); f != skeleton.faces_end(); ++f) {
    const auto edge = f->halfedge()->defining_contour_edge();
    const Point a = to_point(edge->opposite()->vertex()->point()), b = to_point(edge->vertex()->point());
    face[f->id()] = result.directions.size();
    result.directions.push_back((b - a).normalized());
  }
  for (auto h = skeleton.halfedges_begin(); h != skeleton.halfedges_end(); ++h) {
    const auto o = h->opposite();
    if (!h->is_bisector() || h->id() > o->id()) continue;
    std::size_t low = node.at(o->vertex()->id()), high = node.at(h->vertex()->id());
    if (result.nodes[low].time > result.nodes[high].time) std::swap(low, high);
    result.arcs.push_back({low, high, {face.at(h->face()->id()), face.at(o->face()->id())}});
  }
  return result;
}

}  // namespace

StraightSkeleton straight_skeleton(const Polygon& polygon) {
  StraightSkeleton result;
  cgal_guarded("the straight skeleton", [&] {
    CGAL::Polygon_with_holes_2<Kernel> shape(to_cgal(polygon.outer));
    for (const Ring& hole : polygon.holes) shape.add_hole(to_cgal(hole));
    const auto skeleton = CGAL::create_interior_straight_skeleton_2(shape, Kernel());
    if (!skeleton) throw std::runtime_error("no result");
    result = converted(*skeleton);
  });
  return result;
}

}  // namespace oxturn

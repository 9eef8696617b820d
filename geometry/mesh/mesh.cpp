#include "geometry/mesh/mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "geometry/mesh/cgal_guard.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// A number that CGAL leaves at -1 in what it makes by itself.
struct Number {
  Number(std::int32_t v = -1) : value(v) {}
  operator std::int32_t() const { return value; }
  std::int32_t value;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<Number, Kernel>>;
// Constraints that cross (no region has them, but none of them shall stop us) meet in a rounded point.
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::Exact_predicates_tag>;
using Vertex = Cdt::Vertex_handle;
using Face = Cdt::Face_handle;

using Pair = std::pair<std::int32_t, std::int32_t>;  // of points, the lower one first

/// Different points of the rings in input order, and the edges between them that occur an odd number of times.
struct Outline {
  std::vector<Point> points;
  std::vector<Pair> edges;
  std::vector<Pair> barriers;  // sorted
};

Outline outline(const Region& region) {
  std::vector<Point> all;
  for_each_ring(region, [&](const Ring& ring) { all.insert(all.end(), ring.begin(), ring.end()); });
  for (const Point& p : all) {
    if (!finite(p)) throw std::invalid_argument("region has a corner that is not finite; repair it before meshing");
  }
  std::vector<std::int32_t> order(all.size()), same(all.size()), id(all.size(), -1);
  for (std::size_t i = 0; i < all.size(); ++i) order[i] = static_cast<std::int32_t>(i);
  const auto at = [&](std::int32_t i) -> const Point& { return all[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(),
            [&](std::int32_t i, std::int32_t j) { return at(i) != at(j) ? before(at(i), at(j)) : i < j; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeated = k > 0 && at(order[k]) == at(order[k - 1]);
    same[static_cast<std::size_t>(order[k])] = repeated ? same[static_cast<std::size_t>(order[k - 1])] : order[k];
  }
  Outline out;
  for (std::size_t i = 0; i < all.size(); ++i) {  // `same` is the first of its kind in input order
    if (same[i] != static_cast<std::int32_t>(i)) continue;
    id[i] = static_cast<std::int32_t>(out.points.size());
    out.points.push_back(all[i]);
  }
  std::size_t base = 0;
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto of = [&](std::size_t k) { return id[static_cast<std::size_t>(same[base + k])]; };
      const std::int32_t a = of(i), b = of(i + 1 < ring.size() ? i + 1 : 0);
      if (a != b) out.edges.emplace_back(std::min(a, b), std::max(a, b));
    }
    base += ring.size();
  });
  std::sort(out.edges.begin(), out.edges.end());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.edges.size();) {
    std::size_t end = i;
    while (end < out.edges.size() && out.edges[end] == out.edges[i]) ++end;
    if ((end - i) % 2 == 1) out.edges[kept++] = out.edges[i];
    i = end;
  }
  out.edges.resize(kept);
  return out;
}

/// Adds the barriers. An end that is no corner splits the edge that it lies on, so that the rounded point is on both.
void add_barriers(const Region& region, const std::vector<Polyline>& barriers, Outline& out) {
  if (barriers.empty()) return;
  struct Known {
    Point at;
    std::int32_t id;
    bool operator<(const Known& o) const { return before(at, o.at); }
  };
  std::vector<Known> known;
  for (std::size_t i = 0; i < out.points.size(); ++i) known.push_back({out.points[i], static_cast<std::int32_t>(i)});
  std::sort(known.begin(), known.end());
  const auto find = [&](const std::vector<Known>& in, const Point& p) {
    const auto k = std::lower_bound(in.begin(), in.end(), Known{p, 0});
    return k != in.end() && k->at == p ? k->id : -1;
  };

  std::vector<Known> fresh;
  for (const Polyline& line : barriers) {
    for (const Point& p : line) {
      if (!finite(p)) throw std::invalid_argument("a barrier has a point that is not finite");
      if (find(known, p) < 0) fresh.push_back({p, -1});
    }
  }
  std::sort(fresh.begin(), fresh.end());
  fresh.erase(std::unique(fresh.begin(), fresh.end(), [](const Known& a, const Known& b) { return a.at == b.at; }),
              fresh.end());
  for (Known& f : fresh) {
    f.id = static_cast<std::int32_t>(out.points.size());
    out.points.push_back(f.at);
  }
  for (const Polyline& line : barriers) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto id = [&](const Point& p) { return std::max(find(known, p), find(fresh, p)); };
      const std::int32_t a = id(line[i - 1]), b = id(line[i]);
      if (a != b) out.barriers.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(out.barriers.begin(), out.barriers.end());
  out.barriers.erase(std::unique(out.barriers.begin(), out.barriers.end()), out.barriers.end());

  if (fresh.empty()) return;
  const EdgeIndex index(region);
  Box box;
  for (const Point& p : out.points) box.add(p);
  const double near = 1e-9 * (box.size().norm() + 1e-3 * std::max(box.low.norm(), box.high.norm()));
  struct Split {
    std::size_t edge;
    double along;
    std::int32_t id;
  };
  std::vector<Split> splits;
  for (const Known& f : fresh) {
    const auto hit = index.nearest(f.at, near);
    if (!hit) continue;  // a barrier may also end or bend in the open
    const EdgeIndex::Edge& e = index.edges()[hit->edge];
    const auto corner = [&](const Point& p) { return find(known, p); };
    const Pair ends = std::minmax(corner(e.a), corner(e.b));
    const auto at = std::lower_bound(out.edges.begin(), out.edges.end(), ends);
    if (at == out.edges.end() || *at != ends) continue;
    const Point& from = out.points[static_cast<std::size_t>(ends.first)];
    splits.push_back({static_cast<std::size_t>(at - out.edges.begin()), distance(from, f.at), f.id});
  }
  std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.along != b.along ? a.along < b.along : a.id < b.id;
  });
  for (std::size_t i = 0; i < splits.size();) {
    const std::size_t edge = splits[i].edge;
    const std::int32_t last = out.edges[edge].second;
    std::int32_t from = out.edges[edge].first;
    out.edges[edge].second = splits[i].id;
    for (; i < splits.size() && splits[i].edge == edge; ++i) {
      if (from != out.edges[edge].first) out.edges.emplace_back(from, splits[i].id);
      from = splits[i].id;
    }
    out.edges.emplace_back(from, last);
  }
}

Point point_of(Vertex v) { return {v->point().x(), v->point().y()}; }

/// Numbers the pieces that the constraints cut the faces into; a piece is free if the middle of its largest face is
/// inside. (Not by counting constraints crossed: that breaks where edges overlap in part.) Returns for each piece
/// whether it is free; the piece of a face is its info().
std::vector<bool> classify(Cdt& cdt, const Region& region) {
  const EdgeIndex index(region);
  for (const Face f : cdt.all_face_handles()) f->info() = -1;
  std::vector<bool> free;
  std::vector<Face> stack;
  for (const Face seed : cdt.all_face_handles()) {
    if (seed->info() >= 0) continue;
    const auto piece = static_cast<std::int32_t>(free.size());
    bool outside = false;
    double largest = -1;
    Point middle{0, 0};
    seed->info() = piece;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      if (cdt.is_infinite(f)) {
        outside = true;
      } else {
        const Point a = point_of(f->vertex(0)), b = point_of(f->vertex(1)), c = point_of(f->vertex(2));
        const double size = cross(b - a, c - a);
        if (size > largest) {
          largest = size;
          middle = a + ((b - a) + (c - a)) / 3;
        }
      }
      for (int i = 0; i < 3; ++i) {
        const Face n = f->neighbor(i);
        if (n->info() >= 0 || f->is_constrained(i)) continue;
        n->info() = piece;
        stack.push_back(n);
      }
    }
    free.push_back(!outside && index.contains(middle));
  }
  return free;
}

}  // namespace

Mesh::Mesh(const Region& region, const std::vector<Polyline>& barriers) {
  Outline lines = outline(region);
  if (lines.edges.size() >= 3) add_barriers(region, barriers, lines);
  points_ = lines.points;
  if (lines.edges.size() < 3) return;

  cgal_guarded("triangulation", [&] {
    Cdt cdt;
    std::vector<std::pair<Kernel::Point_2, Number>> input;
    input.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      input.emplace_back(Kernel::Point_2(points_[i].x(), points_[i].y()), static_cast<std::int32_t>(i));
    }
    cdt.insert(input.begin(), input.end());
    std::vector<Vertex> vertex(points_.size());
    for (const Vertex v : cdt.finite_vertex_handles()) vertex[static_cast<std::size_t>(v->info())] = v;
    for (const std::vector<Pair>* constraints : {&lines.edges, &lines.barriers}) {
      for (const auto& [a, b] : *constraints) {
        cdt.insert_constraint(vertex[static_cast<std::size_t>(a)], vertex[static_cast<std::size_t>(b)]);
      }
    }
    if (cdt.number_of_vertices() > points_.size()) {  // where constraints crossed
      for (const Vertex v : cdt.finite_vertex_handles()) {
        const auto known = static_cast<std::size_t>(v->info());
        if (v->info() >= 0 && known < vertex.size() && vertex[known] == v) continue;
        v->info() = static_cast<std::int32_t>(points_.size());
        points_.push_back(point_of(v));
        vertex.push_back(v);
      }
    }
    if (cdt.dimension() < 2) return;

    const std::vector<bool> free = classify(cdt, region);
    const auto is_free = [&](Face f) { return static_cast<bool>(free[static_cast<std::size_t>(f->info())]); };
    std::vector<Face> faces;
    for (const Face f : cdt.finite_face_handles()) {
      if (is_free(f)) faces.push_back(f);
    }
    for (const Face f : cdt.all_face_handles()) f->info() = is_free(f) ? 0 : kWall;
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i]->info() = static_cast<std::int32_t>(i);
    // A barrier that runs through points or across lines lies on several edges.
    const auto on_barrier = [&](std::int32_t a, std::int32_t b) {
      if (std::binary_search(lines.barriers.begin(), lines.barriers.end(), Pair(std::minmax(a, b)))) return true;
      const Point &p = points_[static_cast<std::size_t>(a)], &q = points_[static_cast<std::size_t>(b)];
      return std::any_of(lines.barriers.begin(), lines.barriers.end(), [&](const Pair& barrier) {
        const Point &s = points_[static_cast<std::size_t>(barrier.first)],
                    &e = points_[static_cast<std::size_t>(barrier.second)];
        const double near = 1e-12 * (s.norm() + e.norm());
        return distance_to_segment(p, s, e) <= near && distance_to_segment(q, s, e) <= near;
      });
    };
    triangles_.reserve(faces.size());
    for (const Face f : faces) {
      Triangle t{};
      for (int i = 0; i < 3; ++i) {
        t.vertex[static_cast<std::size_t>(i)] = f->vertex(i)->info();
        const bool barred = f->neighbor(i)->info() != kWall && f->is_constrained(i) &&
                            on_barrier(f->vertex(Cdt::cw(i))->info(), f->vertex(Cdt::ccw(i))->info());
        t.neighbour[static_cast<std::size_t>(i)] = barred ? kWall : static_cast<std::int32_t>(f->neighbor(i)->info());
      }
      triangles_.push_back(t);
    }
  });

  const auto corner = [&](const Triangle& t, std::size_t i) -> const Point& {
    return points_[static_cast<std::size_t>(t.vertex[i % 3])];
  };
  // Reflex: turn counter-clockwise through each fan from its first wall; more than 180 degrees of free space.
  reflex_.assign(points_.size(), false);
  for (const Triangle& start : triangles_) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (start.neighbour[(i + 2) % 3] != kWall) continue;  // the edge corner[i] -> corner[i + 1]
      const Point& v = corner(start, i);
      const Point& first = corner(start, i + 1);
      const Triangle* t = &start;
      std::size_t k = i;
      while (true) {
        const int turn = orientation(v, first, corner(*t, k + 2));
        const std::int32_t next = t->neighbour[(k + 1) % 3];
        if (turn < 0 || (turn == 0 && next != kWall)) {
          reflex_[static_cast<std::size_t>(start.vertex[i])] = true;
          break;
        }
        if (next == kWall) break;
        t = &triangles_[static_cast<std::size_t>(next)];
        k = 0;
        while (t->vertex[k] != start.vertex[i]) ++k;
      }
    }
  }

  Box box;
  double total = 0;
  for (const Triangle& t : triangles_) {
    for (std::size_t i = 0; i < 3; ++i) {
      box.add(corner(t, i));
      total += distance(corner(t, i), corner(t, i + 1)) / 2;
    }
  }
  grid_ = UniformGrid(box, triangles_.size(), total);
  grid_.fill(triangles_.size(), [&](std::size_t i, auto enter) {
    const Point p[3] = {corner(triangles_[i], 0), corner(triangles_[i], 1), corner(triangles_[i], 2)};
    grid_.visit(p, 3, 0, enter);
  });
}

void Mesh::locate_all(const Point& p, std::vector<std::int32_t>& found) const {
  found.clear();
  if (grid_.empty() || !Box{grid_.low(), grid_.high()}.contains(p)) return;
  const std::size_t c = grid_.index(grid_.column(p.x()), grid_.row(p.y()));
  for (const std::uint32_t i : grid_.items(c)) {
    const Triangle& t = triangles_[i];
    bool inside = true;
    for (std::size_t k = 0; k < 3 && inside; ++k) {
      inside = orientation(points_[static_cast<std::size_t>(t.vertex[k])],
                           points_[static_cast<std::size_t>(t.vertex[(k + 1) % 3])], p) >= 0;
    }
    if (inside) found.push_back(static_cast<std::int32_t>(i));
  }
}

Point Mesh::nearest_in(std::int32_t triangle, const Point& p) const {
  const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  Point best = p;
  double least = -1;
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& a = points_[static_cast<std::size_t>(t.vertex[k])];
    const Point& b = points_[static_cast<std::size_t>(t.vertex[(k + 1) % 3])];
    if (orientation(a, b, p) < 0) inside = false;
    const Point q = nearest_on_segment(p, a, b);
    const double d = distance(p, q);
    if (least < 0 || d < least) {
      least = d;
      best = q;
    }
  }
  return inside ? p : best;
}

std::int32_t Mesh::locate(const Point& p, double tolerance) const {
  if (grid_.empty() || !finite(p)) return kWall;
  std::vector<std::int32_t> found;
  locate_all(p, found);
  if (!found.empty()) return found.front();
  std::int32_t best = kWall;
  double least = tolerance;
  grid_.visit(&p, 1, tolerance, [&](std::size_t c) {
    for (const std::uint32_t i : grid_.items(c)) {
      const auto t = static_cast<std::int32_t>(i);
      const double d = distance(p, nearest_in(t, p));
      if (d < least || (d == least && (best == kWall || t < best))) {
        least = d;
        best = t;
      }
    }
    return false;
  });
  return best;
}

}  // namespace oxturn

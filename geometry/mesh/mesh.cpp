#include "geometry/mesh/mesh.hpp"

#include <algorithm>

#include "geometry/mesh/triangulation.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {

Mesh::Mesh(const Region& region, const std::vector<Polyline>& barriers) {
  TriangulationInput input = triangulation_input(region, barriers);
  if (input.edges.size() < 3) {
    points_ = std::move(input.points);
    return;
  }
  Triangulation triangulation = triangulate(input, region);
  points_ = std::move(triangulation.points);
  triangles_ = std::move(triangulation.triangles);
  find_reflex_points();
  grid_ = UniformGrid(triangles_.size(), [&](std::size_t i) {
    const auto t = static_cast<std::int32_t>(i);
    return std::array{vertex(t, 0), vertex(t, 1), vertex(t, 2)};
  });
}

void Mesh::find_reflex_points() {
  reflex_.assign(points_.size(), false);
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (triangles_[t].neighbour[(k + 2) % 3] == kWall && fan_is_reflex(static_cast<std::int32_t>(t), k))
        reflex_[static_cast<std::size_t>(triangles_[t].vertex[k])] = true;
}

/// Does the fan of triangles about vertex k of triangle `first` span more than 180 degrees? It begins with that
/// triangle's edge from vertex k to k + 1, which is a wall, and is followed counter-clockwise.
bool Mesh::fan_is_reflex(std::int32_t first, std::size_t k) const {
  const std::int32_t centre = triangle(first).vertex[k];
  const Point &v = point(centre), &start = vertex(first, k + 1);
  for (std::int32_t t = first; t != kWall;) {
    const std::size_t i = index_in(t, centre);
    const int turn = orientation(v, start, vertex(t, i + 2));
    const std::int32_t next = triangle(t).neighbour[(i + 1) % 3];
    if (turn < 0 || (turn == 0 && next != kWall)) return true;
    t = next;
  }
  return false;
}

void Mesh::locate_all(const Point& p, std::vector<std::int32_t>& found) const {
  found.clear();
  if (grid_.empty() || !Box{grid_.low(), grid_.high()}.contains(p)) return;
  for (const std::uint32_t i : grid_.items(grid_.index(grid_.column(p.x()), grid_.row(p.y())))) {
    const auto t = static_cast<std::int32_t>(i);
    bool inside = true;
    for (std::size_t k = 0; k < 3 && inside; ++k) inside = orientation(vertex(t, k), vertex(t, k + 1), p) >= 0;
    if (inside) found.push_back(t);
  }
}

std::optional<Point> Mesh::roomiest_point(const std::function<bool(const Point&)>& accepted) const {
  struct Incircle {
    double radius;
    std::int32_t triangle;
    bool operator<(const Incircle& o) const { return radius != o.radius ? radius < o.radius : triangle > o.triangle; }
  };
  const auto sides = [this](std::int32_t t) {  // opposite to the vertices
    const Point &a = vertex(t, 0), &b = vertex(t, 1), &c = vertex(t, 2);
    return Eigen::Vector3d(distance(b, c), distance(c, a), distance(a, b));
  };
  std::vector<Incircle> waiting;  // a heap, because few are looked at
  waiting.reserve(triangles_.size());
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(triangles_.size()); ++t) {
    const double twice_area = cross(vertex(t, 1) - vertex(t, 0), vertex(t, 2) - vertex(t, 0));
    waiting.push_back({twice_area / sides(t).sum(), t});
  }
  for (std::make_heap(waiting.begin(), waiting.end()); !waiting.empty(); waiting.pop_back()) {
    std::pop_heap(waiting.begin(), waiting.end());
    const std::int32_t t = waiting.back().triangle;
    const Eigen::Vector3d side = sides(t);
    const Point centre = (side[0] * vertex(t, 0) + side[1] * vertex(t, 1) + side[2] * vertex(t, 2)) / side.sum();
    if (!accepted || accepted(centre)) return centre;
  }
  return std::nullopt;
}

Point Mesh::nearest_in(std::int32_t t, const Point& p) const {
  Point best = p;
  double least = -1;
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = vertex(t, k), &b = vertex(t, k + 1);
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
  grid_.visit(std::array{p}, tolerance, [&](std::size_t c) {
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

/// The triangle that has p strictly inside, if a few steps across edges lead there; otherwise kWall.
std::int32_t Mesh::walk(const Point& p, std::int32_t from) const {
  constexpr int kMostSteps = 6;  // the grid takes as long
  std::int32_t t = from;
  for (int step = 0; step < kMostSteps && t != kWall; ++step) {
    std::size_t k = 0;
    int side = 1;
    for (; k < 3 && side > 0; ++k) side = orientation(vertex(t, k), vertex(t, k + 1), p);
    if (side > 0) return t;
    if (side == 0) return kWall;
    t = triangle(t).neighbour[(k + 1) % 3];  // across the edge from vertex k - 1 to vertex k
  }
  return kWall;
}

bool Mesh::move_inside(Point& p, double tolerance, std::vector<std::int32_t>& found) const {
  const std::int32_t near = found.empty() ? kWall : found.front();
  found.clear();
  if (grid_.empty() || !finite(p)) return false;
  if (near >= 0 && static_cast<std::size_t>(near) < triangles_.size())
    if (const std::int32_t t = walk(p, near); t != kWall) {
      found.push_back(t);
      return true;
    }
  locate_all(p, found);
  if (found.empty()) {
    const std::int32_t home = locate(p, tolerance);
    if (home == kWall) return false;
    p = nearest_in(home, p);
    locate_all(p, found);
    if (std::find(found.begin(), found.end(), home) == found.end()) found.push_back(home);
  }
  // A rounded point on an edge or beside a vertex may belong to a neighbour as well: add the triangles across all edges
  // that p is not strictly inside of.
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t n = triangle(found[i]).neighbour[k];
      if (n == kWall || std::find(found.begin(), found.end(), n) != found.end()) continue;
      if (orientation(vertex(found[i], k + 1), vertex(found[i], k + 2), p) <= 0) found.push_back(n);
    }
  std::sort(found.begin(), found.end());
  return true;
}

}  // namespace oxturn

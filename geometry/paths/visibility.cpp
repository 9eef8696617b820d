// Method      Triangular expansion: sight spreads from triangle to triangle of a mesh, and each edge that it passes
//             narrows the cone. Both sides of a cone are rays from the eye through vertices of the region, so that
//             every decision is the exact orientation of given points; only the far ends of the rays are rounded.
// Source      Bungiu, Hemmer, Hershberger, Huang and Kroeller, "Efficient computation of visibility polygons", 2014
// Complexity  O(cones). A triangle may be seen through several edges: in the worst case O(n h) cones for n vertices and
//             h holes, on real maps about the number of triangles seen.
// Decisions   1. An eye that is outside by at most the tolerance sees from the nearest point of the region.
//             2. An eye on a wall is a vertex of what it sees. Where rings touch in the eye, it sees in several
//                directions with walls between them, and the polygon returns to it in between.
//             3. What is seen along a single line, between two vertices that touch the line from both sides, has no
//                area and is left out.
#include "geometry/paths/visibility.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/sorting.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

/// An edge of a triangle, opposite vertex `apex`, seen from inside the triangle.
struct Window {
  std::int32_t triangle;
  std::size_t apex;
  Point right, left;  // the cone: rays from the eye through these
};

/// Does a come before b, counter-clockwise from +x about the eye? Neither is the eye.
bool angle_before(const Point& eye, const Point& a, const Point& b) {
  const auto lower = [&](const Point& p) { return p.y() < eye.y() || (p.y() == eye.y() && p.x() < eye.x()); };
  if (lower(a) != lower(b)) return lower(b);
  return orientation(eye, a, b) > 0;
}

/// Where the ray from the eye through `on` meets ab, which it does; rounded.
Point far_end(const Point& eye, const Point& on, const Point& a, const Point& b) {
  const Point ray = on - eye;
  const double at = cross(ray, a - eye), bt = cross(ray, b - eye);
  return at == bt ? a : lerp(a, b, std::clamp(at / (at - bt), 0.0, 1.0));
}

class Expansion {
 public:
  /// `near`, if not null, gets the vertices of the triangles that are entered.
  Expansion(const Mesh& mesh, const Point& eye, Ring& seen, std::vector<std::int32_t>* near)
      : mesh_(mesh), eye_(eye), seen_(seen), near_(near) {}

  /// Appends what the eye sees through the window.
  void run(const Window& first) {
    stack_.assign(1, first);
    while (!stack_.empty()) {
      const Window w = stack_.back();
      stack_.pop_back();
      pass(w);
    }
  }

 private:
  void pass(const Window& w) {
    const Point &a = mesh_.vertex(w.triangle, w.apex + 1), &b = mesh_.vertex(w.triangle, w.apex + 2);  // right, left
    const std::int32_t next = mesh_.triangle(w.triangle).neighbour[w.apex];
    if (next == Mesh::kWall) {
      add(orientation(eye_, w.right, a) == 0 ? a : far_end(eye_, w.right, a, b));
      add(orientation(eye_, w.left, b) == 0 ? b : far_end(eye_, w.left, a, b));
      return;
    }
    std::size_t apex = 0;  // two triangles may share two edges
    while (mesh_.triangle(next).neighbour[apex] != w.triangle || mesh_.vertex(next, apex + 1) != b) ++apex;
    const Point& v = mesh_.vertex(next, apex);  // the triangle is v, b, a
    if (near_) near_->push_back(mesh_.triangle(next).vertex[apex]);
    const Window on_right{next, (apex + 1) % 3, w.right, w.left}, on_left{next, (apex + 2) % 3, w.right, w.left};
    if (orientation(eye_, w.right, v) <= 0) {
      stack_.push_back(on_left);
    } else if (orientation(eye_, w.left, v) >= 0) {
      stack_.push_back(on_right);
    } else {  // the right one is passed first, so that the polygon grows counter-clockwise
      stack_.push_back({on_left.triangle, on_left.apex, v, w.left});
      stack_.push_back({on_right.triangle, on_right.apex, w.right, v});
    }
  }

  void add(const Point& p) {
    if (seen_.empty() || seen_.back() != p) seen_.push_back(p);
  }

  const Mesh& mesh_;
  const Point eye_;
  Ring& seen_;
  std::vector<std::int32_t>* near_;
  std::vector<Window> stack_;
};

/// The edges opposite the eye of the triangles that contain it, counter-clockwise. If there is a gap between two of
/// them (a wall at the eye), they begin after it.
std::vector<Window> windows_around(const Mesh& mesh, const Point& eye, const std::vector<std::int32_t>& home) {
  std::vector<Window> around;
  for (const std::int32_t t : home)
    for (std::size_t k = 0; k < 3; ++k) {
      const Window w{t, k, mesh.vertex(t, k + 1), mesh.vertex(t, k + 2)};
      if (orientation(w.right, w.left, eye) > 0) around.push_back(w);
    }
  std::ranges::sort(around, [&](const Window& a, const Window& b) { return angle_before(eye, a.right, b.right); });
  for (std::size_t i = 0; i < around.size(); ++i)
    if (around[(i + around.size() - 1) % around.size()].left != around[i].right) {
      std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(i), around.end());
      break;
    }
  return around;
}

/// The part of the window's cone between two rays; nullopt if there is none. The rays, too, are less than pi apart.
std::optional<Window> clipped(Window w, const Point& eye, const Point& right, const Point& left) {
  // Is p in the cone, `from` included and `to` not?
  const auto holds = [&](const Point& from, const Point& to, const Point& p) {
    return orientation(eye, from, p) >= 0 && orientation(eye, p, to) > 0;
  };
  const bool begins = holds(w.right, w.left, right);
  if (!begins && !holds(right, left, w.right)) return std::nullopt;
  const bool ends = orientation(eye, w.right, left) > 0 && orientation(eye, left, w.left) >= 0;
  if (begins) w.right = right;
  if (ends) w.left = left;
  return w;
}

/// What is seen through windows, counter-clockwise, is appended to `seen`: where one does not begin where the one
/// before ended, over the eye. `last`: where what comes before the first one ended.
void look_through(const std::vector<Window>& windows, const Mesh& mesh, const Point& eye, Point last, Ring& seen,
                  std::vector<std::int32_t>* near) {
  Expansion expansion(mesh, eye, seen, near);
  for (const Window& w : windows) {
    if (last != w.right) seen.push_back(eye);
    expansion.run(w);
    last = w.left;
  }
}

/// Adds the vertices of the triangles at the eye.
void add_home(const Mesh& mesh, const std::vector<std::int32_t>& home, std::vector<std::int32_t>& near) {
  for (const std::int32_t t : home)
    near.insert(near.end(), mesh.triangle(t).vertex.begin(), mesh.triangle(t).vertex.end());
  sort_unique(near);
}

}  // namespace

/// The triangles that contain the eye, which is moved into the mesh if need be.
std::vector<std::int32_t> Visibility::home_of(Point& eye, double tolerance) const {
  std::vector<std::int32_t> home;
  if (finite(eye)) mesh_.locate_all(eye, home);
  if (!home.empty()) return home;
  const std::int32_t nearest = mesh_.locate(eye, tolerance);
  if (nearest == Mesh::kWall)
    throw_invalid("the eye ({}, {}) is outside the region, expected a point in it", eye.x(), eye.y());
  eye = mesh_.nearest_in(nearest, eye);
  mesh_.locate_all(eye, home);
  if (home.empty()) home.push_back(nearest);  // rounded to just outside: it sees the part of the triangle before it
  return home;
}

Ring Visibility::from(const Point& given, double tolerance, std::vector<std::int32_t>* near) const {
  Point eye = given;
  const std::vector<std::int32_t> home = home_of(eye, tolerance);
  const std::vector<Window> around = windows_around(mesh_, eye, home);
  Ring seen;
  if (near) near->clear();
  if (!around.empty()) look_through(around, mesh_, eye, around.back().left, seen, near);
  while (seen.size() > 1 && seen.back() == seen.front()) seen.pop_back();
  if (near) add_home(mesh_, home, *near);
  return seen;
}

Ring Visibility::from(const Point& given, const ViewSector& sector, double tolerance,
                      std::vector<std::int32_t>* near) const {
  Point eye = given;
  const std::vector<std::int32_t> home = home_of(eye, tolerance);
  const Point right = eye + sector.right, left = eye + sector.left;
  std::vector<Window> within;
  for (const Window& w : windows_around(mesh_, eye, home))
    if (const auto part = clipped(w, eye, right, left)) within.push_back(*part);
  std::ranges::sort(within, [&](const Window& a, const Window& b) { return orientation(eye, a.right, b.right) > 0; });
  Ring seen{eye};
  if (near) near->clear();
  if (!within.empty()) look_through(within, mesh_, eye, within.front().right, seen, near);
  if (near) add_home(mesh_, home, *near);
  return seen;
}

}  // namespace oxturn

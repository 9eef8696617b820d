// What a point sees: from triangle to triangle of a mesh, each seen edge narrows the cone.
//
// Source      Bungiu, Hemmer, Hershberger, Huang, Kroeller, "Efficient computation of visibility polygons", 2014:
//             triangular expansion
// Method      Both sides of a cone are rays from the eye through corners of the region, so that every decision is the
//             exact orientation of given points; only the far ends of the rays are rounded.
// Complexity  O(cones); a triangle may be seen through several edges, in the worst case O(n h) cones for n corners
//             and h holes, on real maps about the number of triangles seen
// Decisions   1. An eye that is outside by no more than the tolerance sees from the nearest place of the region.
//             2. An eye on a wall is a corner of what it sees. Where rings touch in the eye, so that it sees in several
//                directions with walls between them, the ring comes back to it.
//             3. What is seen along one line only, between two corners that this line touches on both sides, has no
//                area and is left out.
#include "geometry/paths/visibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

/// The edge opposite `apex` of `triangle`, as seen from inside of it, counter-clockwise about the eye.
struct Window {
  std::int32_t triangle;
  std::size_t apex;
  Point right, left;  // the cone: rays from the eye through these
};

/// a comes before b, counter-clockwise from east round `eye`; neither is the eye.
bool angle_before(const Point& eye, const Point& a, const Point& b) {
  const auto lower = [&](const Point& p) { return p.y() < eye.y() || (p.y() == eye.y() && p.x() < eye.x()); };
  if (lower(a) != lower(b)) return lower(b);
  return orientation(eye, a, b) > 0;
}

/// Where the ray from the eye through `on` meets the line ab, which it does.
Point far_end(const Point& eye, const Point& on, const Point& a, const Point& b) {
  const Point ray = on - eye;
  const double at = cross(ray, a - eye), bt = cross(ray, b - eye);
  return at == bt ? a : lerp(a, b, std::clamp(at / (at - bt), 0.0, 1.0));
}

class Expansion {
 public:
  Expansion(const Mesh& mesh, const Point& eye, Ring& ring) : mesh_(mesh), eye_(eye), ring_(ring) {}

  void run(const Window& first) {
    stack_.assign(1, first);
    while (!stack_.empty()) {
      const Window w = stack_.back();
      stack_.pop_back();
      pass(w);
    }
  }

 private:
  const Mesh::Triangle& triangle(std::int32_t t) const { return mesh_.triangles()[static_cast<std::size_t>(t)]; }
  const Point& corner(std::int32_t t, std::size_t k) const {
    return mesh_.points()[static_cast<std::size_t>(triangle(t).vertex[k % 3])];
  }

  void pass(const Window& w) {
    const Point &a = corner(w.triangle, w.apex + 1), &b = corner(w.triangle, w.apex + 2);  // right, left
    const std::int32_t next = triangle(w.triangle).neighbour[w.apex];
    if (next == Mesh::kWall) {
      add(orientation(eye_, w.right, a) == 0 ? a : far_end(eye_, w.right, a, b));
      add(orientation(eye_, w.left, b) == 0 ? b : far_end(eye_, w.left, a, b));
      return;
    }
    std::size_t apex = 0;
    while (triangle(next).neighbour[apex] != w.triangle || corner(next, apex + 1) != b) ++apex;
    const Point& v = corner(next, apex);  // next is (v, b, a): opposite a lies v b, opposite b lies a v
    const Window on_right{next, (apex + 1) % 3, w.right, w.left}, on_left{next, (apex + 2) % 3, w.right, w.left};
    if (orientation(eye_, w.right, v) <= 0) {
      stack_.push_back(on_left);
    } else if (orientation(eye_, w.left, v) >= 0) {
      stack_.push_back(on_right);
    } else {  // the right one is next on the stack: the ring grows counter-clockwise
      stack_.push_back({on_left.triangle, on_left.apex, v, w.left});
      stack_.push_back({on_right.triangle, on_right.apex, w.right, v});
    }
  }

  void add(const Point& p) {
    if (ring_.empty() || ring_.back() != p) ring_.push_back(p);
  }

  const Mesh& mesh_;
  const Point eye_;
  Ring& ring_;
  std::vector<Window> stack_;
};

}  // namespace

struct Visibility::Impl {
  explicit Impl(const Region& region) : mesh(region) {}
  Mesh mesh;
};

Visibility::Visibility(const Region& region) : impl_(std::make_unique<const Impl>(region)) {}
Visibility::~Visibility() = default;
Visibility::Visibility(Visibility&&) noexcept = default;

Ring Visibility::from(const Point& eye_given, double tolerance) const {
  const Mesh& mesh = impl_->mesh;
  Point eye = eye_given;
  std::vector<std::int32_t> home;
  if (finite(eye)) mesh.locate_all(eye, home);
  if (home.empty()) {
    const std::int32_t nearest = mesh.locate(eye, tolerance);
    if (nearest == Mesh::kWall)
      throw std::invalid_argument(
          fmt::format("the eye ({}, {}) is outside the region, expected a place in it", eye.x(), eye.y()));
    eye = mesh.nearest_in(nearest, eye);
    mesh.locate_all(eye, home);
    if (home.empty()) home.push_back(nearest);  // rounded to just outside: what of the triangle is in front is seen
  }

  const auto corner = [&](const Window& w, std::size_t k) -> const Point& {
    return mesh.points()[static_cast<std::size_t>(
        mesh.triangles()[static_cast<std::size_t>(w.triangle)].vertex[(w.apex + k) % 3])];
  };
  std::vector<Window> around;  // edges of the triangles at the eye that do not hold it
  for (const std::int32_t t : home)
    for (std::size_t k = 0; k < 3; ++k) {
      Window w{t, k, {}, {}};
      w.right = corner(w, 1);
      w.left = corner(w, 2);
      if (orientation(w.right, w.left, eye) > 0) around.push_back(w);
    }
  if (around.empty()) return {};
  std::sort(around.begin(), around.end(),
            [&](const Window& a, const Window& b) { return angle_before(eye, a.right, b.right); });
  // Begin behind a gap (a wall at the eye), if there is one.
  for (std::size_t i = 0; i < around.size(); ++i)
    if (around[(i + around.size() - 1) % around.size()].left != around[i].right) {
      std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(i), around.end());
      break;
    }

  Ring ring;
  Expansion expansion(mesh, eye, ring);
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (around[(i + around.size() - 1) % around.size()].left != around[i].right) ring.push_back(eye);
    expansion.run(around[i]);
  }
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  return ring;
}

}  // namespace oxturn

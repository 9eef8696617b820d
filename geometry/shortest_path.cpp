#include "geometry/shortest_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Id = std::int32_t;  // a point of the mesh; mesh.points().size() stands for the path's start
constexpr Id kNone = -1;

/// One side of the cone of sight from a root: the ray from the root through `id`, or, if `behind`, the ray that
/// leaves the root straight away from `id`. So every question about the cone is one exact orientation of three
/// given points; no interval end is ever rounded.
struct Ray {
  Id id = kNone;
  bool behind = false;
};

/// The cone from `root` between `left` and `right`, about to enter `triangle` through the edge opposite its corner
/// `apex`. Seen from outside, corner apex + 1 is the edge's left end, apex + 2 its right end. If the root is an end
/// of the edge, the whole triangle is in sight. A node with triangle kWall is a finished path.
struct Node {
  double g = 0;  // length up to the root
  Id root = kNone;
  Ray left, right;
  std::int32_t triangle = Mesh::kWall;
  std::int32_t apex = 0;
  std::int32_t parent = -1;
};

struct Open {
  double f;
  std::int32_t node;
  bool operator<(const Open& o) const { return f != o.f ? f > o.f : node < o.node; }  // for a heap with least f on top
};

/// A turn about a corner that has been followed: coming from `from`, in `triangle`.
struct Turn {
  Id from;
  std::int32_t triangle;
  double g;
  std::int32_t next;
};

/// Reused between queries of a thread, so that a query pays for what it touches only.
struct Scratch {
  std::vector<Node> nodes;
  std::vector<Open> open;
  std::vector<Turn> turns;
  struct Root {
    std::uint32_t stamp = 0;
    double g = 0;
    std::int32_t turns = -1;
  };
  std::vector<Root> roots;               // by point
  std::vector<std::uint32_t> is_target;  // by triangle: the stamp of the query it is a target of
  std::vector<std::int32_t> from, to;
  std::uint32_t stamp = 0;

  void begin(std::size_t points, std::size_t triangles) {
    nodes.clear();
    open.clear();
    turns.clear();
    if (roots.size() < points) roots.resize(points);
    if (is_target.size() < triangles) is_target.resize(triangles, 0);
    if (++stamp == 0) {
      for (Root& r : roots) r.stamp = 0;
      std::fill(is_target.begin(), is_target.end(), 0);
      stamp = 1;
    }
  }
};

/// Numbers the parts of the mesh that hang together by edges.
std::vector<std::int32_t> components(const Mesh& mesh) {
  const auto& triangles = mesh.triangles();
  std::vector<std::int32_t> part(triangles.size(), -1);
  std::vector<std::int32_t> stack;
  std::int32_t count = 0;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (part[seed] >= 0) continue;
    part[seed] = count;
    stack.push_back(static_cast<std::int32_t>(seed));
    while (!stack.empty()) {
      const auto t = static_cast<std::size_t>(stack.back());
      stack.pop_back();
      for (const std::int32_t n : triangles[t].neighbour) {
        if (n == Mesh::kWall || part[static_cast<std::size_t>(n)] >= 0) continue;
        part[static_cast<std::size_t>(n)] = count;
        stack.push_back(n);
      }
    }
    ++count;
  }
  return part;
}

class Search {
 public:
  Search(const Mesh& mesh, const Point& start, const Point& goal, double longest, Scratch& scratch)
      : mesh_(mesh), start_(start), goal_(goal), longest_(longest), s_(scratch) {}

  /// The finished node, or -1. Needs s_.from and s_.to: the triangles that hold start and goal.
  std::int32_t run() {
    const Id start_id = static_cast<Id>(mesh_.points().size());
    for (const std::int32_t t : s_.to) s_.is_target[static_cast<std::size_t>(t)] = s_.stamp;
    for (const std::int32_t t : s_.from) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Id corner = triangle(t).corner[k];
        if (at(corner) == start_) root(corner).g = 0;
        const std::int32_t n = triangle(t).neighbour[k];
        if (n == Mesh::kWall || std::find(s_.from.begin(), s_.from.end(), n) != s_.from.end()) continue;
        const std::size_t a = (k + 2) % 3, b = (k + 1) % 3;  // seen from inside t: a left, b right
        if (orientation(at(triangle(t).corner[b]), at(triangle(t).corner[a]), start_) <= 0) continue;
        push(t, k, {0, start_id, {triangle(t).corner[a]}, {triangle(t).corner[b]}, 0, 0, -1});
      }
    }
    while (!s_.open.empty()) {
      std::pop_heap(s_.open.begin(), s_.open.end());
      const std::int32_t node = s_.open.back().node;
      s_.open.pop_back();
      const Node& n = s_.nodes[static_cast<std::size_t>(node)];
      if (n.triangle == Mesh::kWall) return node;
      if (n.root != start_id && worse(n.g, n.root)) continue;
      expand(node);
    }
    return -1;
  }

  const Point& at(Id id) const {
    return static_cast<std::size_t>(id) == mesh_.points().size() ? start_
                                                                 : mesh_.points()[static_cast<std::size_t>(id)];
  }

 private:
  const Mesh::Triangle& triangle(std::int32_t t) const { return mesh_.triangles()[static_cast<std::size_t>(t)]; }
  Scratch::Root& root(Id id) {
    Scratch::Root& r = s_.roots[static_cast<std::size_t>(id)];
    if (r.stamp != s_.stamp) r = {s_.stamp, std::numeric_limits<double>::infinity(), -1};
    return r;
  }
  bool worse(double g, Id id) { return g > root(id).g * (1 + 1e-12); }
  /// On which side of the ray from `origin` x lies: +1 left.
  int side(Id origin, const Ray& ray, const Point& x) const {
    return ray.behind ? orientation(at(ray.id), at(origin), x) : orientation(at(origin), at(ray.id), x);
  }

  void put(double f, const Node& node) {
    if (f > longest_ * (1 + 1e-12)) return;
    s_.open.push_back({f, static_cast<std::int32_t>(s_.nodes.size())});
    s_.nodes.push_back(node);
    std::push_heap(s_.open.begin(), s_.open.end());
  }

  /// Puts `node` on the heap, as it leaves triangle t by the edge opposite corner k.
  void push(std::int32_t t, std::size_t k, Node node) {
    const std::int32_t n = triangle(t).neighbour[k];
    if (n == Mesh::kWall) return;
    node.triangle = n;
    node.apex = 0;
    while (triangle(n).neighbour[static_cast<std::size_t>(node.apex)] != t) ++node.apex;
    // The estimate is lowered a little so that rounding in it never lets a longer path finish first.
    put(node.g + estimate(node) * (1 - 1e-9), node);
  }

  /// Lower bound of the way from the root through the interval to the goal.
  double estimate(const Node& node) const {
    const Mesh::Triangle& t = triangle(node.triangle);
    const auto k = static_cast<std::size_t>(node.apex);
    const Id left_id = t.corner[(k + 1) % 3], right_id = t.corner[(k + 2) % 3];
    const Point& r = at(node.root);
    if (node.root == left_id || node.root == right_id) return distance(r, goal_);
    const Point &vl = at(left_id), &vr = at(right_id);
    const Point edge = vr - vl;
    Point goal = goal_;
    const double beyond = cross(edge, goal - vl);
    if (beyond < 0) goal = vl + (goal - vl) - perpendicular(edge) * (2 * beyond / edge.squaredNorm());
    const Point left = node.left.id == left_id && !node.left.behind ? vl : hit(r, node.left, vl, vr);
    const Point right = node.right.id == right_id && !node.right.behind ? vr : hit(r, node.right, vl, vr);
    const Point to_goal = goal - r;
    if (cross(left - r, to_goal) > 0) return distance(r, left) + distance(left, goal);
    if (cross(right - r, to_goal) < 0) return distance(r, right) + distance(right, goal);
    return to_goal.norm();
  }
  Point hit(const Point& r, const Ray& ray, const Point& vl, const Point& vr) const {
    const Point d = ray.behind ? Point(r - at(ray.id)) : Point(at(ray.id) - r);
    const double a = std::max(0.0, cross(d, vl - r)), b = std::max(0.0, -cross(d, vr - r));
    return a + b > 0 ? lerp(vl, vr, a / (a + b)) : vl;
  }

  void finish(double g, Id root, std::int32_t parent) {
    Node end;
    end.g = g;
    end.root = root;
    end.parent = parent;
    put(g + distance(at(root), goal_), end);
  }

  /// May the path turn about corner v, met from node `n`? Every (from, v, triangle) is followed once, or again if it
  /// is reached by a shorter way: else ties, as between the blocks of a lattice, would multiply.
  bool turn(const Node& n, Id v, double& g) {
    if (!mesh_.is_reflex(v)) return false;
    g = n.g + distance(at(n.root), at(v));
    Scratch::Root& r = root(v);
    if (worse(g, v)) return false;
    r.g = std::min(r.g, g);
    for (std::int32_t i = r.turns; i >= 0; i = s_.turns[static_cast<std::size_t>(i)].next) {
      Turn& done = s_.turns[static_cast<std::size_t>(i)];
      if (done.from != n.root || done.triangle != n.triangle) continue;
      if (g >= done.g * (1 - 1e-12)) return false;
      done.g = g;
      return true;
    }
    s_.turns.push_back({n.root, n.triangle, g, r.turns});
    r.turns = static_cast<std::int32_t>(s_.turns.size()) - 1;
    return true;
  }

  void expand(std::int32_t index) {
    const Node n = s_.nodes[static_cast<std::size_t>(index)];
    const Mesh::Triangle& t = triangle(n.triangle);
    const auto k = static_cast<std::size_t>(n.apex);
    const std::size_t to_left = (k + 2) % 3, to_right = (k + 1) % 3;  // the edges left-apex and apex-right
    const Id apex = t.corner[k], left = t.corner[(k + 1) % 3], right = t.corner[(k + 2) % 3];
    const bool target = s_.is_target[static_cast<std::size_t>(n.triangle)] == s_.stamp;
    const bool at_left = n.left.id == left && !n.left.behind, at_right = n.right.id == right && !n.right.behind;
    const auto leave = [&](std::size_t edge, double g, Id root, Ray l, Ray r) {
      push(n.triangle, edge, {g, root, l, r, 0, 0, index});
    };

    if (n.root == left || n.root == right) {
      if (target) return finish(n.g, n.root, index);
      leave(to_left, n.g, n.root, {left}, {apex});
      leave(to_right, n.g, n.root, {apex}, {right});
      return;
    }

    double g = 0;
    if (target) {
      const bool beyond_left = side(n.root, n.left, goal_) > 0, beyond_right = side(n.root, n.right, goal_) < 0;
      if (!beyond_left && !beyond_right) return finish(n.g, n.root, index);
      if (beyond_left && at_left && turn(n, left, g)) finish(g, left, index);
      if (beyond_right && at_right && turn(n, right, g)) finish(g, right, index);
      return;
    }
    const int sl = side(n.root, n.left, at(apex)), sr = side(n.root, n.right, at(apex));
    if (sl >= 0) {  // the cone leaves by the right edge only; turning left opens the rest
      leave(to_right, n.g, n.root, sl == 0 ? Ray{apex} : n.left, n.right);
      if (at_left && turn(n, left, g)) {
        leave(to_left, g, left, {left}, {apex});
        if (sl > 0) leave(to_right, g, left, {apex}, {n.root, true});
      }
    } else if (sr <= 0) {
      leave(to_left, n.g, n.root, n.left, sr == 0 ? Ray{apex} : n.right);
      if (at_right && turn(n, right, g)) {
        leave(to_right, g, right, {apex}, {right});
        if (sr < 0) leave(to_left, g, right, {n.root, true}, {apex});
      }
    } else {
      leave(to_left, n.g, n.root, n.left, {apex});
      leave(to_right, n.g, n.root, {apex}, n.right);
    }
  }

  const Mesh& mesh_;
  const Point start_, goal_;
  const double longest_;
  Scratch& s_;
};

}  // namespace

struct ShortestPaths::Impl {
  Impl(const Region& region, double within) : mesh(region), part(components(mesh)), tolerance(within) {}

  /// Moves p into the mesh and lists the triangles that hold it, ascending. A rounded place on an edge or beside a
  /// corner may belong to a neighbour as well: whatever lies across an edge that p is not strictly inside of joins.
  bool place(Point& p, std::vector<std::int32_t>& found) const {
    found.clear();
    const std::int32_t home = mesh.locate(p, tolerance);
    if (home == Mesh::kWall) return false;
    p = mesh.nearest_in(home, p);
    mesh.locate_all(p, found);
    if (std::find(found.begin(), found.end(), home) == found.end()) found.push_back(home);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Mesh::Triangle& t = mesh.triangles()[static_cast<std::size_t>(found[i])];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t n = t.neighbour[k];
        if (n == Mesh::kWall || std::find(found.begin(), found.end(), n) != found.end()) continue;
        const Point& a = mesh.points()[static_cast<std::size_t>(t.corner[(k + 1) % 3])];
        const Point& b = mesh.points()[static_cast<std::size_t>(t.corner[(k + 2) % 3])];
        if (orientation(a, b, p) <= 0) found.push_back(n);
      }
    }
    std::sort(found.begin(), found.end());
    return true;
  }

  Mesh mesh;
  std::vector<std::int32_t> part;
  double tolerance;
};

ShortestPaths::ShortestPaths(const Region& region, double tolerance) {
  if (!(tolerance >= 0)) throw std::invalid_argument("tolerance of shortest paths must be 0 or more metres");
  impl_ = std::make_unique<const Impl>(region, tolerance);
}
ShortestPaths::~ShortestPaths() = default;
ShortestPaths::ShortestPaths(ShortestPaths&&) noexcept = default;
const Mesh& ShortestPaths::mesh() const { return impl_->mesh; }

std::optional<Polyline> ShortestPaths::path(const Point& a, const Point& b, double longest) const {
  if (!finite(a) || !finite(b) || !(distance(a, b) <= longest)) return std::nullopt;
  thread_local Scratch scratch;
  Point start = a, goal = b;
  if (!impl_->place(start, scratch.from) || !impl_->place(goal, scratch.to)) return std::nullopt;
  // Only parts of the region that hold both ends.
  const auto keep_common = [&](std::vector<std::int32_t>& mine, const std::vector<std::int32_t>& other) {
    const auto part = [&](std::int32_t t) { return impl_->part[static_cast<std::size_t>(t)]; };
    std::erase_if(mine, [&](std::int32_t t) {
      return std::none_of(other.begin(), other.end(), [&](std::int32_t o) { return part(o) == part(t); });
    });
  };
  keep_common(scratch.from, scratch.to);
  keep_common(scratch.to, scratch.from);
  if (scratch.from.empty()) return std::nullopt;
  for (const std::int32_t t : scratch.from) {
    if (std::binary_search(scratch.to.begin(), scratch.to.end(), t)) return Polyline{a, b};
  }

  scratch.begin(impl_->mesh.points().size(), impl_->mesh.triangles().size());
  Search search(impl_->mesh, start, goal, longest, scratch);
  std::int32_t node = search.run();
  if (node < 0) return std::nullopt;
  Polyline path{b};
  const Id start_id = static_cast<Id>(impl_->mesh.points().size());
  for (Id root = kNone; node >= 0; node = scratch.nodes[static_cast<std::size_t>(node)].parent) {
    const Id next = scratch.nodes[static_cast<std::size_t>(node)].root;
    if (next != root && next != start_id && search.at(next) != path.back()) path.push_back(search.at(next));
    root = next;
  }
  if (path.size() > 1 && path.back() == a) path.pop_back();
  path.push_back(a);
  std::reverse(path.begin(), path.end());
  if (length(path) > longest) return std::nullopt;
  return path;
}

}  // namespace oxturn

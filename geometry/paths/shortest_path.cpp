#include "geometry/paths/shortest_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/paths/dual_tree.hpp"
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
  std::int32_t chain = 0;  // in a search for all classes: the root's chain of bends
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

/// What a search for all classes keeps in place of the least distance of each corner: chains of bends, interned
/// without corners that lie in line, so that equal curves have equal chains however they came about.
struct Chains {
  struct Chain {
    std::int32_t parent = -1;
    Id point = kNone;
    enum { unknown, admitted, refused } state = unknown;
    bool yielded = false;
  };
  std::vector<Chain> all{{}};
  std::map<std::pair<std::int32_t, Id>, std::int32_t> ids;   // (parent, point) -> chain
  std::set<std::pair<std::int32_t, std::int32_t>> turns[2];  // (chain, triangle) followed to the left, to the right
  const Chain& operator[](std::int32_t chain) const { return all[static_cast<std::size_t>(chain)]; }
  Chain& operator[](std::int32_t chain) { return all[static_cast<std::size_t>(chain)]; }
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
    for (const std::int32_t t : s_.to) s_.is_target[static_cast<std::size_t>(t)] = s_.stamp;
    leave_start();
    while (!s_.open.empty()) {
      const std::int32_t node = pop();
      const Node& n = s_.nodes[static_cast<std::size_t>(node)];
      if (n.triangle == Mesh::kWall) return node;
      if (n.root != start_id() && worse(n.g, n.root)) continue;
      expand(node);
    }
    return -1;
  }

  /// All classes but, if it is done already, the straight way; see ShortestPaths::for_each_taut_path. Does not use what
  /// `s_` keeps by point and by triangle.
  bool run_all(bool straight, std::size_t budget, const std::function<bool(const Polyline&)>& visit,
               const std::function<bool(const Polyline&)>& admits) {
    Chains chains;
    chains_ = &chains;
    const auto line = [&](std::int32_t chain) {
      Polyline points;
      for (; chain > 0; chain = chains[chain].parent) points.push_back(at(chains[chain].point));
      points.push_back(start_);
      std::reverse(points.begin(), points.end());
      return points;
    };
    if (straight) chains[extended(0, start_id() + 1)].yielded = true;
    leave_start();
    while (!s_.open.empty()) {
      const std::int32_t node = pop();
      const Node n = s_.nodes[static_cast<std::size_t>(node)];
      if (n.triangle == Mesh::kWall) {
        if (std::exchange(chains[n.chain].yielded, true)) continue;
        if (!visit(line(n.chain))) return true;
        continue;
      }
      if (n.chain > 0 && admits) {
        Chains::Chain& chain = chains[n.chain];
        if (chain.state == Chains::Chain::unknown)
          chain.state = admits(line(n.chain)) ? Chains::Chain::admitted : Chains::Chain::refused;
        if (chain.state == Chains::Chain::refused) continue;
      }
      if (budget-- == 0) return false;
      expand(node);
    }
    return true;
  }

  const Point& at(Id id) const {
    return id < start_id() ? mesh_.points()[static_cast<std::size_t>(id)] : id == start_id() ? start_ : goal_;
  }
  Id start_id() const { return static_cast<Id>(mesh_.points().size()); }

 private:
  std::int32_t pop() {
    std::pop_heap(s_.open.begin(), s_.open.end());
    const std::int32_t node = s_.open.back().node;
    s_.open.pop_back();
    return node;
  }

  void leave_start() {
    for (const std::int32_t t : s_.from) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Id corner = triangle(t).vertex[k];
        if (chains_ == nullptr && at(corner) == start_) root(corner).g = 0;
        const std::int32_t n = triangle(t).neighbour[k];
        if (n == Mesh::kWall || std::find(s_.from.begin(), s_.from.end(), n) != s_.from.end()) continue;
        const std::size_t a = (k + 2) % 3, b = (k + 1) % 3;  // seen from inside t: a left, b right
        if (orientation(at(triangle(t).vertex[b]), at(triangle(t).vertex[a]), start_) <= 0) continue;
        push(t, k, {0, start_id(), {triangle(t).vertex[a]}, {triangle(t).vertex[b]}, 0, 0, -1});
      }
    }
  }

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
    const Id left_id = t.vertex[(k + 1) % 3], right_id = t.vertex[(k + 2) % 3];
    const Point& r = at(node.root);
    if (node.root == left_id || node.root == right_id) return distance(r, goal_);
    const Point &vl = at(left_id), &vr = at(right_id);
    const Point edge = vr - vl;
    // All but in line with the edge: rounding would choose the place on it, so only the straight distance is certain.
    const double height = cross(edge, vl - r);
    if (height * height < 1e-12 * edge.squaredNorm() * std::max(edge.squaredNorm(), (vl - r).squaredNorm()))
      return distance(r, goal_);
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

  void finish(double g, Id root, std::int32_t parent, std::int32_t chain) {
    Node end;
    end.g = g;
    end.root = root;
    end.parent = parent;
    if (chains_ != nullptr) end.chain = extended(chain, start_id() + 1);
    put(g + distance(at(root), goal_), end);
  }

  /// The chain of bends that goes on to point v; corners that lie in line are none.
  std::int32_t extended(std::int32_t chain, Id v) {
    for (; chain > 0; chain = (*chains_)[chain].parent) {
      const Chains::Chain& last = (*chains_)[chain];
      const Point& before = last.parent > 0 ? at((*chains_)[last.parent].point) : start_;
      const Point &here = at(last.point), &next = at(v);
      if (orientation(before, here, next) != 0 || (here - before).dot(next - here) < 0) break;
    }
    const auto [found, fresh] = chains_->ids.try_emplace({chain, v}, static_cast<std::int32_t>(chains_->all.size()));
    if (fresh) chains_->all.push_back({chain, v});
    return found->second;
  }

  /// May the path turn about corner v (to the left or to the right), met from node `n`? Every (from, v, triangle) is
  /// followed once, or again if it is reached by a shorter way: else ties, as between the blocks of a lattice, would
  /// multiply. Where all classes are wanted, every (chain of bends, triangle) is followed once.
  bool turn(const Node& n, Id v, bool to_left, double& g, std::int32_t& chain) {
    if (!mesh_.is_reflex(v)) return false;
    g = n.g + distance(at(n.root), at(v));
    if (chains_ != nullptr) {
      chain = extended(n.chain, v);
      return chains_->turns[to_left ? 0 : 1].insert({chain, n.triangle}).second;
    }
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
    const Id apex = t.vertex[k], left = t.vertex[(k + 1) % 3], right = t.vertex[(k + 2) % 3];
    const bool all = chains_ != nullptr;
    const bool target = all ? std::find(s_.to.begin(), s_.to.end(), n.triangle) != s_.to.end()
                            : s_.is_target[static_cast<std::size_t>(n.triangle)] == s_.stamp;
    const bool at_left = n.left.id == left && !n.left.behind, at_right = n.right.id == right && !n.right.behind;
    double g = n.g;
    std::int32_t chain = n.chain;
    const auto leave = [&](std::size_t edge, Id root, Ray l, Ray r) {
      push(n.triangle, edge, {root == n.root ? n.g : g, root, l, r, 0, 0, index, root == n.root ? n.chain : chain});
    };
    const auto left_turn = [&] { return at_left && turn(n, left, true, g, chain); };
    const auto right_turn = [&] { return at_right && turn(n, right, false, g, chain); };

    // At the goal a search for one path ends; one for all classes also goes on, behind the goal.
    if (n.root == left || n.root == right) {
      if (target) finish(n.g, n.root, index, n.chain);
      if (target && !all) return;
      leave(to_left, n.root, {left}, {apex});
      leave(to_right, n.root, {apex}, {right});
      return;
    }
    if (target) {
      const bool beyond_left = side(n.root, n.left, goal_) > 0, beyond_right = side(n.root, n.right, goal_) < 0;
      if (!beyond_left && !beyond_right) {
        finish(n.g, n.root, index, n.chain);
      } else if (all) {
        const Id v = beyond_left ? left : right;
        if ((beyond_left ? at_left : at_right) && mesh_.is_reflex(v))
          finish(n.g + distance(at(n.root), at(v)), v, index, extended(n.chain, v));
      } else {
        if (beyond_left && left_turn()) finish(g, left, index, chain);
        if (beyond_right && right_turn()) finish(g, right, index, chain);
      }
      if (!all) return;
    }
    const int sl = side(n.root, n.left, at(apex)), sr = side(n.root, n.right, at(apex));
    if (sl >= 0) {  // the cone leaves by the right edge only; turning left opens the rest
      leave(to_right, n.root, sl == 0 ? Ray{apex} : n.left, n.right);
      if (left_turn()) {
        leave(to_left, left, {left}, {apex});
        if (sl > 0) leave(to_right, left, {apex}, {n.root, true});
      }
    } else if (sr <= 0) {
      leave(to_left, n.root, n.left, sr == 0 ? Ray{apex} : n.right);
      if (right_turn()) {
        leave(to_right, right, {apex}, {right});
        if (sr < 0) leave(to_left, right, {n.root, true}, {apex});
      }
    } else {
      leave(to_left, n.root, n.left, {apex});
      leave(to_right, n.root, {apex}, n.right);
    }
  }

  const Mesh& mesh_;
  const Point start_, goal_;
  const double longest_;
  Scratch& s_;
  Chains* chains_ = nullptr;  // in a search for all classes
};

}  // namespace

struct ShortestPaths::Impl {
  Impl(Mesh of, double within) : mesh(std::move(of)), part(components(mesh)), tree(mesh, part), tolerance(within) {}

  /// One triangle for each group of `all` that hangs together by edges: where walls touch in a point, a place there
  /// has several.
  std::vector<std::int32_t> groups(const std::vector<std::int32_t>& all) const {
    std::vector<std::int32_t> first, stack;
    std::vector<bool> seen(all.size(), false);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (seen[i]) continue;
      first.push_back(all[i]);
      seen[i] = true;
      stack.assign(1, all[i]);
      while (!stack.empty()) {
        const std::int32_t t = stack.back();
        stack.pop_back();
        for (std::size_t j = 0; j < all.size(); ++j) {
          const auto& beside = mesh.triangles()[static_cast<std::size_t>(t)].neighbour;
          if (seen[j] || std::find(beside.begin(), beside.end(), all[j]) == beside.end()) continue;
          seen[j] = true;
          stack.push_back(all[j]);
        }
      }
    }
    return first;
  }

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
        const Point& a = mesh.points()[static_cast<std::size_t>(t.vertex[(k + 1) % 3])];
        const Point& b = mesh.points()[static_cast<std::size_t>(t.vertex[(k + 2) % 3])];
        if (orientation(a, b, p) <= 0) found.push_back(n);
      }
    }
    std::sort(found.begin(), found.end());
    return true;
  }

  /// Moves both ends into the mesh; lists their triangles, only those in parts of the region that hold both ends.
  bool place_both(Point& start, Point& goal, std::vector<std::int32_t>& from, std::vector<std::int32_t>& to) const {
    if (!place(start, from) || !place(goal, to)) return false;
    const auto keep_common = [&](std::vector<std::int32_t>& mine, const std::vector<std::int32_t>& other) {
      const auto part_of = [&](std::int32_t t) { return part[static_cast<std::size_t>(t)]; };
      std::erase_if(mine, [&](std::int32_t t) {
        return std::none_of(other.begin(), other.end(), [&](std::int32_t o) { return part_of(o) == part_of(t); });
      });
    };
    keep_common(from, to);
    keep_common(to, from);
    return !from.empty();
  }

  Mesh mesh;
  std::vector<std::int32_t> part;
  DualTree tree;
  double tolerance;
};

/// Both in one triangle: the straight way is free.
static bool meet(const std::vector<std::int32_t>& from, const std::vector<std::int32_t>& to) {
  return std::any_of(from.begin(), from.end(),
                     [&](std::int32_t t) { return std::binary_search(to.begin(), to.end(), t); });
}

ShortestPaths::ShortestPaths(const Region& region, double tolerance) : ShortestPaths(Mesh(region), tolerance) {}
ShortestPaths::ShortestPaths(Mesh mesh, double tolerance) {
  if (!(tolerance >= 0)) throw std::invalid_argument("tolerance of shortest paths must be 0 or more metres");
  impl_ = std::make_unique<const Impl>(std::move(mesh), tolerance);
}
ShortestPaths::~ShortestPaths() = default;
ShortestPaths::ShortestPaths(ShortestPaths&&) noexcept = default;
const Mesh& ShortestPaths::mesh() const { return impl_->mesh; }

std::optional<Polyline> ShortestPaths::path(const Point& a, const Point& b, double longest) const {
  if (!finite(a) || !finite(b) || !(distance(a, b) <= longest)) return std::nullopt;
  thread_local Scratch scratch;
  Point start = a, goal = b;
  if (!impl_->place_both(start, goal, scratch.from, scratch.to)) return std::nullopt;
  if (meet(scratch.from, scratch.to)) return Polyline{a, b};
  if (impl_->tree.covers(impl_->part[static_cast<std::size_t>(scratch.from.front())]) &&
      std::all_of(scratch.from.begin(), scratch.from.end(), [&](std::int32_t t) {
        return impl_->part[static_cast<std::size_t>(t)] == impl_->part[static_cast<std::size_t>(scratch.from.front())];
      })) {
    std::optional<Polyline> best;
    for (const std::int32_t from : impl_->groups(scratch.from))
      for (const std::int32_t to : impl_->groups(scratch.to)) {
        Polyline line = impl_->tree.path(start, from, goal, to);
        if (!best || length(line) < length(*best)) best = std::move(line);
      }
    best->front() = a;
    best->back() = b;
    if (length(*best) > longest) return std::nullopt;
    return best;
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

bool ShortestPaths::for_each_taut_path(const Point& a, const Point& b, double longest, std::size_t budget,
                                       const std::function<bool(const Polyline&)>& visit,
                                       const std::function<bool(const Polyline&)>& admits) const {
  if (!finite(a) || !finite(b) || !(distance(a, b) <= longest)) return true;
  Scratch scratch;  // of its own: visitors may ask for paths
  Point start = a, goal = b;
  if (!impl_->place_both(start, goal, scratch.from, scratch.to)) return true;
  const bool straight = meet(scratch.from, scratch.to);
  if (straight && !visit({a, b})) return true;
  Search search(impl_->mesh, start, goal, longest, scratch);
  const auto with_ends = [&](Polyline line, bool whole) {
    line.front() = a;
    if (whole) line.back() = b;
    if (line.size() > 2 && line[1] == a) line.erase(line.begin() + 1);
    if (whole && line.size() > 2 && line[line.size() - 2] == b) line.erase(line.end() - 2);
    return line;
  };
  const auto admits_prefix = [&](const Polyline& line) { return admits(with_ends(line, false)); };
  return search.run_all(
      straight, budget, [&](const Polyline& line) { return visit(with_ends(line, true)); },
      admits ? std::function<bool(const Polyline&)>(admits_prefix) : nullptr);
}

}  // namespace oxturn

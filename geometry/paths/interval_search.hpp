/// A* over cones of sight in a mesh (Polyanya), shared by the search for one shortest path and that for all taut paths.
/// Private to geometry, not installed.
///
/// A node of the search is a cone from a root (the start, or a vertex about which the path has turned) through an edge
/// of the mesh into the triangle behind it. Both sides of the cone are rays through given points, so that every
/// question about it is the exact orientation of three given points; no end of an interval is ever rounded.
///
///                  apex              The cone enters the triangle through the edge left-right. If the apex is in
///                  sight, /  \ .            it continues through both other edges; otherwise through one, and a turn
///                  about the
///                 /    \ .           end of the edge that hides the rest opens the other.
///            left --__-- right
///                 \    /
///                  root
///
/// graph_search.hpp would not do: nodes are made during the search, and of two nodes of equal cost the newer comes
/// first.
#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/mesh/mesh.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {

/// A point of the mesh; mesh.points().size() is the path's start, and one more its goal.
using PathPoint = std::int32_t;

/// Where a cone comes from.
struct ConeOrigin {
  PathPoint root = 0;
  double length = 0;       // of the path up to the root
  std::int32_t chain = 0;  // in a search for all taut paths: the chain of bends up to the root
};

/// A side of a cone: the ray from the root through a point, or straight away from it.
struct ConeSide {
  PathPoint by = 0;
  bool away = false;
};

struct ConeNode {
  ConeOrigin from;
  ConeSide left, right;
  std::int32_t triangle = Mesh::kWall;  // that the cone is about to enter; kWall: a finished path
  std::int32_t apex = 0;                // the triangle's vertex opposite the edge of entry
  std::int32_t parent = -1;             // node
};

/// Storage of a search. Reused between searches, so that each costs only what it touches.
struct ConeStorage {
  struct Open {
    double estimate;  // of the whole path's length
    std::int32_t node;
    /// For a heap with the least estimate on top; of equal ones the newest node.
    bool operator<(const Open& o) const { return estimate != o.estimate ? estimate > o.estimate : node < o.node; }
  };
  std::vector<ConeNode> nodes;
  std::vector<Open> open;
};

/// Derived has
///   bool is_target(triangle)                    does the triangle contain the goal?
///   bool is_useless(triangle, next)             no path need go on from the triangle into the next one
///   void starts_at(vertex)                      the start is this vertex
///   std::optional<ConeOrigin> turn(node, vertex, Turn)     the path turns about a vertex of the edge of entry
///   std::optional<ConeOrigin> last_turn(node, vertex, Turn)    ... and sees the goal then
///   std::int32_t finished_chain(origin)         the chain of a path from there to the goal
///   double least(origin)                        a lower bound of the whole path's length, if more is known; or 0
///   static constexpr bool kSearchesBehindGoal
template <class Derived>
class IntervalSearch {
 public:
  enum class Turn { left, right };

  /// `from`: the triangles that contain the start. Paths longer than `longest` are not searched.
  IntervalSearch(const Mesh& mesh, const Point& start, const Point& goal, double longest, ConeStorage& storage)
      : mesh_(mesh), storage_(storage), start_(start), goal_(goal), longest_(longest) {
    storage.nodes.clear();
    storage.open.clear();
  }

  PathPoint start_id() const { return static_cast<PathPoint>(mesh_.points().size()); }
  PathPoint goal_id() const { return start_id() + 1; }
  const Point& at(PathPoint id) const { return id < start_id() ? mesh_.point(id) : id == start_id() ? start_ : goal_; }

 protected:
  static constexpr double kRounding = 1e-12;  // by which equal lengths may differ, relative

  bool exhausted() const { return storage_.open.empty(); }
  std::int32_t pop() {
    std::pop_heap(storage_.open.begin(), storage_.open.end());
    const std::int32_t node = storage_.open.back().node;
    storage_.open.pop_back();
    return node;
  }
  const ConeNode& node(std::int32_t i) const { return storage_.nodes[static_cast<std::size_t>(i)]; }

  /// Opens the cones from the start through the far edges of the triangles that contain it.
  void leave_start(const std::vector<std::int32_t>& from) {
    for (const std::int32_t t : from) {
      for (std::size_t k = 0; k < 3; ++k) {
        const PathPoint vertex = mesh_.triangle(t).vertex[k];
        if (at(vertex) == start_) derived().starts_at(vertex);
        const std::int32_t n = mesh_.triangle(t).neighbour[k];
        if (n == Mesh::kWall || std::find(from.begin(), from.end(), n) != from.end()) continue;
        const PathPoint right = mesh_.triangle(t).vertex[(k + 1) % 3], left = mesh_.triangle(t).vertex[(k + 2) % 3];
        if (orientation(at(right), at(left), start_) > 0) leave(t, k, {start_id(), 0, 0}, {left}, {right}, -1);
      }
    }
  }

  /// Continues a cone through the triangle that it enters.
  void expand(std::int32_t index) {
    const ConeNode n = node(index);
    const Mesh::Triangle& t = mesh_.triangle(n.triangle);
    const auto k = static_cast<std::size_t>(n.apex);
    const PathPoint apex = t.vertex[k], left = t.vertex[(k + 1) % 3], right = t.vertex[(k + 2) % 3];
    const std::size_t to_left = (k + 2) % 3, to_right = (k + 1) % 3;  // the edges left-apex and apex-right
    const auto leave_by = [&](std::size_t edge, const ConeOrigin& from, ConeSide l, ConeSide r) {
      leave(n.triangle, edge, from, l, r, index);
    };
    const bool target = derived().is_target(n.triangle);
    if (n.from.root == left || n.from.root == right) {  // the whole triangle is in sight
      if (target) finish(n.from, index);
      if (target && !Derived::kSearchesBehindGoal) return;
      leave_by(to_left, n.from, {left}, {apex});
      leave_by(to_right, n.from, {apex}, {right});
      return;
    }
    const bool by_left = n.left.by == left && !n.left.away, by_right = n.right.by == right && !n.right.away;
    if (target) {
      enter_target(n, index, by_left ? left : kNoVertex, by_right ? right : kNoVertex);
      if (!Derived::kSearchesBehindGoal) return;
    }
    const int sl = side(n.from.root, n.left, at(apex)), sr = side(n.from.root, n.right, at(apex));
    if (sl >= 0) {
      leave_by(to_right, n.from, sl == 0 ? ConeSide{apex} : n.left, n.right);
      if (!by_left) return;
      if (const auto turned = derived().turn(n, left, Turn::left)) {
        leave_by(to_left, *turned, {left}, {apex});
        if (sl > 0) leave_by(to_right, *turned, {apex}, {n.from.root, true});
      }
    } else if (sr <= 0) {
      leave_by(to_left, n.from, n.left, sr == 0 ? ConeSide{apex} : n.right);
      if (!by_right) return;
      if (const auto turned = derived().turn(n, right, Turn::right)) {
        leave_by(to_right, *turned, {apex}, {right});
        if (sr < 0) leave_by(to_left, *turned, {n.from.root, true}, {apex});
      }
    } else {
      leave_by(to_left, n.from, n.left, {apex});
      leave_by(to_right, n.from, {apex}, n.right);
    }
  }

  const Mesh& mesh_;
  ConeStorage& storage_;

 private:
  static constexpr PathPoint kNoVertex = -1;

  Derived& derived() { return static_cast<Derived&>(*this); }
  /// On which side of a ray from `root` is x? +1: left.
  int side(PathPoint root, const ConeSide& ray, const Point& x) const {
    return ray.away ? orientation(at(ray.by), at(root), x) : orientation(at(root), at(ray.by), x);
  }

  /// Finishes the path to the goal in the triangle that the cone enters: straight, or by a turn about the end of the
  /// edge that hides the goal, if the cone's side is that end.
  void enter_target(const ConeNode& n, std::int32_t index, PathPoint left_end, PathPoint right_end) {
    const bool beyond_left = side(n.from.root, n.left, goal_) > 0, beyond_right = side(n.from.root, n.right, goal_) < 0;
    if (!beyond_left && !beyond_right) finish(n.from, index);
    if (beyond_left && left_end != kNoVertex)
      if (const auto turned = derived().last_turn(n, left_end, Turn::left)) finish(*turned, index);
    if (beyond_right && right_end != kNoVertex)
      if (const auto turned = derived().last_turn(n, right_end, Turn::right)) finish(*turned, index);
  }
  void finish(const ConeOrigin& from, std::int32_t parent) {
    ConeNode end;
    end.from = {from.root, from.length, derived().finished_chain(from)};
    end.parent = parent;
    put(from.length + distance(at(from.root), goal_), end);
  }

  /// Adds the cone that leaves triangle t by edge k.
  void leave(std::int32_t t, std::size_t k, const ConeOrigin& from, ConeSide left, ConeSide right,
             std::int32_t parent) {
    const std::int32_t n = mesh_.triangle(t).neighbour[k];
    if (n == Mesh::kWall || derived().is_useless(t, n)) return;
    const ConeNode next{from, left, right, n, static_cast<std::int32_t>(mesh_.edge_towards(n, t)), parent};
    // Lowered a little, so that rounding never lets a longer path finish first.
    put(std::max(from.length + remaining(next) * (1 - 1e-9), derived().least(from)), next);
  }
  void put(double estimate, const ConeNode& node) {
    if (estimate > longest_ * (1 + kRounding)) return;
    storage_.open.push_back({estimate, static_cast<std::int32_t>(storage_.nodes.size())});
    storage_.nodes.push_back(node);
    std::push_heap(storage_.open.begin(), storage_.open.end());
  }

  /// A lower bound of the length from the root through the cone's interval on the edge of entry to the goal.
  double remaining(const ConeNode& node) const {
    const Mesh::Triangle& t = mesh_.triangle(node.triangle);
    const auto k = static_cast<std::size_t>(node.apex);
    const PathPoint left_end = t.vertex[(k + 1) % 3], right_end = t.vertex[(k + 2) % 3];
    const Point& r = at(node.from.root);
    if (node.from.root == left_end || node.from.root == right_end) return distance(r, goal_);
    const Point &vl = at(left_end), &vr = at(right_end);
    const Point edge = vr - vl;
    // A root almost collinear with the edge: rounding would choose the interval, so only the straight distance is
    // certain.
    const double height = cross(edge, vl - r);
    if (height * height < 1e-12 * edge.squaredNorm() * std::max(edge.squaredNorm(), (vl - r).squaredNorm()))
      return distance(r, goal_);
    Point goal = goal_;  // reflected to the far side of the edge, if it is on the root's side
    const double beyond = cross(edge, goal - vl);
    if (beyond < 0) goal = vl + (goal - vl) - perpendicular(edge) * (2 * beyond / edge.squaredNorm());
    const Point left = node.left.by == left_end && !node.left.away ? vl : hit(r, node.left, vl, vr);
    const Point right = node.right.by == right_end && !node.right.away ? vr : hit(r, node.right, vl, vr);
    const Point to_goal = goal - r;
    if (cross(left - r, to_goal) > 0) return distance(r, left) + distance(left, goal);
    if (cross(right - r, to_goal) < 0) return distance(r, right) + distance(right, goal);
    return to_goal.norm();
  }
  /// Where a ray from r meets the edge from vl to vr; rounded.
  Point hit(const Point& r, const ConeSide& ray, const Point& vl, const Point& vr) const {
    const Point d = ray.away ? Point(r - at(ray.by)) : Point(at(ray.by) - r);
    const double a = std::max(0.0, cross(d, vl - r)), b = std::max(0.0, -cross(d, vr - r));
    return a + b > 0 ? lerp(vl, vr, a / (a + b)) : vl;
  }

  const Point start_, goal_;
  const double longest_;
};

}  // namespace oxturn

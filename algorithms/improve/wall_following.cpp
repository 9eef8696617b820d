#include "algorithms/improve/wall_following.hpp"

#include <algorithm>
#include <numeric>

namespace oxturn {
namespace {

constexpr int kMostVertices = 200;  // of walls beside one edge of the path
constexpr double kInside = 2e-6;    // tolerances, from a wall: more than rounding

}  // namespace

WallFollowing::WallFollowing(const EdgeIndex& walls) : walls_(walls) {
  const std::vector<EdgeIndex::Edge>& edges = walls.edges();
  std::vector<std::size_t> by_start(edges.size());
  std::iota(by_start.begin(), by_start.end(), std::size_t{0});
  const auto start = [&](std::size_t e) { return edges[e].a; };
  std::ranges::stable_sort(by_start, before, start);
  next_.resize(edges.size());
  previous_.resize(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    next_[e] = *std::ranges::lower_bound(by_start, edges[e].b, before, start);
    previous_[next_[e]] = e;
  }
}

std::optional<WallFollowing::OnWall> WallFollowing::foot(const Point& p, double tolerance) const {
  const auto near = walls_.nearest(p, tolerance);
  if (!near) return std::nullopt;
  if (walls_.contains(near->point)) return OnWall{near->point, near->edge};
  // Rounding has put it behind the wall; free space is to the left of its edges.
  const EdgeIndex::Edge& wall = walls_.edges()[near->edge];
  const Point inside = near->point + kInside * tolerance * perpendicular(wall.b - wall.a).normalized();
  if (!walls_.contains(inside)) return std::nullopt;
  return OnWall{inside, near->edge};
}

/// The boundary from one point to the other; nullopt if it leaves the chord between them by more than the tolerance.
std::optional<Polyline> WallFollowing::walk(const OnWall& from, const OnWall& to, double tolerance,
                                            bool forward) const {
  const std::vector<EdgeIndex::Edge>& edges = walls_.edges();
  Polyline line{from.point};
  std::size_t edge = from.edge;
  for (int k = 0; k < kMostVertices; ++k) {
    const Point end = forward ? edges[edge].b : edges[edge].a;
    const bool ahead = (to.point - from.point).dot(end - line.back()) >= 0;
    if (edge == to.edge && distance(line.back(), to.point) <= distance(line.back(), end) && ahead) {
      line.push_back(to.point);
      return line;
    }
    if (distance_to_segment(end, from.point, to.point) > tolerance) return std::nullopt;
    line.push_back(end);
    edge = forward ? next_[edge] : previous_[edge];
  }
  return std::nullopt;
}

std::optional<Polyline> WallFollowing::beside(const OnWall& from, const OnWall& to, double tolerance) const {
  if (auto line = walk(from, to, tolerance, true)) return line;
  return walk(from, to, tolerance, false);
}

Polyline WallFollowing::snapped(const Polyline& path, double tolerance) const {
  std::vector<std::optional<OnWall>> feet;
  for (const Point& p : path) feet.push_back(foot(p, tolerance));
  Polyline all{path.front()};
  const auto add = [&all](const Point& p) {
    if (p != all.back()) all.push_back(p);
  };
  for (std::size_t i = 1; i < path.size(); ++i) {
    std::optional<Polyline> line;
    if (feet[i - 1] && feet[i]) line = beside(*feet[i - 1], *feet[i], tolerance);
    const bool valid = line && std::ranges::adjacent_find(*line, [&](const Point& a, const Point& b) {
                                 return !walls_.contains(a, b);
                               }) == line->end();
    if (valid) {
      for (const Point& p : *line) add(p);
    } else {
      add(path[i - 1]);  // from the wall, if it got there
      add(path[i]);
    }
  }
  add(path.back());
  return all;
}

}  // namespace oxturn

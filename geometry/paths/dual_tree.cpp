#include "geometry/paths/dual_tree.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr double kRounding = 1 + 1e-9;

/// The shortest path through portals, by a funnel: an apex and the narrowest view of the portals passed so far. Where
/// one side of the view crosses the other, the path bends there and a new view begins.
class Funnel {
 public:
  /// The last portal is the goal, twice.
  template <class Portal>
  static Polyline path(const Point& start, const std::vector<Portal>& portals) {
    Funnel f(start, portals[0].left, portals[0].right);
    for (std::size_t i = 1; i < portals.size(); ++i) i = f.pass(i, portals[i].left, portals[i].right);
    const Point& goal = portals.back().left;
    if (goal != f.line_.back() || f.line_.size() == 1) f.line_.push_back(goal);
    return std::move(f.line_);
  }

 private:
  /// A side of the view, and the portal that it comes from.
  struct Side {
    Point at;
    std::size_t portal;
  };

  Funnel(const Point& start, const Point& left, const Point& right)
      : line_{start}, apex_(start), left_{left, 0}, right_{right, 0} {}

  /// Narrows the view by portal i. Returns i, or the portal of a bend, from which to go on.
  std::size_t pass(std::size_t i, const Point& left, const Point& right) {
    if (orientation(apex_, right_.at, right) >= 0) {
      if (apex_ != right_.at && orientation(apex_, left_.at, right) >= 0) return bend_at(left_);
      right_ = {right, i};
    }
    if (orientation(apex_, left_.at, left) <= 0) {
      if (apex_ != left_.at && orientation(apex_, right_.at, left) <= 0) return bend_at(right_);
      left_ = {left, i};
    }
    return i;
  }
  std::size_t bend_at(const Side side) {
    if (side.at != line_.back()) line_.push_back(side.at);
    apex_ = side.at;
    left_ = right_ = side;
    return side.portal;
  }

  Polyline line_;
  Point apex_;
  Side left_, right_;
};

}  // namespace

DualTree::DualTree(const Mesh& mesh, const ConnectedComponents& components)
    : mesh_(mesh), parent_(mesh.triangles().size(), kNone), depth_(mesh.triangles().size(), kNone) {
  // A connected graph is a tree if it has one edge less than nodes.
  const auto count = static_cast<std::size_t>(components.count);
  std::vector<std::size_t> triangles(count, 0), half_edges(count, 0);
  std::vector<std::int32_t> queue;
  for (std::size_t root = 0; root < mesh.triangles().size(); ++root) {
    const auto component = static_cast<std::size_t>(components.of[root]);
    ++triangles[component];
    for (const std::int32_t n : mesh.triangles()[root].neighbour)
      if (n != Mesh::kWall) ++half_edges[component];
    if (depth_[root] != kNone) continue;
    depth_[root] = 0;
    queue.assign(1, static_cast<std::int32_t>(root));
    breadth_first(queue, [&](std::int32_t t, auto reach) {
      for (const std::int32_t n : mesh.triangle(t).neighbour) {
        if (n == Mesh::kWall || depth_[static_cast<std::size_t>(n)] != kNone) continue;
        depth_[static_cast<std::size_t>(n)] = depth_[static_cast<std::size_t>(t)] + 1;
        parent_[static_cast<std::size_t>(n)] = t;
        reach(n);
      }
    });
  }
  for (std::size_t c = 0; c < count; ++c) is_tree_.push_back(half_edges[c] == 2 * (triangles[c] - 1));
}

DualTree::Portal DualTree::portal(std::int32_t from, std::int32_t to) const {
  const std::size_t k = mesh_.edge_towards(from, to);
  return {mesh_.vertex(from, k + 2), mesh_.vertex(from, k + 1)};
}

/// From both ends up the tree to where they meet.
std::optional<std::vector<std::int32_t>> DualTree::sleeve(const Point& start, std::int32_t from, const Point& goal,
                                                          std::int32_t to, double longest) const {
  const bool bounded = std::isfinite(longest);
  std::vector<std::int32_t> up{from}, down{to};
  const auto depth = [&](std::int32_t t) { return depth_[static_cast<std::size_t>(t)]; };
  while (up.back() != down.back()) {
    std::vector<std::int32_t>& deeper = depth(up.back()) >= depth(down.back()) ? up : down;
    const std::int32_t parent = parent_[static_cast<std::size_t>(deeper.back())];
    if (bounded) {
      const Portal door = portal(deeper.back(), parent);
      const double least =
          distance_to_segment(start, door.left, door.right) + distance_to_segment(goal, door.left, door.right);
      if (least > longest * kRounding) return std::nullopt;
    }
    deeper.push_back(parent);
  }
  up.insert(up.end(), down.rbegin() + 1, down.rend());
  return up;
}

std::optional<Polyline> DualTree::path(const Point& start, std::int32_t from, const Point& goal, std::int32_t to,
                                       double longest) const {
  const auto triangles = sleeve(start, from, goal, to, longest);
  if (!triangles) return std::nullopt;
  thread_local std::vector<Portal> portals;
  portals.clear();
  for (std::size_t i = 1; i < triangles->size(); ++i) portals.push_back(portal((*triangles)[i - 1], (*triangles)[i]));
  // A start on the first portals has passed them: seen from it they span 180 degrees, which orientations cannot tell
  // from none.
  portals.erase(portals.begin(), std::find_if(portals.begin(), portals.end(), [&](const Portal& p) {
                  return orientation(p.right, p.left, start) > 0;
                }));
  portals.push_back({goal, goal});
  const Polyline line = Funnel::path(start, portals);
  // Vertices that the path only touches are not bends.
  Polyline bends{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (orientation(bends.back(), line[i], line[i + 1]) != 0) bends.push_back(line[i]);
  bends.push_back(line.back());
  return bends;
}

}  // namespace oxturn

#include "geometry/paths/dual_tree.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/paths/sleeve.hpp"

namespace oxturn {
namespace {

constexpr double kRounding = 1 + 1e-9;

}  // namespace

DualTree::DualTree(const Mesh& mesh, const ConnectedComponents& components)
    : mesh_(mesh),
      parent_(mesh.triangles().size(), kNone),
      depth_(mesh.triangles().size(), kNone),
      out_(mesh.triangles().size(), kNone) {
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
  find_dead_ends(components);
}

/// Strips leaves.
void DualTree::find_dead_ends(const ConnectedComponents& components) {
  std::vector<std::int32_t> leaves;
  /// The only neighbour of t that is no dead end; kNone if there are more.
  const auto only_exit = [&](std::int32_t t) {
    std::int32_t exit = kNone;
    for (const std::int32_t n : mesh_.triangle(t).neighbour) {
      if (n == Mesh::kWall || out_of(n) != kNone) continue;
      if (exit != kNone) return kNone;
      exit = n;
    }
    return exit;
  };
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(out_.size()); ++t)
    if (!is_tree(components.of[static_cast<std::size_t>(t)]) && only_exit(t) != kNone) leaves.push_back(t);
  while (!leaves.empty()) {
    const std::int32_t t = leaves.back();
    leaves.pop_back();
    const std::int32_t exit = only_exit(t);
    out_[static_cast<std::size_t>(t)] = exit;
    if (only_exit(exit) != kNone) leaves.push_back(exit);
  }
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
      const Portal door = portal_between(mesh_, deeper.back(), parent);
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
  return shortest_in_sleeve(mesh_, start, *triangles, goal);
}

}  // namespace oxturn

#include "geometry/paths/dual_tree.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace oxturn {

DualTree::DualTree(const Mesh& mesh, const std::vector<std::int32_t>& part)
    : mesh_(mesh), parent_(part.size(), -1), depth_(part.size(), -1) {
  const std::int32_t parts = part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
  std::vector<std::size_t> triangles(static_cast<std::size_t>(parts), 0), sides(triangles);
  std::vector<std::int32_t> queue;
  for (std::size_t root = 0; root < part.size(); ++root) {
    ++triangles[static_cast<std::size_t>(part[root])];
    for (const std::int32_t n : mesh.triangles()[root].neighbour)
      if (n != Mesh::kWall) ++sides[static_cast<std::size_t>(part[root])];
    if (depth_[root] >= 0) continue;
    depth_[root] = 0;
    queue.assign(1, static_cast<std::int32_t>(root));
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const auto t = static_cast<std::size_t>(queue[k]);
      for (const std::int32_t n : mesh.triangles()[t].neighbour) {
        if (n == Mesh::kWall || depth_[static_cast<std::size_t>(n)] >= 0) continue;
        depth_[static_cast<std::size_t>(n)] = depth_[t] + 1;
        parent_[static_cast<std::size_t>(n)] = queue[k];
        queue.push_back(n);
      }
    }
  }
  for (std::size_t p = 0; p < triangles.size(); ++p) tree_.push_back(sides[p] == 2 * (triangles[p] - 1));
}

void DualTree::portals(std::int32_t from, std::int32_t to, std::vector<Portal>& out) const {
  std::vector<std::int32_t> up{from}, down{to};
  const auto depth = [&](std::int32_t t) { return depth_[static_cast<std::size_t>(t)]; };
  while (up.back() != down.back()) {
    std::vector<std::int32_t>& deeper = depth(up.back()) >= depth(down.back()) ? up : down;
    deeper.push_back(parent_[static_cast<std::size_t>(deeper.back())]);
  }
  up.insert(up.end(), down.rbegin() + 1, down.rend());
  out.clear();
  for (std::size_t i = 1; i < up.size(); ++i) {
    const Mesh::Triangle& t = mesh_.triangles()[static_cast<std::size_t>(up[i - 1])];
    std::size_t k = 0;
    while (t.neighbour[k] != up[i]) ++k;
    out.push_back({mesh_.points()[static_cast<std::size_t>(t.vertex[(k + 2) % 3])],
                   mesh_.points()[static_cast<std::size_t>(t.vertex[(k + 1) % 3])]});
  }
}

Polyline DualTree::path(const Point& start, std::int32_t from, const Point& goal, std::int32_t to) const {
  thread_local std::vector<Portal> sleeve;
  portals(from, to, sleeve);
  // A start that lies on the first portals has passed them: from there such a portal spans 180 degrees, which
  // orientations cannot tell from none.
  sleeve.erase(sleeve.begin(), std::find_if(sleeve.begin(), sleeve.end(),
                                            [&](const Portal& p) { return orientation(p.right, p.left, start) > 0; }));
  sleeve.push_back({goal, goal});
  Polyline line{start};
  // The funnel: an apex and the narrowest view of the portals so far. Where one side crosses the other, that one is a
  // bend, and the view begins anew from there.
  Point apex = start, left = sleeve[0].left, right = sleeve[0].right;
  std::size_t at_left = 0, at_right = 0;
  const auto turn = [&](const Point& bend, std::size_t& i, std::size_t at) {
    if (bend != line.back()) line.push_back(bend);
    apex = left = right = bend;
    at_left = at_right = i = at;
  };
  for (std::size_t i = 1; i < sleeve.size(); ++i) {
    const Portal& next = sleeve[i];
    if (orientation(apex, right, next.right) >= 0) {
      if (apex == right || orientation(apex, left, next.right) < 0) {
        right = next.right;
        at_right = i;
      } else {
        turn(left, i, at_left);
        continue;
      }
    }
    if (orientation(apex, left, next.left) <= 0) {
      if (apex == left || orientation(apex, right, next.left) > 0) {
        left = next.left;
        at_left = i;
      } else {
        turn(right, i, at_right);
      }
    }
  }
  if (goal != line.back() || line.size() == 1) line.push_back(goal);
  // Corners that the path only touches are no bends.
  Polyline bends{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (orientation(bends.back(), line[i], line[i + 1]) != 0) bends.push_back(line[i]);
  bends.push_back(line.back());
  return bends;
}

}  // namespace oxturn

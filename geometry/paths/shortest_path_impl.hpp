/// What ShortestPaths keeps, for both of its searches. Private to geometry, not installed.
#pragma once

#include <algorithm>

#include "geometry/paths/dual_tree.hpp"
#include "geometry/paths/shortest_path.hpp"

namespace oxturn {

struct ShortestPaths::Impl {
  Impl(Mesh mesh_, double tolerance_)
      : mesh(std::move(mesh_)),
        components(connected_components(mesh.triangles().size(),
                                        [this](std::size_t t, auto reach) {
                                          for (const std::int32_t n : mesh.triangles()[t].neighbour)
                                            if (n != Mesh::kWall) reach(static_cast<std::size_t>(n));
                                        })),
        tree(mesh, components),
        tolerance(tolerance_) {}

  std::int32_t component(std::int32_t triangle) const { return components.of[static_cast<std::size_t>(triangle)]; }

  /// The two ends of a path, moved into the mesh, and the triangles that contain them.
  struct Ends {
    Point start, goal;
    std::vector<std::int32_t> from, to;
    /// Both in one triangle: the straight path is free.
    bool share_a_triangle() const {
      return std::any_of(from.begin(), from.end(),
                         [&](std::int32_t t) { return std::binary_search(to.begin(), to.end(), t); });
    }
  };
  /// Fills `ends`, with triangles of components only that contain both. False if there are none.
  bool find_ends(const Point& start, const Point& goal, Ends& ends) const {
    ends.start = start;
    ends.goal = goal;
    if (!mesh.move_inside(ends.start, tolerance, ends.from) || !mesh.move_inside(ends.goal, tolerance, ends.to))
      return false;
    const auto keep_common = [&](std::vector<std::int32_t>& mine, const std::vector<std::int32_t>& other) {
      std::erase_if(mine, [&](std::int32_t t) {
        return std::none_of(other.begin(), other.end(), [&](std::int32_t o) { return component(o) == component(t); });
      });
    };
    keep_common(ends.from, ends.to);
    keep_common(ends.to, ends.from);
    return !ends.from.empty();
  }

  Mesh mesh;
  ConnectedComponents components;  // of triangles
  DualTree tree;
  double tolerance;
};

}  // namespace oxturn

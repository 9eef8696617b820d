/// Shortest paths in components of free space without holes. Private to geometry, not installed.
///
/// There the triangles, joined where they share an edge, form a tree. So the sequence of triangles (sleeve) between two
/// points is unique, and a funnel through it gives the shortest path without a search.
///
/// Source      Lee and Preparata, "Euclidean shortest paths in the presence of rectilinear barriers", 1984 (the funnel)
/// Complexity  build O(triangles); a path costs the triangles of its sleeve
#pragma once

#include <cstdint>
#include <optional>

#include "base/graph_search.hpp"
#include "geometry/mesh/mesh.hpp"

namespace oxturn {

class DualTree {
 public:
  /// `components`: of the mesh's triangles.
  DualTree(const Mesh& mesh, const ConnectedComponents& components);
  /// Is the component free of holes?
  bool is_tree(std::int32_t component) const { return is_tree_[static_cast<std::size_t>(component)]; }
  /// The shortest path from a point of triangle `from` to one of triangle `to`, both points included. The triangles
  /// must be in one component without holes. nullopt if it is certainly longer than `longest`: found after as many
  /// triangles as the robot can enter within that length.
  std::optional<Polyline> path(const Point& start, std::int32_t from, const Point& goal, std::int32_t to,
                               double longest) const;

 private:
  /// An edge between two triangles of a sleeve, seen in the direction of the path.
  struct Portal {
    Point left, right;
  };
  Portal portal(std::int32_t from, std::int32_t to) const;
  /// The triangles of the sleeve, if every portal of it can be passed on a path no longer than `longest`.
  std::optional<std::vector<std::int32_t>> sleeve(const Point& start, std::int32_t from, const Point& goal,
                                                  std::int32_t to, double longest) const;

  static constexpr std::int32_t kNone = -1;
  const Mesh& mesh_;
  std::vector<bool> is_tree_;                 // by component
  std::vector<std::int32_t> parent_, depth_;  // by triangle; kNone: a root, not reached
};

}  // namespace oxturn

/// Shortest paths in components of free space without holes, and the dead ends of all others. Private to geometry, not
/// installed.
///
/// Without holes the triangles, joined where they share an edge, form a tree. So the sequence of triangles (sleeve)
/// between two points is unique, and a funnel through it (sleeve.hpp) gives the shortest path without a search.
///
/// Where there are holes, triangles that are left by one edge only, and those that are when these are gone, are dead
/// ends: no shortest path enters one but to end there. Demyen and Buro, "Efficient triangulation-based pathfinding",
/// AAAI 2006.
///
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
  /// In a component with holes: the triangle by which dead end t is left; kNone if t is no dead end.
  std::int32_t out_of(std::int32_t t) const { return out_[static_cast<std::size_t>(t)]; }

  static constexpr std::int32_t kNone = -1;

 private:
  void find_dead_ends(const ConnectedComponents& components);
  /// The triangles of the sleeve, if every portal of it can be passed on a path no longer than `longest`.
  std::optional<std::vector<std::int32_t>> sleeve(const Point& start, std::int32_t from, const Point& goal,
                                                  std::int32_t to, double longest) const;

  const Mesh& mesh_;
  std::vector<bool> is_tree_;                 // by component
  std::vector<std::int32_t> parent_, depth_;  // by triangle; kNone: a root, not reached
  std::vector<std::int32_t> out_;             // by triangle
};

}  // namespace oxturn

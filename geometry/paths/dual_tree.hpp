// Shortest paths where free space has no holes: the sleeve of triangles between two places is the only one.
// Internal to geometry/.
//
// Source      Lee & Preparata, "Euclidean shortest paths in the presence of rectilinear barriers", 1984 (the funnel)
// Complexity  build O(triangles); a path O(triangles of its sleeve), usually; nothing is searched
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

class DualTree {
 public:
  /// `part`: the number of each triangle's connected part, from 0.
  DualTree(const Mesh& mesh, const std::vector<std::int32_t>& part);
  /// The part has no holes: its triangles and the edges between them are a tree.
  bool covers(std::int32_t part) const { return tree_[static_cast<std::size_t>(part)]; }
  /// From a place in triangle `from` to one in `to` (of one covered part), both places included.
  Polyline path(const Point& start, std::int32_t from, const Point& goal, std::int32_t to) const;

 private:
  struct Portal {
    Point left, right;
  };
  void portals(std::int32_t from, std::int32_t to, std::vector<Portal>& out) const;

  const Mesh& mesh_;
  std::vector<bool> tree_;
  std::vector<std::int32_t> parent_, depth_;  // by triangle
};

}  // namespace oxturn

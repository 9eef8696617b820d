/// Groups of neighbouring triangles of a mesh, and roughly how far it is from one to another.
///
///   TriangleGroups groups(mesh, 256);
///   groups.neighbours(groups.of(triangle));   // groups that share a side with it
///
/// A search over groups finds out where something far away is, in a small part of the time that a search over the
/// triangles takes. Two groups are connected if and only if their triangles are. O(t) for t triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

class TriangleGroups {
 public:
  /// `size`: triangles in a group at most; fewer in the gaps between others.
  TriangleGroups(const Mesh& mesh, std::size_t size);

  std::size_t count() const { return centres_.size(); }
  std::uint32_t of(std::size_t triangle) const { return group_[triangle]; }
  /// The mean of its triangles' centres.
  const Point& centre(std::size_t group) const { return centres_[group]; }
  std::span<const std::uint32_t> neighbours(std::size_t group) const {
    return std::span(neighbours_).subspan(first_[group], first_[group + 1] - first_[group]);
  }

 private:
  void grow_from(const Mesh& mesh, std::size_t triangle, std::size_t size);
  void connect(const Mesh& mesh);

  std::vector<std::uint32_t> group_;  // by triangle
  std::vector<Point> centres_;
  std::vector<std::size_t> first_;  // in neighbours_, by group
  std::vector<std::uint32_t> neighbours_;
};

}  // namespace oxturn

/// The triangles of a mesh, joined into larger polygons by removing diagonals. Private to geometry, not installed.
///
///   MeshParts parts(mesh);
///   parts.remove(diagonal);
///   return parts.rings();
#pragma once

#include <cstdint>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

class MeshParts {
 public:
  /// A half-edge: 3 t + k is edge k of triangle t, with the triangle to its left.
  using Half = std::int32_t;
  static constexpr Half kNone = -1;

  explicit MeshParts(const Mesh& mesh) : mesh_(mesh) {
    const std::size_t n = 3 * mesh.triangles().size();
    next_.resize(n);
    previous_.resize(n);
    removed_.assign(n, false);
    for (std::size_t h = 0; h < n; ++h) {
      const std::size_t t = h / 3, k = h % 3;
      next_[h] = static_cast<Half>(3 * t + (k + 1) % 3);
      previous_[h] = static_cast<Half>(3 * t + (k + 2) % 3);
    }
  }

  Half half_edges() const { return static_cast<Half>(next_.size()); }
  static std::int32_t triangle(Half h) { return h / 3; }
  /// The mesh's points at the two ends.
  std::int32_t from(Half h) const { return mesh_.triangle(triangle(h)).vertex[(edge(h) + 1) % 3]; }
  std::int32_t to(Half h) const { return mesh_.triangle(triangle(h)).vertex[(edge(h) + 2) % 3]; }
  const Point& start(Half h) const { return mesh_.point(from(h)); }
  const Point& end(Half h) const { return mesh_.point(to(h)); }
  /// The half-edge in the other direction, or kNone at a wall.
  Half twin(Half h) const {
    const std::int32_t n = mesh_.triangle(triangle(h)).neighbour[edge(h)];
    if (n == Mesh::kWall) return kNone;
    return 3 * n + static_cast<Half>(mesh_.edge_towards(n, triangle(h)));
  }
  /// Along the boundary of the polygon to the left.
  Half next(Half h) const { return next_[static_cast<std::size_t>(h)]; }
  Half previous(Half h) const { return previous_[static_cast<std::size_t>(h)]; }

  /// Joins the polygons on both sides of the diagonal h.
  void remove(Half h) {
    const Half t = twin(h);
    link(previous(h), next(t));
    link(previous(t), next(h));
    removed_[static_cast<std::size_t>(h)] = removed_[static_cast<std::size_t>(t)] = true;
  }

  /// The polygons, counter-clockwise, in the order of their first half-edges.
  std::vector<Ring> rings() const {
    std::vector<Ring> out;
    std::vector<bool> seen = removed_;
    for (Half first = 0; first < half_edges(); ++first) {
      Ring ring;
      for (Half h = first; !seen[static_cast<std::size_t>(h)]; h = next(h)) {
        seen[static_cast<std::size_t>(h)] = true;
        ring.push_back(start(h));
      }
      if (!ring.empty()) out.push_back(std::move(ring));
    }
    return out;
  }

 private:
  static std::size_t edge(Half h) { return static_cast<std::size_t>(h % 3); }
  void link(Half a, Half b) {
    next_[static_cast<std::size_t>(a)] = b;
    previous_[static_cast<std::size_t>(b)] = a;
  }

  const Mesh& mesh_;
  std::vector<Half> next_, previous_;
  std::vector<bool> removed_;
};

/// Divides the region by few diagonals of its mesh into simple polygons without holes and without repeated vertices,
/// for algorithms that know neither holes nor touching rings. A simple polygon stays whole.
std::vector<Ring> simple_pieces(const Region& region);

}  // namespace oxturn

// Private to geometry: a mesh's triangles glued into larger parts by dropping diagonals.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

/// Half-edge 3 t + i lies opposite corner i of triangle t, with t to its left. next and prev run round the part.
class MeshParts {
 public:
  using Half = std::int32_t;
  explicit MeshParts(const Mesh& mesh) : mesh_(mesh) {
    const std::size_t n = 3 * mesh.triangles().size();
    next_.resize(n);
    prev_.resize(n);
    dropped_.assign(n, false);
    for (std::size_t h = 0; h < n; ++h) {
      const std::size_t t = h / 3, i = h % 3;
      next_[h] = static_cast<Half>(3 * t + (i + 1) % 3);
      prev_[h] = static_cast<Half>(3 * t + (i + 2) % 3);
    }
  }

  std::size_t halves() const { return next_.size(); }
  std::int32_t from(Half h) const { return triangle(h).vertex[static_cast<std::size_t>((h + 1 - 3 * (h / 3)) % 3)]; }
  std::int32_t to(Half h) const { return triangle(h).vertex[static_cast<std::size_t>((h + 2 - 3 * (h / 3)) % 3)]; }
  const Point& point(std::int32_t corner) const { return mesh_.points()[static_cast<std::size_t>(corner)]; }
  /// The same edge seen from the other side, or kWall.
  Half twin(Half h) const {
    const std::int32_t n = triangle(h).neighbour[static_cast<std::size_t>(h % 3)];
    if (n == Mesh::kWall) return Mesh::kWall;
    const Mesh::Triangle& t = mesh_.triangles()[static_cast<std::size_t>(n)];
    Half i = 0;
    while (t.neighbour[static_cast<std::size_t>(i)] != h / 3) ++i;
    return 3 * n + i;
  }
  Half next(Half h) const { return next_[static_cast<std::size_t>(h)]; }
  Half prev(Half h) const { return prev_[static_cast<std::size_t>(h)]; }

  /// Joins the parts on both sides of the diagonal h.
  void drop(Half h) {
    const Half t = twin(h);
    link(prev(h), next(t));
    link(prev(t), next(h));
    dropped_[static_cast<std::size_t>(h)] = dropped_[static_cast<std::size_t>(t)] = true;
  }

  /// The parts' rings, counter-clockwise, in the order of their first half-edge.
  std::vector<Ring> rings() const {
    std::vector<Ring> out;
    std::vector<bool> seen = dropped_;
    for (std::size_t start = 0; start < halves(); ++start) {
      if (seen[start]) continue;
      Ring ring;
      for (auto h = static_cast<Half>(start); !seen[static_cast<std::size_t>(h)]; h = next(h)) {
        seen[static_cast<std::size_t>(h)] = true;
        ring.push_back(point(from(h)));
      }
      out.push_back(std::move(ring));
    }
    return out;
  }

 private:
  const Mesh::Triangle& triangle(Half h) const { return mesh_.triangles()[static_cast<std::size_t>(h / 3)]; }
  void link(Half a, Half b) {
    next_[static_cast<std::size_t>(a)] = b;
    prev_[static_cast<std::size_t>(b)] = a;
  }

  const Mesh& mesh_;
  std::vector<Half> next_, prev_;
  std::vector<bool> dropped_;
};

/// Cuts the region by few diagonals of its mesh into simple polygons without holes and without repeated corners; a
/// simple polygon stays whole. For methods that know neither holes nor touching rings.
std::vector<Ring> simple_pieces(const Region& region);

}  // namespace oxturn

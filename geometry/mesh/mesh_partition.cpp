// Partitions that follow from the triangulation alone: convex and monotone parts, simple pieces.
#include <algorithm>
#include <set>

#include "base/disjoint_sets.hpp"
#include "geometry/mesh/mesh_parts.hpp"
#include "geometry/mesh/partition.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Half = MeshParts::Half;

/// Does the path a, v, b leave at most 180 degrees on its left at v? The angle consists of two convex ones, so it may
/// reach 360 degrees: then a and b lie on the same side.
bool convex_turn(const Point& a, const Point& v, const Point& b) {
  const int turn = orientation(a, v, b);
  return turn > 0 || (turn == 0 && on_segment(v, a, b));
}

/// Removes diagonals, in mesh order, whose two ends allow it: allowed(a, v, b) for the vertex v that would follow a and
/// precede b then.
template <class Allowed>
std::vector<Ring> without_needless_diagonals(const Region& region, Allowed allowed) {
  const Mesh mesh(region);
  MeshParts parts(mesh);
  for (Half h = 0; h < parts.half_edges(); ++h) {
    const Half t = parts.twin(h);
    if (t == MeshParts::kNone || t < h) continue;
    if (allowed(parts.start(parts.previous(h)), parts.start(h), parts.end(parts.next(t))) &&
        allowed(parts.start(parts.previous(t)), parts.start(t), parts.end(parts.next(h))))
      parts.remove(h);
  }
  return parts.rings();
}

/// Joins triangles to simple polygons, greedily.
class SimplePieces {
 public:
  explicit SimplePieces(const Region& region)
      : mesh_(region),
        parts_(mesh_),
        sets_(mesh_.triangles().size()),
        triangles_at_(mesh_.points().size()),
        vertices_of_(mesh_.triangles().size()) {
    for (std::size_t t = 0; t < mesh_.triangles().size(); ++t)
      for (const std::int32_t v : mesh_.triangles()[t].vertex) {
        triangles_at_[static_cast<std::size_t>(v)].push_back(t);
        vertices_of_[t].push_back(v);
      }
  }

  std::vector<Ring> run() {
    for (Half h = 0; h < parts_.half_edges(); ++h) {
      const Half t = parts_.twin(h);
      if (t != MeshParts::kNone && t > h) try_to_join(h, t);
    }
    return parts_.rings();
  }

 private:
  std::size_t piece_of(Half h) { return sets_.find(static_cast<std::size_t>(MeshParts::triangle(h))); }

  /// Joins the pieces on both sides of a diagonal if they share no vertex but its ends.
  void try_to_join(Half h, Half twin) {
    std::size_t small = piece_of(h), large = piece_of(twin);
    if (small == large) return;
    if (vertices_of_[small].size() > vertices_of_[large].size()) std::swap(small, large);
    const auto pair = std::minmax(small, large);
    if (refused_.count(pair) != 0) return;
    const auto is_end = [&](std::int32_t v) { return v == parts_.from(h) || v == parts_.to(h); };
    const auto shared = [&](std::int32_t v) {
      const auto& around = triangles_at_[static_cast<std::size_t>(v)];
      return !is_end(v) && std::ranges::any_of(around, [&](std::size_t t) { return sets_.find(t) == large; });
    };
    auto &mine = vertices_of_[small], &theirs = vertices_of_[large];
    if (std::ranges::any_of(mine, shared)) {
      refused_.insert(pair);
      return;
    }
    for (const std::int32_t v : mine)
      if (!is_end(v)) theirs.push_back(v);
    std::vector<std::int32_t>().swap(mine);
    sets_.unite(small, large);
    vertices_of_[sets_.find(large)].swap(theirs);
    parts_.remove(h);
  }

  const Mesh mesh_;
  MeshParts parts_;
  DisjointSets sets_;                                   // of triangles: the pieces
  std::vector<std::vector<std::size_t>> triangles_at_;  // by point of the mesh
  std::vector<std::vector<std::int32_t>> vertices_of_;  // by piece
  std::set<std::pair<std::size_t, std::size_t>> refused_;
};

}  // namespace

std::vector<Ring> convex_partition_approximate(const Region& region) {
  return without_needless_diagonals(region, convex_turn);
}

std::vector<Ring> monotone_partition(const Region& region) {
  // A part is monotone if no reflex vertex has both its neighbours above or both below; of equal heights the left is
  // below.
  const auto above = [](const Point& p, const Point& v) { return p.y() != v.y() ? p.y() > v.y() : p.x() > v.x(); };
  return without_needless_diagonals(region, [&](const Point& a, const Point& v, const Point& b) {
    return convex_turn(a, v, b) || above(a, v) != above(b, v);
  });
}

std::vector<Ring> simple_pieces(const Region& region) { return SimplePieces(region).run(); }

}  // namespace oxturn

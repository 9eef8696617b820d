// Partitions that follow from the triangulation alone: convex and monotone parts, bridged rings, simple pieces.
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
      return !is_end(v) &&
             std::any_of(around.begin(), around.end(), [&](std::size_t t) { return sets_.find(t) == large; });
    };
    auto &mine = vertices_of_[small], &theirs = vertices_of_[large];
    if (std::any_of(mine.begin(), mine.end(), shared)) {
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

/// A directed edge between points of the mesh.
struct Arc {
  std::int32_t from, to;
};

/// Turning clockwise about v from the direction of `start`, which of a and b comes first? Straight back to `start`
/// comes last.
bool comes_first(const Point& v, const Point& start, const Point& a, const Point& b) {
  const auto half = [&](const Point& w) {
    const int turn = orientation(v, start, w);
    if (turn < 0) return 0;
    if (turn > 0) return 2;
    return on_segment(v, start, w) ? 1 : 3;
  };
  const int ha = half(a), hb = half(b);
  return ha != hb ? ha < hb : orientation(v, b, a) > 0;
}

/// The walls of the mesh, and bridges between connected components of walls, shortest first, in both directions.
std::vector<Arc> walls_and_bridges(const Mesh& mesh) {
  struct Bridge {
    double length;
    std::int32_t a, b;
    bool operator<(const Bridge& o) const {
      return length != o.length ? length < o.length : a != o.a ? a < o.a : b < o.b;
    }
  };
  const MeshParts parts(mesh);
  std::vector<Arc> arcs;
  std::vector<Bridge> bridges;
  DisjointSets connected(mesh.points().size());
  const auto connect = [&](std::int32_t a, std::int32_t b) {
    return connected.unite(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  };
  for (Half h = 0; h < parts.half_edges(); ++h) {
    const std::int32_t a = parts.from(h), b = parts.to(h);
    if (parts.twin(h) == MeshParts::kNone) {
      arcs.push_back({a, b});
      connect(a, b);
    } else if (a < b) {
      bridges.push_back({distance(mesh.point(a), mesh.point(b)), a, b});
    }
  }
  std::sort(bridges.begin(), bridges.end());
  for (const Bridge& e : bridges) {
    if (!connect(e.a, e.b)) continue;
    arcs.push_back({e.a, e.b});
    arcs.push_back({e.b, e.a});
  }
  return arcs;
}

/// The faces to the left of the arcs: after u -> v comes the first arc clockwise from v -> u.
std::vector<Ring> faces_of(const Mesh& mesh, const std::vector<Arc>& arcs) {
  std::vector<std::vector<std::size_t>> arcs_from(mesh.points().size());
  for (std::size_t i = 0; i < arcs.size(); ++i) arcs_from[static_cast<std::size_t>(arcs[i].from)].push_back(i);
  const auto next = [&](const Arc& arc) {
    const std::vector<std::size_t>& choices = arcs_from[static_cast<std::size_t>(arc.to)];
    const Point &v = mesh.point(arc.to), &start = mesh.point(arc.from);
    std::size_t best = choices.front();
    for (const std::size_t k : choices)
      if (k != best && comes_first(v, start, mesh.point(arcs[k].to), mesh.point(arcs[best].to))) best = k;
    return best;
  };
  std::vector<Ring> rings;
  std::vector<bool> seen(arcs.size(), false);
  for (std::size_t first = 0; first < arcs.size(); ++first) {
    Ring ring;
    for (std::size_t i = first; !seen[i]; i = next(arcs[i])) {
      seen[i] = true;
      ring.push_back(mesh.point(arcs[i].from));
    }
    if (!ring.empty()) rings.push_back(std::move(ring));
  }
  return rings;
}

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

std::vector<Ring> bridged(const Region& region) {
  const Mesh mesh(region);
  return faces_of(mesh, walls_and_bridges(mesh));
}

}  // namespace oxturn

// What the triangulation alone gives: convex and monotone parts, bridged rings, simple pieces.
#include <algorithm>
#include <set>

#include "geometry/mesh/mesh_parts.hpp"
#include "geometry/mesh/partition.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Half = MeshParts::Half;

/// Does coming from a, passing v and going on to b leave at most 180 degrees on the left? The two angles that make
/// it up are convex each, so their sum may reach 360: then a and b lie on the same side.
bool convex_turn(const Point& a, const Point& v, const Point& b) {
  const int turn = orientation(a, v, b);
  return turn > 0 || (turn == 0 && on_segment(v, a, b));
}

class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::int32_t find(std::int32_t i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  /// The smaller number stays the name.
  bool unite(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    at(std::max(a, b)) = std::min(a, b);
    return true;
  }

 private:
  std::int32_t& at(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> parent_;
};

/// Half-edges of a planar graph; the face to the left of u -> v goes on with the first edge clockwise from v -> u.
struct Arc {
  std::int32_t from, to;
};

/// Turning clockwise about v from the direction of `start`, is a met before b? All exact.
bool met_first(const Point& v, const Point& start, const Point& a, const Point& b) {
  const auto half = [&](const Point& w) {
    const int turn = orientation(v, start, w);
    if (turn < 0) return 0;
    if (turn > 0) return 2;
    return on_segment(v, start, w) ? 1 : 3;  // straight on; or back where we came from: last
  };
  const int ha = half(a), hb = half(b);
  return ha != hb ? ha < hb : orientation(v, b, a) > 0;
}

/// Drops diagonals, in mesh order, whose two ends allow it: allowed(a, v, b) for the turn that v would get.
template <class Allowed>
std::vector<Ring> without_needless_diagonals(const Region& region, Allowed allowed) {
  const Mesh mesh(region);
  MeshParts parts(mesh);
  const auto start = [&](Half e) -> const Point& { return parts.point(parts.from(e)); };
  const auto end = [&](Half e) -> const Point& { return parts.point(parts.to(e)); };
  for (std::size_t i = 0; i < parts.halves(); ++i) {
    const auto h = static_cast<Half>(i);
    const Half t = parts.twin(h);
    if (t == Mesh::kWall || t < h) continue;
    if (allowed(start(parts.prev(h)), start(h), end(parts.next(t))) &&
        allowed(start(parts.prev(t)), start(t), end(parts.next(h)))) {
      parts.drop(h);
    }
  }
  return parts.rings();
}

}  // namespace

std::vector<Ring> convex_partition_approximate(const Region& region) {
  return without_needless_diagonals(region, convex_turn);
}

std::vector<Ring> monotone_partition(const Region& region) {
  // A part is monotone if no reflex corner has both its neighbours above or both below (level: left is below).
  const auto above = [](const Point& p, const Point& v) { return p.y() != v.y() ? p.y() > v.y() : p.x() > v.x(); };
  return without_needless_diagonals(region, [&](const Point& a, const Point& v, const Point& b) {
    return convex_turn(a, v, b) || above(a, v) != above(b, v);
  });
}

std::vector<Ring> simple_pieces(const Region& region) {
  const Mesh mesh(region);
  MeshParts parts(mesh);
  const auto count = mesh.triangles().size();
  std::vector<std::vector<std::int32_t>> around(mesh.points().size());  // triangles at a corner
  std::vector<std::vector<std::int32_t>> corners(count);                // of a part, by the set's name
  for (std::size_t t = 0; t < count; ++t) {
    for (const std::int32_t c : mesh.triangles()[t].vertex) {
      around[static_cast<std::size_t>(c)].push_back(static_cast<std::int32_t>(t));
      corners[t].push_back(c);
    }
  }
  Sets sets(count);
  std::set<std::pair<std::int32_t, std::int32_t>> refused;
  for (std::size_t i = 0; i < parts.halves(); ++i) {
    const auto h = static_cast<Half>(i);
    const Half t = parts.twin(h);
    if (t == Mesh::kWall || t < h) continue;
    std::int32_t small = sets.find(h / 3), large = sets.find(t / 3);
    if (small == large) continue;
    if (corners[static_cast<std::size_t>(small)].size() > corners[static_cast<std::size_t>(large)].size()) {
      std::swap(small, large);
    }
    const auto pair = std::minmax(small, large);
    if (refused.count(pair) != 0) continue;
    // The joined part is simple if the two share nothing but the diagonal's ends.
    auto& mine = corners[static_cast<std::size_t>(small)];
    auto& theirs = corners[static_cast<std::size_t>(large)];
    const auto shared = [&](std::int32_t c) {
      if (c == parts.from(h) || c == parts.to(h)) return false;
      const auto& at = around[static_cast<std::size_t>(c)];
      return std::any_of(at.begin(), at.end(), [&](std::int32_t k) { return sets.find(k) == large; });
    };
    if (std::any_of(mine.begin(), mine.end(), shared)) {
      refused.insert(pair);
      continue;
    }
    for (const std::int32_t c : mine) {
      if (c != parts.from(h) && c != parts.to(h)) theirs.push_back(c);
    }
    std::vector<std::int32_t>().swap(mine);
    sets.unite(small, large);
    const std::int32_t name = sets.find(large);
    if (name != large) corners[static_cast<std::size_t>(name)].swap(theirs);
    parts.drop(h);
  }
  return parts.rings();
}

std::vector<Ring> bridged(const Region& region) {
  const Mesh mesh(region);
  const MeshParts parts(mesh);
  std::vector<Arc> arcs;
  struct Bridge {
    double length;
    std::int32_t a, b;
    bool operator<(const Bridge& o) const {
      return length != o.length ? length < o.length : a != o.a ? a < o.a : b < o.b;
    }
  };
  std::vector<Bridge> bridges;
  Sets joined(mesh.points().size());
  for (std::size_t i = 0; i < parts.halves(); ++i) {
    const auto h = static_cast<Half>(i);
    const std::int32_t a = parts.from(h), b = parts.to(h);
    if (parts.twin(h) == Mesh::kWall) {
      arcs.push_back({a, b});
      joined.unite(a, b);
    } else if (a < b) {
      bridges.push_back({distance(parts.point(a), parts.point(b)), a, b});
    }
  }
  std::sort(bridges.begin(), bridges.end());
  for (const Bridge& e : bridges) {
    if (!joined.unite(e.a, e.b)) continue;
    arcs.push_back({e.a, e.b});
    arcs.push_back({e.b, e.a});
  }
  std::vector<std::vector<std::int32_t>> out_of(mesh.points().size());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    out_of[static_cast<std::size_t>(arcs[i].from)].push_back(static_cast<std::int32_t>(i));
  }
  std::vector<Ring> rings;
  std::vector<bool> seen(arcs.size(), false);
  for (std::size_t start = 0; start < arcs.size(); ++start) {
    Ring ring;
    for (std::size_t i = start; !seen[i];) {
      seen[i] = true;
      ring.push_back(parts.point(arcs[i].from));
      const Point& v = parts.point(arcs[i].to);
      const auto& ways = out_of[static_cast<std::size_t>(arcs[i].to)];
      std::int32_t best = ways.front();
      const auto end = [&](std::int32_t k) -> const Point& {
        return parts.point(arcs[static_cast<std::size_t>(k)].to);
      };
      for (const std::int32_t k : ways) {
        if (k != best && met_first(v, parts.point(arcs[i].from), end(k), end(best))) best = k;
      }
      i = static_cast<std::size_t>(best);
    }
    if (!ring.empty()) rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace oxturn

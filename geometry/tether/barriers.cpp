// Method      A gap between two different rings of one polygon is narrow if a disc of the given diameter cannot pass
//             it. (A narrow place between two parts of the same ring only leads into a pocket, which no shortest path
//             enters just to leave it again; and no path leads from polygon to polygon.) Of rings that are connected by
//             a chain of narrow gaps only a spanning tree needs barriers: a further gap leads into such a pocket, too.
//             The tree is the minimum one, by Kruskal over the closest pairs of rings.
//             The closest points of two disjoint rings include a vertex of one of them, so vertices against edges
//             suffice. Another ring may lie between a vertex and its nearest point. That does no harm: it divides the
//             segment into two shorter ones, whose gaps come first and connect both rings already.
// Source      Kruskal, "On the shortest spanning subtree of a graph", 1956
#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/tether/geodesic_field.hpp"

namespace oxturn {
namespace {

struct Gap {
  double width;
  Point from, to;
  std::uint32_t low, high;  // the rings, low < high
  auto rings() const { return std::tie(low, high); }
};

bool narrower(const Gap& a, const Gap& b) {
  if (a.width != b.width) return a.width < b.width;
  if (a.from != b.from) return before(a.from, b.from);
  if (a.to != b.to) return before(a.to, b.to);
  return a.rings() < b.rings();
}

/// The rings of a region, numbered in order.
struct Rings {
  std::vector<std::uint32_t> polygon_of;  // by ring
  std::vector<std::uint32_t> ring_of;     // by edge of an EdgeIndex

  explicit Rings(const Region& region) {
    for (std::uint32_t k = 0; k < region.polygons.size(); ++k)
      polygon_of.insert(polygon_of.end(), 1 + region.polygons[k].holes.size(), k);
    std::uint32_t number = 0;
    for_each_ring(region, [&](const Ring& ring) {
      for_each_edge(ring, [&](const Point& a, const Point& b) {
        if (a != b) ring_of.push_back(number);
      });
      ++number;
    });
  }
};

/// For every vertex the gap to each other ring of its polygon that is nearer than `width`.
std::vector<Gap> narrow_gaps(const Region& free, const Rings& rings, double width) {
  const EdgeIndex index(free);
  if (index.edges().size() != rings.ring_of.size())
    throw std::logic_error("barriers: the index has other edges than the rings");
  std::vector<Gap> found, nearest;
  for (std::size_t k = 0; k < index.edges().size(); ++k) {
    const Point& v = index.edges()[k].a;
    const std::uint32_t mine = rings.ring_of[k];
    Box box;
    box.add(v);
    box.grow(width);
    nearest.clear();
    index.for_each_near(box, [&](std::size_t e) {
      const std::uint32_t other = rings.ring_of[e];
      if (other == mine || rings.polygon_of[other] != rings.polygon_of[mine]) return;
      const Point to = nearest_on_segment(v, index.edges()[e].a, index.edges()[e].b);
      const Gap gap{distance(v, to), v, to, std::min(mine, other), std::max(mine, other)};
      if (gap.width < width) nearest.push_back(gap);
    });
    std::sort(nearest.begin(), nearest.end(), [](const Gap& a, const Gap& b) {
      return a.rings() != b.rings() ? a.rings() < b.rings() : narrower(a, b);
    });
    for (std::size_t i = 0; i < nearest.size(); ++i)
      if (i == 0 || nearest[i].rings() != nearest[i - 1].rings()) found.push_back(nearest[i]);
  }
  return found;
}

}  // namespace

std::vector<Polyline> barriers(const Region& free, double width) {
  if (!(width >= 0)) throw_invalid("width of gaps to close must be 0 or more metres");
  const Rings rings(free);
  std::vector<Gap> gaps = narrow_gaps(free, rings, width);
  std::sort(gaps.begin(), gaps.end(), narrower);
  DisjointSets connected(rings.polygon_of.size());
  std::vector<Polyline> out;
  for (const Gap& gap : gaps)
    if (connected.unite(gap.low, gap.high) && gap.width > 0) out.push_back({gap.from, gap.to});  // 0: they touch
  return out;
}

}  // namespace oxturn

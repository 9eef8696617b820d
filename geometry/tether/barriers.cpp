// Which gaps of free space to close so that no way leads where a disc cannot pass.
//
// Only gaps between different rings of one polygon matter: a narrow place between two parts of the same ring leads
// into a pocket, which no shortest way enters only to leave it again. (Nor do ways lead from polygon to polygon.)
// Rings that a chain of gaps joins need a tree of barriers, no more: what a further gap of the chain opens is such a
// pocket, too. The tree is a minimum spanning one (Kruskal) over the closest pairs of rings.
//
// The closest pair of two disjoint rings is always attained at a corner of one of them, so corners against edges
// suffice. Whether another ring lies between a corner and its nearest point need not be looked at: if so, both parts of
// the way are shorter, each joins a pair of rings by a gap that comes before this one, and both ends are joined by then.
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <tuple>

#include "geometry/edge_index.hpp"
#include "geometry/tether/geodesic_field.hpp"

namespace oxturn {
namespace {

struct Gap {
  double width;
  Point from, to;
  std::uint32_t low, high;  // rings
};

bool comes_before(const Gap& a, const Gap& b) {
  if (a.width != b.width) return a.width < b.width;
  if (a.from != b.from) return before(a.from, b.from);
  if (a.to != b.to) return before(a.to, b.to);
  return std::tie(a.low, a.high) < std::tie(b.low, b.high);
}

/// For every pair of rings of one polygon nearer than `width`: where they are nearest.
std::vector<Gap> gaps(const Region& free, double width) {
  std::vector<std::uint32_t> polygon_of, ring_of;  // of rings; of the index's edges
  std::uint32_t number = 0;
  for (const Polygon& p : free.polygons) { polygon_of.insert(polygon_of.end(), 1 + p.holes.size(), number++); }
  number = 0;
  for_each_ring(free, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (ring[i] != ring[i + 1 < ring.size() ? i + 1 : 0]) ring_of.push_back(number);
    }
    ++number;
  });
  const EdgeIndex index(free);
  if (index.edges().size() != ring_of.size()) throw std::logic_error("barriers: edges of the index are not the rings'");

  std::vector<Gap> found, nearest;
  for (std::size_t k = 0; k < index.edges().size(); ++k) {
    const Point& v = index.edges()[k].a;
    const std::uint32_t mine = ring_of[k];
    Box box;
    box.add(v);
    box.grow(width);
    nearest.clear();
    index.for_each_near(box, [&](std::size_t e) {
      const std::uint32_t other = ring_of[e];
      if (other == mine || polygon_of[other] != polygon_of[mine]) return;
      const Point to = nearest_on_segment(v, index.edges()[e].a, index.edges()[e].b);
      const Gap gap{distance(v, to), v, to, std::min(mine, other), std::max(mine, other)};
      if (gap.width < width) nearest.push_back(gap);
    });
    std::sort(nearest.begin(), nearest.end(), [](const Gap& a, const Gap& b) {
      return std::tie(a.low, a.high) != std::tie(b.low, b.high) ? std::tie(a.low, a.high) < std::tie(b.low, b.high)
                                                                : comes_before(a, b);
    });
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      if (i == 0 || std::tie(nearest[i].low, nearest[i].high) != std::tie(nearest[i - 1].low, nearest[i - 1].high))
        found.push_back(nearest[i]);
    }
  }
  return found;
}

}  // namespace

std::vector<Polyline> barriers(const Region& free, double width) {
  if (!(width >= 0)) throw std::invalid_argument("width of gaps to close must be 0 or more metres");
  std::vector<Gap> all = gaps(free, width);
  std::sort(all.begin(), all.end(), comes_before);
  std::vector<std::uint32_t> parent;
  for_each_ring(free, [&](const Ring&) { parent.push_back(static_cast<std::uint32_t>(parent.size())); });
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<Polyline> out;
  for (const Gap& gap : all) {
    const std::uint32_t a = root(gap.low), b = root(gap.high);
    if (a == b) continue;
    parent[std::max(a, b)] = std::min(a, b);
    if (gap.width > 0) out.push_back({gap.from, gap.to});  // else the rings touch
  }
  return out;
}

}  // namespace oxturn

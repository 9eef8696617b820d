// Method      A gap between two different rings of one polygon is narrow if a disc of the given diameter cannot pass
//             it. (A narrow place between two parts of the same ring only leads into a pocket, which no shortest path
//             enters just to leave it again; and no path leads from polygon to polygon.) Of rings that are connected by
//             a chain of narrow gaps only a spanning tree needs barriers: a further gap leads into such a pocket, too.
//             The tree is the minimum one, by Kruskal over the closest pairs of rings.
//             The closest points of two disjoint rings include a vertex of one of them, so vertices against edges
//             suffice. Another ring may lie between a vertex and its nearest point. That does no harm: it divides the
//             segment into two shorter ones, whose gaps come first and connect both rings already.
// Anchor      An anchor in a narrow gap could be on the wrong side of that gap's barrier, out of the robot's reach. So
//             its gap is closed first, through the anchor: the tether may then leave it on either side. The anchor is
//             in a gap if a line by it from its nearest ring to another one is shorter than the disc is wide. That line
//             may run along the wall for a while, so that an anchor beside the mouth of a gap is in it as well.
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

constexpr double kRounding = 5e-10;  // of the extent: Mesh takes points nearer than twice that for points of an edge

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
  std::vector<std::uint32_t> ring_of;     // by edge of an EdgeIndex, where the edges of a ring follow one another
  std::vector<std::size_t> first_edge;    // of each ring, and their number

  explicit Rings(const Region& region) {
    for (std::uint32_t k = 0; k < region.polygons.size(); ++k)
      polygon_of.insert(polygon_of.end(), 1 + region.polygons[k].holes.size(), k);
    std::uint32_t number = 0;
    for_each_ring(region, [&](const Ring& ring) {
      first_edge.push_back(ring_of.size());
      for_each_edge(ring, [&](const Point& a, const Point& b) {
        if (a != b) ring_of.push_back(number);
      });
      ++number;
    });
    first_edge.push_back(ring_of.size());
  }
  std::size_t edge_after(std::size_t edge) const {
    const std::uint32_t ring = ring_of[edge];
    return edge + 1 < first_edge[ring + 1] ? edge + 1 : first_edge[ring];
  }
  std::size_t edge_before(std::size_t edge) const {
    const std::uint32_t ring = ring_of[edge];
    return edge > first_edge[ring] ? edge - 1 : first_edge[ring + 1] - 1;
  }
};

/// The point of a ring nearest to some point.
struct NearRing {
  double distance;
  std::uint32_t ring;
  std::size_t edge;
  Point at;
};

class GapFinder {
 public:
  GapFinder(const Region& free, double width) : rings_(free), index_(free), width_(width) {
    const Box box = bounding_box(free);
    if (!box.empty()) rounding_ = kRounding * (box.size().norm() + 1e-3 * std::max(box.low.norm(), box.high.norm()));
    if (index_.edges().size() != rings_.ring_of.size())
      throw std::logic_error("barriers: the index has other edges than the rings");
  }
  std::size_t ring_count() const { return rings_.polygon_of.size(); }

  /// For every vertex the gap to each other ring of its polygon that is nearer than the width.
  std::vector<Gap> narrow_gaps() const {
    std::vector<Gap> found;
    for (std::size_t k = 0; k < index_.edges().size(); ++k) {
      const Point& v = index_.edges()[k].a;
      const std::uint32_t mine = rings_.ring_of[k];
      for (const NearRing& other : rings_near(v))
        if (other.ring != mine && same_polygon(other.ring, mine))
          found.push_back({other.distance, v, other.at, std::min(mine, other.ring), std::max(mine, other.ring)});
    }
    return found;
  }

  /// Barriers through `anchor` across the gaps in which it lies: from the nearest ring by the anchor to another ring,
  /// shortest first.
  void close_through(const Point& anchor, DisjointSets& connected, std::vector<Polyline>& out) const {
    const std::vector<NearRing> near = rings_near(anchor);
    if (near.empty()) return;
    const NearRing& first = *std::min_element(
        near.begin(), near.end(), [](const NearRing& a, const NearRing& b) { return a.distance < b.distance; });
    const bool inside = index_.contains(anchor), on_wall = first.distance <= rounding_ || !inside;
    Point at = inside ? anchor : first.at;
    for (const Point& v : {index_.edges()[first.edge].a, index_.edges()[first.edge].b})
      if (distance(v, at) <= rounding_) at = v;
    std::vector<Crossing> crossings;
    for_each_path_along(first, at, [&](const Polyline& path, double length) {
      for (const NearRing& other : rings_near(path.back()))
        if (other.ring != first.ring && other.distance > rounding_ && same_polygon(first.ring, other.ring) &&
            first.distance + length + other.distance < width_ && is_open(path.back(), other.at))
          crossings.push_back({length + other.distance, other.ring, appended(path, other.at)});
    });
    std::stable_sort(crossings.begin(), crossings.end(),
                     [](const Crossing& a, const Crossing& b) { return a.length < b.length; });
    for (Crossing& crossing : crossings) {
      if (!connected.unite(first.ring, crossing.ring)) continue;
      if (!on_wall) crossing.line.insert(crossing.line.begin(), first.at);
      out.push_back(std::move(crossing.line));
    }
  }

 private:
  /// A line from the anchor to another ring.
  struct Crossing {
    double length;
    std::uint32_t ring;
    Polyline line;
  };

  bool same_polygon(std::uint32_t a, std::uint32_t b) const { return rings_.polygon_of[a] == rings_.polygon_of[b]; }
  static Polyline appended(Polyline line, const Point& p) {
    line.push_back(p);
    return line;
  }
  /// Is there free space between a and b, points on or near the boundary?
  bool is_open(const Point& a, const Point& b) const {
    constexpr double kEnds = 1e-9;  // their share of the segment, where they may be outside by rounding
    return index_.contains(lerp(a, b, kEnds), lerp(a, b, 1 - kEnds));
  }
  /// Calls f(path, length) for {at}, a point on or beside the ring, and for paths shorter than the width from there to
  /// vertices of the ring on either side: straight where the vertex is in sight, else along the wall.
  template <class F>
  void for_each_path_along(const NearRing& ring, const Point& at, F f) const {
    f(Polyline{at}, 0.0);
    for (const bool ahead : {true, false}) {
      Polyline path{at};
      double length = 0;
      std::size_t edge = ring.edge;
      do {
        const Point& v = ahead ? index_.edges()[edge].b : index_.edges()[edge].a;
        edge = ahead ? rings_.edge_after(edge) : rings_.edge_before(edge);
        if (v == path.back()) continue;
        if (is_open(at, v)) {
          path = {at};
          length = 0;
        }
        length += oxturn::distance(path.back(), v);
        path.push_back(v);
        if (length < width_) f(path, length);
      } while (length < width_ && edge != ring.edge);
    }
  }
  /// The rings nearer to p than the width, ascending.
  std::vector<NearRing> rings_near(const Point& p) const {
    std::vector<NearRing> near;
    Box box;
    box.add(p);
    box.grow(width_);
    index_.for_each_near(box, [&](std::size_t e) {
      const Point at = nearest_on_segment(p, index_.edges()[e].a, index_.edges()[e].b);
      if (const double d = distance(p, at); d < width_) near.push_back({d, rings_.ring_of[e], e, at});
    });
    std::sort(near.begin(), near.end(), [](const NearRing& a, const NearRing& b) {
      return a.ring != b.ring           ? a.ring < b.ring
             : a.distance != b.distance ? a.distance < b.distance
                                        : before(a.at, b.at);
    });
    near.erase(
        std::unique(near.begin(), near.end(), [](const NearRing& a, const NearRing& b) { return a.ring == b.ring; }),
        near.end());
    return near;
  }

  const Rings rings_;
  const EdgeIndex index_;
  const double width_;
  double rounding_ = 0;
};

}  // namespace

std::vector<Polyline> barriers(const Region& free, double width, const std::optional<Point>& anchor) {
  if (!(width >= 0)) throw_invalid("width of gaps to close must be 0 or more metres");
  const GapFinder finder(free, width);
  std::vector<Gap> gaps = finder.narrow_gaps();
  std::sort(gaps.begin(), gaps.end(), narrower);
  DisjointSets connected(finder.ring_count());
  std::vector<Polyline> out;
  if (anchor) finder.close_through(*anchor, connected, out);
  for (const Gap& gap : gaps)
    if (connected.unite(gap.low, gap.high) && gap.width > 0) out.push_back({gap.from, gap.to});  // 0: they touch
  return out;
}

}  // namespace oxturn

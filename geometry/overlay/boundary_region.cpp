// A boundary as rings, and rings as polygons with holes.
//
// Method      At the head of an edge, the next edge of the same boundary component bounds the same wedge of the inside:
//             clockwise from the way back. Following it gives closed cycles, one for each side of a connected face. A
//             cycle that visits a vertex twice is cut there into loops. All loops of one cycle bound the same polygon:
//             its outer ring is the loop that runs counter-clockwise, if there is one; otherwise the cycle is a set of
//             holes, and its polygon is that of the edge next below its lowest point.
#include <algorithm>
#include <stdexcept>

#include "geometry/overlay/arrangement.hpp"
#include "geometry/overlay/edge_below.hpp"
#include "geometry/overlay/half_edges.hpp"
#include "geometry/overlay/straight_vertices.hpp"

namespace oxturn {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

struct Loop {
  std::vector<LatticePoint> points;
  std::uint32_t cycle;
};

class RingBuilder {
 public:
  explicit RingBuilder(const std::vector<BoundaryEdge>& boundary)
      : boundary_(boundary),
        fans_(boundary.size(), [&](std::uint32_t e) { return std::pair(boundary[e].from, boundary[e].to); }),
        cycle_of_(boundary.size(), kNone),
        position_(fans_.vertices(), kNone) {
    for (std::uint32_t first = 0; first < boundary_.size(); ++first)
      if (cycle_of_[first] == kNone) walk_cycle(first);
  }

  Region region(const Lattice& lattice) const {
    Region region;
    std::vector<std::uint32_t> polygon_of(lowest_.size(), kNone);  // by cycle
    std::vector<const Loop*> holes;
    for (const Loop& loop : loops_) {
      if (area_sign(loop.points) < 0) {
        holes.push_back(&loop);
        continue;
      }
      polygon_of[loop.cycle] = static_cast<std::uint32_t>(region.polygons.size());
      region.polygons.push_back({canonical_ring(loop.points, lattice), {}});
    }
    if (!holes.empty()) nest(polygon_of);
    for (const Loop* hole : holes)
      region.polygons[polygon_of[hole->cycle]].holes.push_back(canonical_ring(hole->points, lattice));
    put_in_order(region);
    return region;
  }

 private:
  static double area_sign(const std::vector<LatticePoint>& ring) {
    double sum = 0;
    for (std::size_t i = 2; i < ring.size(); ++i) sum += static_cast<double>(twice_area(ring[0], ring[i - 1], ring[i]));
    return sum;
  }

  std::uint32_t next(std::uint32_t edge) const {
    const HalfEdge back = HalfEdge::backward(edge);
    const auto fan = fans_.at(fans_.tail(back));
    const std::size_t at = fans_.position(back);
    return fan[(at == 0 ? fan.size() : at) - 1].edge();
  }

  /// Follows the cycle of an edge and cuts off a loop wherever it comes back to a vertex.
  void walk_cycle(std::uint32_t first) {
    const auto cycle = static_cast<std::uint32_t>(lowest_.size());
    lowest_.push_back(boundary_[first].from);
    walked_.clear();
    std::uint32_t e = first;
    do {
      cycle_of_[e] = cycle;
      lowest_.back() = std::min(lowest_.back(), boundary_[e].from);
      position_[fans_.tail(HalfEdge::forward(e))] = static_cast<std::uint32_t>(walked_.size());
      walked_.push_back(e);
      const std::uint32_t at = position_[fans_.head(HalfEdge::forward(e))];
      if (at != kNone) cut_loop(at, cycle);
      e = next(e);
    } while (e != first);
  }

  /// The edges walked from position `begin` on have come back to where they began.
  void cut_loop(std::size_t begin, std::uint32_t cycle) {
    Loop loop{{}, cycle};
    loop.points.reserve(walked_.size() - begin);
    for (std::size_t k = begin; k < walked_.size(); ++k) {
      loop.points.push_back(boundary_[walked_[k]].from);
      position_[fans_.tail(HalfEdge::forward(walked_[k]))] = kNone;
    }
    walked_.resize(begin);
    loops_.push_back(std::move(loop));
  }

  /// Finds the polygons of the cycles that have no outer ring of their own.
  void nest(std::vector<std::uint32_t>& polygon_of) const {
    FewEdgesBelow below(boundary_.size(), [this](std::uint32_t e) {
      const auto [low, high] = std::minmax(boundary_[e].from, boundary_[e].to);
      return std::pair(low, high);
    });
    std::vector<std::uint32_t> order(lowest_.size());
    for (std::uint32_t c = 0; c < order.size(); ++c) order[c] = c;
    std::ranges::sort(order, [&](std::uint32_t c, std::uint32_t d) { return lowest_[c] < lowest_[d]; });
    for (const std::uint32_t c : order) {
      if (polygon_of[c] != kNone) continue;
      const std::uint32_t e = below.below(lowest_[c]);
      if (e == EdgeBelow::kNone) throw std::logic_error("overlay left a hole without a polygon");
      polygon_of[c] = polygon_of[cycle_of_[e]];
    }
  }

  const std::vector<BoundaryEdge>& boundary_;
  VertexFans fans_;
  std::vector<Loop> loops_;
  std::vector<std::uint32_t> cycle_of_;  // by edge
  std::vector<LatticePoint> lowest_;     // by cycle: its first point by x, then y
  std::vector<std::uint32_t> position_;  // by vertex: where on walked_ it was left, or kNone
  std::vector<std::uint32_t> walked_;    // edges of the present cycle that are in no loop yet
};

}  // namespace

Ring canonical_ring(const std::vector<LatticePoint>& ring, const Lattice& lattice) {
  std::vector<LatticePoint> points = without_straight_vertices(
      ring,
      [](const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) { return twice_area(a, b, c) == 0; });
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  Ring out;
  out.reserve(points.size());
  for (const LatticePoint& p : points) out.push_back(lattice.point(p));
  return out;
}

void put_in_order(Region& region) {
  const auto by_vertices = [](const Ring& r, const Ring& s) {
    return std::lexicographical_compare(r.begin(), r.end(), s.begin(), s.end(), before);
  };
  for (Polygon& p : region.polygons) std::ranges::sort(p.holes, by_vertices);
  std::ranges::sort(region.polygons, [&](const Polygon& p, const Polygon& q) { return by_vertices(p.outer, q.outer); });
}

Region to_region(const std::vector<BoundaryEdge>& boundary, const Lattice& lattice) {
  return RingBuilder(boundary).region(lattice);
}

}  // namespace oxturn

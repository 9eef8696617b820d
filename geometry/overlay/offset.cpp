// Method      Each ring is followed at distance `reach` on one side: edges are shifted, convex vertices (seen from that
//             side) get an arc, concave ones a detour over the vertex itself. The winding number of all these curves
//             together is that of the region plus (dilation) or minus (erosion) the number of strips (edge x reach) and
//             sectors (about a vertex) that contain the point. So "above zero" is the exact answer, whatever overlaps.
//             Straight walls are shifted exactly; only arcs have a chord error.
//
//             Along a fine concave arc, such as an earlier offset leaves, n strips would cross n^2 times. Dilation
//             writes concave chains down as single polygons where it can (concave_chain.hpp). Clusters of short strips
//             that are left are united by halves and enter the overlay as one operand.
// Source      McMains and Chen, "Polygon offsetting by computing winding numbers", 2005.
// Complexity  n vertices: O(n) for the curves (O(k^2) for a concave chain of k <= 64 edges), O(m log m) for clusters of
//             m strips, and the overlay of the resulting O(n) edges.
// Decisions   1. Erosion does not use concave chains: configuration spaces, and with them all paths, would change in
//                the last bits.
#include "geometry/overlay/offset.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/overlay/arrangement.hpp"
#include "geometry/overlay/concave_chain.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostStripsOfCluster = 32, kMostChainsOfCluster = 16;
constexpr std::size_t kLeastCluster = 4;  // fewer are left to the overlay
constexpr double kFarApart = 0.25;        // of the reach: a longer strip or chain joins no cluster

enum class Direction { outwards, inwards };
enum class Arcs {
  chords,    // the curve comes nearer to the ring than the radius
  tangents,  // the curve keeps at least the radius
};

/// Offset curves of rings. Lengths are in quanta.
class OffsetCurve {
 public:
  /// `unit`: the operand of the overlay.
  OffsetCurve(double reach, double half_step, Direction direction, Arcs arcs, Windings unit)
      : reach_(reach),
        half_step_(half_step),
        side_(direction == Direction::outwards ? -1 : 1),
        direction_(direction),
        arcs_(arcs),
        unit_(unit) {}

  /// Adds the curve of a ring to an overlay.
  void add(const std::vector<LatticePoint>& ring, std::vector<OverlayEdge>& edges) const {
    std::vector<LatticePoint> curve;
    if (ring.size() == 1) {
      add_arc(curve, ring[0], {1, 0}, kPi);
      add_arc(curve, ring[0], {-1, 0}, kPi);
      return add_ring(edges, curve, unit_);
    }
    const Walk walk(ring, side_);
    const std::vector<Detour> detours = detours_of(walk, edges);
    auto detour = detours.begin();
    bool after_detour = false;
    for (std::size_t i = 0; i < ring.size();) {
      const bool before_detour = detour != detours.end() && detour->begin == i;
      const std::size_t last = walk.before(i);
      const double bend = walk.bend[i], ahead = walk.along[last].dot(walk.along[i]);
      const bool detour_here = after_detour || before_detour;
      const double turn = detour_here || bend > 0 ? 0 : bend < 0 ? math::atan2(-bend, ahead) : ahead < 0 ? kPi : 0;
      if (turn > 0 && arcs_ == Arcs::tangents) {  // the shifted edges are its first and last tangents
        add_arc(curve, ring[i++], walk.normal(last), turn);
        continue;
      }
      if (!after_detour) curve.push_back(moved(ring[i], reach_ * walk.normal(last)));
      if (detour_here || bend > 0)
        curve.push_back(ring[i]);
      else if (turn > 0)
        add_arc(curve, ring[i], walk.normal(last), turn);
      after_detour = before_detour;
      if (before_detour) {
        curve.insert(curve.end(), detour->between.begin(), detour->between.end());
        i = detour++->end;  // never past the ring's last edge
      } else {
        curve.push_back(moved(ring[i], reach_ * walk.normal(i)));
        ++i;
      }
    }
    add_ring(edges, curve, unit_);
  }

 private:
  /// How the curve gets from vertex `begin` to vertex `end`, both concave.
  struct Detour {
    std::size_t begin, end;
    std::vector<LatticePoint> between;
  };

  static LatticePoint moved(const LatticePoint& p, const Point& by) { return rounded(p.x + by.x(), p.y + by.y()); }
  int steps_of(double angle) const { return std::max(1, static_cast<int>(std::ceil(angle / (2 * half_step_) - 1e-9))); }
  /// The points of an arc between its two ends; `from` is the direction of its first end.
  void add_arc(std::vector<LatticePoint>& out, const LatticePoint& centre, const Point& from, double angle) const {
    const int steps = steps_of(angle);
    const double half = angle / steps / 2;
    if (arcs_ == Arcs::tangents) {
      const double radius = reach_ / math::cos(half);
      for (int k = 0; k < steps; ++k) out.push_back(moved(centre, radius * rotated(from, -side_ * (2 * k + 1) * half)));
    } else {
      for (int k = 1; k < steps; ++k) out.push_back(moved(centre, reach_ * rotated(from, -side_ * 2 * k * half)));
    }
  }

  /// Detours for all edges with two concave ends. Clusters are added to `edges`.
  std::vector<Detour> detours_of(const Walk& walk, std::vector<OverlayEdge>& edges) const {
    std::vector<Detour> out;
    for (std::size_t i = 0; i + 1 < walk.ring.size(); ++i) {
      std::size_t end = i;
      while (end + 1 < walk.ring.size() && walk.bend[end] > 0 && walk.bend[end + 1] > 0) ++end;
      add_detours(walk, i, end, out, edges);
      i = std::max(i, end);
    }
    return out;
  }
  void add_detours(const Walk& walk, std::size_t begin, std::size_t end, std::vector<Detour>& out,
                   std::vector<OverlayEdge>& edges) const {
    const bool chains = direction_ == Direction::outwards;
    const std::size_t most = chains ? kMostChainsOfCluster : kMostStripsOfCluster;
    std::vector<Detour> cluster;
    while (begin < end) {
      Detour d = chains ? chain(walk, begin, end) : strip(walk, begin);
      begin = d.end;
      const bool alone = chains && far_apart(walk.ring[d.begin], walk.ring[d.end]);
      if (alone || cluster.size() == most) close_cluster(walk, cluster, out, edges);
      (alone ? out : cluster).push_back(std::move(d));
    }
    close_cluster(walk, cluster, out, edges);
  }
  /// Moves a cluster's detours to `out`. If they are many, their union becomes an operand of the overlay instead, and
  /// the curve follows the ring itself.
  void close_cluster(const Walk& walk, std::vector<Detour>& cluster, std::vector<Detour>& out,
                     std::vector<OverlayEdge>& edges) const {
    if (cluster.size() >= kLeastCluster) {
      std::vector<std::vector<LatticePoint>> polygons;
      polygons.reserve(cluster.size());
      for (const Detour& d : cluster) polygons.push_back(closed(walk.ring, d));
      const Windings weight = direction_ == Direction::outwards ? unit_ : Windings{} - unit_;
      add_boundary(edges, united(polygons, 0, polygons.size()), weight);
      const std::size_t first = cluster.front().begin, last = cluster.back().end;
      cluster.assign(1, {first, last, std::vector<LatticePoint>(&walk.ring[first + 1], &walk.ring[last])});
    }
    out.insert(out.end(), cluster.begin(), cluster.end());
    cluster.clear();
  }

  Detour strip(const Walk& walk, std::size_t edge) const {
    const Point by = reach_ * walk.normal(edge);
    return {edge, edge + 1, {moved(walk.ring[edge], by), moved(walk.ring[edge + 1], by)}};
  }
  Detour chain(const Walk& walk, std::size_t begin, std::size_t limit) const {
    const ConcaveChain chain = longest_concave_chain(walk, begin, limit, reach_);
    if (chain.end == begin + 1) return strip(walk, begin);
    std::vector<LatticePoint> far;
    for (const Point& p : chain.far) far.push_back(rounded(p.x(), p.y()));
    far.erase(std::unique(far.begin(), far.end()), far.end());
    return {begin, chain.end, straightened_line(far)};
  }
  bool far_apart(const LatticePoint& a, const LatticePoint& b) const {
    return math::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y) > kFarApart * reach_;
  }
  /// The polygon between the ring and a detour, counter-clockwise.
  std::vector<LatticePoint> closed(const std::vector<LatticePoint>& ring, const Detour& d) const {
    std::vector<LatticePoint> out(&ring[d.begin], &ring[d.end] + 1);
    out.insert(out.end(), d.between.rbegin(), d.between.rend());
    if (direction_ == Direction::outwards) std::reverse(out.begin(), out.end());
    return out;
  }
  /// The boundary of the union of polygons begin .. end - 1.
  static std::vector<BoundaryEdge> united(const std::vector<std::vector<LatticePoint>>& polygons, std::size_t begin,
                                          std::size_t end) {
    std::vector<OverlayEdge> edges;
    if (end - begin <= 2) {
      for (std::size_t k = begin; k < end; ++k) add_ring(edges, polygons[k], {1, 0});
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      add_boundary(edges, united(polygons, begin, middle), {1, 0});
      add_boundary(edges, united(polygons, middle, end), {1, 0});
    }
    return boundary_of(std::move(edges), inside_first);
  }

  double reach_, half_step_, side_;  // side: +1 left of the ring, -1 right
  Direction direction_;
  Arcs arcs_;
  Windings unit_;
};

/// An offset on a lattice. Lengths in quanta.
struct Resolution {
  Resolution(double radius, double chord_error, Arcs arcs, const Lattice& lattice)
      : reach(radius / lattice.quantum() + (arcs == Arcs::tangents ? kOffsetSlack : -kOffsetSlack)),
        error(std::max(chord_error / lattice.quantum(), 1.0)) {}
  /// Half of the angle of a chord or tangent at most; reach above 0.
  double half_step() const { return std::min(math::acos(reach / (reach + error)), kPi / 4); }

  double reach, error;
};

/// About as many edges as the offset curves have at least: the arcs of a ring that is followed on its outside turn once
/// around. A list of millions that grows by itself takes twice the memory.
std::size_t least_edges(const Region& region, double half_step, Direction direction) {
  std::size_t round = 0;
  for (const Polygon& p : region.polygons) round += direction == Direction::inwards ? p.holes.size() : 1;
  return 2 * vertex_count(region) + round * static_cast<std::size_t>(kPi / half_step);
}

/// Adds the offset curves of a region to an overlay, as one operand. False if the lattice does not resolve the radius.
bool add_offset(std::vector<OverlayEdge>& edges, const Region& region, const Lattice& lattice, double radius,
                double chord_error, Direction direction, Arcs arcs, Windings unit) {
  const Resolution resolution(radius, chord_error, arcs, lattice);
  if (resolution.reach <= 0) return false;  // chords
  const OffsetCurve curve(resolution.reach, resolution.half_step(), direction, arcs, unit);
  edges.reserve(edges.size() + least_edges(region, resolution.half_step(), direction));
  for_each_snapped_ring(region, lattice, [&](const std::vector<LatticePoint>& ring, RingKind) {
    curve.add(direction == Direction::outwards ? straightened_ring(ring) : ring, edges);
  });
  return true;
}

void check_offset(double radius, double chord_error) {
  if (!(radius >= 0) || !std::isfinite(radius))
    throw_invalid("offset radius is {}, expected a length of 0 or more", radius);
  if (!(chord_error > 0)) throw_invalid("chord error is {}, expected a length above 0", chord_error);
}

Lattice lattice_for(Box box, double radius) {
  box.grow(radius * 1.5);
  return Lattice(box);
}

Region offset(const Region& region, double radius, double chord_error, Direction direction, Arcs arcs) {
  check_offset(radius, chord_error);
  const Box box = finite_box(region);
  if (radius == 0 || box.empty()) return region;
  const Lattice lattice = lattice_for(box, radius);
  std::vector<OverlayEdge> edges;
  if (!add_offset(edges, region, lattice, radius, chord_error, direction, arcs, {1, 0})) return region;
  return to_region(boundary_of(std::move(edges), inside_first), lattice);
}

}  // namespace

Region dilate(const Region& region, double radius, double chord_error, Bound bound) {
  return offset(region, radius, chord_error, Direction::outwards,
                bound == Bound::outside ? Arcs::tangents : Arcs::chords);
}

double dilation_shortfall(const Region& region, double radius, double chord_error) {
  check_offset(radius, chord_error);
  const Box box = finite_box(region);
  if (radius == 0 || box.empty()) return 0;
  const Lattice lattice = lattice_for(box, radius);
  const Resolution resolution(radius, chord_error, Arcs::chords, lattice);
  const double angles = convex_turning(region), boundary = perimeter(region) + angles * radius;
  if (resolution.reach <= 0) return boundary * radius;
  // The segment of an angle a is r^2 (a - sin a) / 2, at most r^2 a^3 / 12. Roundings are less than the slack.
  const double half = resolution.half_step(), segments = angles * radius * radius * half * half / 3;
  return segments + boundary * 2 * kOffsetSlack * lattice.quantum();
}

double convex_turning(const Region& region) {
  double sum = 0;
  for_each_ring(region, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
      if (orientation(a, b, c) > 0) sum += math::atan2(std::abs(cross(b - a, c - b)), (b - a).dot(c - b));
    }
  });
  return sum;
}

Region erode(const Region& region, double radius, double chord_error, Bound bound) {
  return offset(region, radius, chord_error, Direction::inwards,
                bound == Bound::inside ? Arcs::tangents : Arcs::chords);
}

Region between_offsets(const Region& outer, const Region& inner, double radius, double chord_error) {
  if (!(radius > 0)) throw_invalid("offset radius is {}, expected a length above 0", radius);
  check_offset(radius, chord_error);
  Box box = finite_box(outer);
  box.add(finite_box(inner));
  if (box.empty()) return {};
  const Lattice lattice = lattice_for(box, radius);
  std::vector<OverlayEdge> edges;
  add_offset(edges, outer, lattice, radius, chord_error, Direction::inwards, Arcs::tangents, {1, 0});
  add_offset(edges, inner, lattice, radius, chord_error, Direction::outwards, Arcs::tangents, {0, 1});
  return to_region(boundary_of(std::move(edges), inside_first_only), lattice);
}

}  // namespace oxturn

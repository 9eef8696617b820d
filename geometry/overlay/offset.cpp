// Each ring is run round at distance `reach` on one side: edges shifted, an arc about each corner that sticks out,
// a detour over the corner itself where it does not. The winding number of all these curves together is that of
// the region plus (dilate) or minus (erode) the number of strips and sectors that cover a point, so "above zero" is
// the answer exactly, for whatever overlaps. Walls are shifted exactly; only arcs carry the chord error.
//
// Along a fine dent (the arc an earlier offset left) n strips would cross n^2 times. Growing, a dent is written down as
// one polygon of a few edges where that can be done (dent.hpp), and crowds of short strips that are left are united by
// halves first and enter as one. Shrinking, all dents are united by halves: paths hang on the last bits of configuration
// space, so those were left as they are.
//
// Complexity  n corners: O(n) for the curves (O(k^2) for a dent of k <= 64 edges), O(m log m) for crowds of m strips, and
//             the overlay (arrangement.hpp) of what comes to O(n) edges and k crossings.
// Source      McMains, Chen: Polygon offsetting by computing winding numbers, 2005.
#include "geometry/overlay/offset.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/overlay/arrangement.hpp"
#include "geometry/overlay/concave_chain.hpp"

namespace oxturn {
namespace {

// Corners and offset points are rounded (0.7 quanta each), intersections too, and edges bend by half a quantum, in
// each of up to five unions of halves (four where rings and dents are straightened, by a quantum each) and the last
// overlay: this many quanta cover the sum and keep bounds certain.
constexpr double kSlack = 10;
constexpr std::size_t kLargestCrowd = 32, kLargestCrowdOfChains = 16;
constexpr std::size_t kLeastCrowd = 4;

bool positive(int winding, int) { return winding > 0; }

/// One ring's raw offset curve, in lattice units.
class Runner {
 public:
  /// side: +1 left of the ring, -1 right. circumscribed: arcs by tangents, otherwise by chords. trimmed: dents are
  /// written down (dent.hpp) where that can be done.
  Runner(double reach, double half_step, double side, bool circumscribed, bool trimmed)
      : reach_(reach), half_step_(half_step), side_(side), circumscribed_(circumscribed), trimmed_(trimmed) {}

  /// Adds the curve to an overlay.
  void run(const std::vector<Site>& ring, std::vector<OverlayEdge>& edges) const {
    std::vector<Site> out;
    const std::size_t n = ring.size();
    if (n == 1) {
      arc(out, ring[0], {1, 0}, kPi);
      arc(out, ring[0], {-1, 0}, kPi);
      return add_ring(edges, out, 1, 0);
    }
    const Walk walk(ring, side_);
    const std::vector<Detour> detours = detours_of(walk, edges);
    auto detour = detours.begin();
    bool from_detour = false;
    for (std::size_t i = 0; i < n;) {
      const std::size_t last = walk.before(i);
      const bool to_detour = detour != detours.end() && detour->begin == i;
      const double bend = walk.bend[i], ahead = walk.along[last].dot(walk.along[i]);
      const Point from = walk.inwards(last), to = walk.inwards(i);
      if (!from_detour) out.push_back(at(ring[i], reach_ * from));
      if (from_detour || to_detour || bend > 0)
        out.push_back(ring[i]);
      else if (bend < 0 || ahead < 0)
        arc(out, ring[i], from, bend < 0 ? std::atan2(-bend, ahead) : kPi);
      from_detour = to_detour;
      if (to_detour) {
        out.insert(out.end(), detour->between.begin(), detour->between.end());
        i = detour++->end;  // before the ring's last edge
      } else {
        out.push_back(at(ring[i++], reach_ * to));
      }
    }
    add_ring(edges, out, 1, 0);
  }

 private:
  /// How the curve gets from corner `begin` to corner `end`, both bent inwards.
  struct Detour {
    std::size_t begin, end;
    std::vector<Site> between;
  };

  static Site rounded(double x, double y) {
    return {static_cast<std::int32_t>(std::floor(x + 0.5)), static_cast<std::int32_t>(std::floor(y + 0.5))};
  }
  static Site at(const Site& s, const Point& shift) { return rounded(s.x + shift.x(), s.y + shift.y()); }
  /// The arc's points between its two ends.
  void arc(std::vector<Site>& out, const Site& centre, const Point& from, double angle) const {
    const int steps = std::max(1, static_cast<int>(std::ceil(angle / (2 * half_step_) - 1e-9)));
    const double half = angle / steps / 2;
    if (circumscribed_) {
      const double radius = reach_ / std::cos(half);
      for (int k = 0; k < steps; ++k) out.push_back(at(centre, radius * rotated(from, -side_ * (2 * k + 1) * half)));
    } else {
      for (int k = 1; k < steps; ++k) out.push_back(at(centre, reach_ * rotated(from, -side_ * 2 * k * half)));
    }
  }

  /// All edges whose two ends bend inwards, in detours; `edges` gets what crowds of them cover.
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
    std::vector<Detour> crowd;
    const auto add_crowd = [&] {
      if (crowd.size() >= kLeastCrowd) {
        std::vector<std::vector<Site>> parts;
        for (const Detour& d : crowd) parts.push_back(closed(walk.ring, d));
        add_boundary(edges, united(parts, 0, parts.size()), side_ < 0 ? 1 : -1, 0);
        const std::size_t first = crowd.front().begin, last = crowd.back().end;
        crowd.assign(1, {first, last, std::vector<Site>(&walk.ring[first + 1], &walk.ring[last])});
      }
      out.insert(out.end(), crowd.begin(), crowd.end());
      crowd.clear();
    };
    while (begin < end) {
      Detour d = trimmed_ ? dent(walk, begin, end) : strip(walk, begin);
      begin = d.end;
      const bool apart = trimmed_ && far_apart(walk.ring[d.begin], walk.ring[d.end]);
      if (apart || crowd.size() == (trimmed_ ? kLargestCrowdOfChains : kLargestCrowd)) add_crowd();
      (apart ? out : crowd).push_back(std::move(d));
    }
    add_crowd();
  }

  Detour strip(const Walk& walk, std::size_t k) const {
    const Point shift = reach_ * walk.inwards(k);
    return {k, k + 1, {at(walk.ring[k], shift), at(walk.ring[k + 1], shift)}};
  }
  Detour dent(const Walk& walk, std::size_t begin, std::size_t limit) const {
    const ConcaveChain dent = longest_concave_chain(walk, begin, limit, reach_);
    if (dent.end == begin + 1) return strip(walk, begin);
    Detour out{begin, dent.end, {}};
    for (const Point& p : dent.far) out.between.push_back(rounded(p.x(), p.y()));
    out.between.erase(std::unique(out.between.begin(), out.between.end()), out.between.end());
    out.between = straightened(out.between, false);
    return out;
  }
  bool far_apart(const Site& a, const Site& b) const {
    return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y) > reach_ / 4;
  }

  std::vector<Site> closed(const std::vector<Site>& ring, const Detour& d) const {
    std::vector<Site> out(&ring[d.begin], &ring[d.end] + 1);
    out.insert(out.end(), d.between.rbegin(), d.between.rend());
    if (side_ < 0) std::reverse(out.begin(), out.end());
    return out;
  }

  static std::vector<BoundaryEdge> united(const std::vector<std::vector<Site>>& parts, std::size_t begin, std::size_t end) {
    std::vector<OverlayEdge> edges;
    if (end - begin <= 2) {
      for (std::size_t k = begin; k < end; ++k) add_ring(edges, parts[k], 1, 0);
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      add_boundary(edges, united(parts, begin, middle), 1, 0);
      add_boundary(edges, united(parts, middle, end), 1, 0);
    }
    return rim(std::move(edges), positive);
  }

  double reach_, half_step_, side_;
  bool circumscribed_, trimmed_;
};

Region shifted(const Region& region, double radius, double chord_error, bool outwards, bool more) {
  if (!(radius >= 0) || !std::isfinite(radius))
    throw std::invalid_argument("offset radius is " + std::to_string(radius) + ", expected a length of 0 or more");
  if (!(chord_error > 0))
    throw std::invalid_argument("chord error is " + std::to_string(chord_error) + ", expected a length above 0");
  Box box = finite_box(region);
  if (radius == 0 || box.empty()) return region;
  box.grow(radius * 1.5);
  const Lattice lattice(box);
  const double reach = radius / lattice.quantum() + (more ? kSlack : -kSlack);
  if (reach <= 0) return region;  // a smaller radius than the lattice resolves, on the side where none is certain
  const double error = std::max(chord_error / lattice.quantum(), 1.0);
  const double half_step = std::min(std::acos(reach / (reach + error)), kPi / 4);
  const Runner runner(reach, half_step, outwards ? -1 : 1, more, outwards);

  std::vector<OverlayEdge> edges;
  const auto add = [&](const Ring& ring, double sign) {
    std::vector<Site> sites = snapped(ring, lattice);
    if (sites.empty()) return;
    if (signed_area(ring) * sign < 0) std::reverse(sites.begin(), sites.end());
    runner.run(outwards ? straightened(sites, true) : sites, edges);
  };
  for (const Polygon& p : region.polygons) {
    add(p.outer, 1);
    for (const Ring& h : p.holes) add(h, -1);
  }
  return to_region(rim(std::move(edges), positive), lattice);
}

}  // namespace

Region dilate(const Region& region, double radius, double chord_error, Bound bound) {
  return shifted(region, radius, chord_error, true, bound == Bound::outside);
}

Region erode(const Region& region, double radius, double chord_error, Bound bound) {
  return shifted(region, radius, chord_error, false, bound == Bound::inside);
}

}  // namespace oxturn

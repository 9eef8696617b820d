// Each ring is run round at distance `reach` on one side: edges shifted, an arc about each corner that sticks out,
// a detour over the corner itself where it does not. The winding number of all these curves together is that of
// the region plus (dilate) or minus (erode) the number of strips and sectors that cover a point, so "above zero" is
// the answer exactly, for whatever overlaps. Walls are shifted exactly; only arcs carry the chord error.
//
// Along a fine dent (the arc an earlier offset left) n strips would cross n^2 times: there the strips are united by
// halves first and enter as one.
//
// Source      McMains, Chen: Polygon offsetting by computing winding numbers, 2005.
#include "geometry/offset.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/arrangement.hpp"

namespace oxturn {
namespace {

// Corners and offset points are rounded (0.7 quanta each), intersections too, and edges bend by half a quantum, in
// each of up to five unions of halves and the last overlay: this many quanta cover the sum and keep bounds certain.
constexpr double kSlack = 10;
constexpr std::size_t kLongestDent = 32;  // strips in one dent: five unions of halves
constexpr std::size_t kShortestDent = 4;

bool positive(int winding, int) { return winding > 0; }

/// One ring's raw offset curve, in lattice units.
class Runner {
 public:
  /// side: +1 left of the ring, -1 right. circumscribed: arcs by tangents, otherwise by chords.
  Runner(double reach, double half_step, double side, bool circumscribed)
      : reach_(reach), half_step_(half_step), side_(side), circumscribed_(circumscribed) {}

  /// Adds the curve to an overlay.
  void run(const std::vector<Site>& ring, std::vector<OverlayEdge>& edges) const {
    std::vector<Site> out;
    const std::size_t n = ring.size();
    if (n == 1) {
      arc(out, ring[0], {1, 0}, kPi);
      arc(out, ring[0], {-1, 0}, kPi);
      return add_ring(edges, out, 1, 0);
    }
    std::vector<Point> along(n);
    std::vector<double> bend(n);
    for (std::size_t i = 0; i < n; ++i) along[i] = direction(ring[i], ring[i + 1 == n ? 0 : i + 1]);
    for (std::size_t i = 0; i < n; ++i) bend[i] = side_ * cross(along[i == 0 ? n - 1 : i - 1], along[i]);
    const std::vector<std::uint8_t> in_dent = dents(ring, along, bend, edges);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t last = i == 0 ? n - 1 : i - 1;
      const double ahead = along[last].dot(along[i]);
      const Point from = side_ * perpendicular(along[last]), to = side_ * perpendicular(along[i]);
      if (!in_dent[last]) out.push_back(at(ring[i], reach_ * from));
      if (in_dent[last] || in_dent[i] || bend[i] > 0)
        out.push_back(ring[i]);
      else if (bend[i] < 0 || ahead < 0)
        arc(out, ring[i], from, bend[i] < 0 ? std::atan2(-bend[i], ahead) : kPi);
      if (!in_dent[i]) out.push_back(at(ring[i], reach_ * to));
    }
    add_ring(edges, out, 1, 0);
  }

 private:
  static Point direction(const Site& a, const Site& b) {
    const Point d(static_cast<double>(b.x) - a.x, static_cast<double>(b.y) - a.y);
    return d / d.norm();
  }
  static Site at(const Site& s, const Point& shift) {
    return {static_cast<std::int32_t>(std::floor(s.x + shift.x() + 0.5)),
            static_cast<std::int32_t>(std::floor(s.y + shift.y() + 0.5))};
  }
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

  /// Marks the edges that lie in dents, and adds their strips, united.
  std::vector<std::uint8_t> dents(const std::vector<Site>& ring, const std::vector<Point>& along,
                                  const std::vector<double>& bend, std::vector<OverlayEdge>& edges) const {
    const std::size_t n = ring.size();
    std::vector<std::uint8_t> marked(n, 0);
    std::vector<std::vector<Site>> strips;
    for (std::size_t i = 0; i + 1 < n;) {  // edges i .. end-1, both ends of each bend inwards
      std::size_t end = i;
      while (end + 1 < n && end - i < kLongestDent && bend[end] > 0 && bend[end + 1] > 0) ++end;
      if (end - i >= kShortestDent) {
        strips.clear();
        for (std::size_t k = i; k < end; ++k) {
          marked[k] = 1;
          const Point shift = reach_ * side_ * perpendicular(along[k]);
          strips.push_back({ring[k], ring[k + 1], at(ring[k + 1], shift), at(ring[k], shift)});
          if (side_ < 0) std::reverse(strips.back().begin(), strips.back().end());
        }
        add_rim(edges, united(strips, 0, strips.size()), side_ < 0 ? 1 : -1, 0);
      }
      i = std::max(end, i + 1);
    }
    return marked;
  }

  static std::vector<RimEdge> united(const std::vector<std::vector<Site>>& strips, std::size_t begin, std::size_t end) {
    std::vector<OverlayEdge> edges;
    if (end - begin <= 2) {
      for (std::size_t k = begin; k < end; ++k) add_ring(edges, strips[k], 1, 0);
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      add_rim(edges, united(strips, begin, middle), 1, 0);
      add_rim(edges, united(strips, middle, end), 1, 0);
    }
    return rim(std::move(edges), positive);
  }

  double reach_, half_step_, side_;
  bool circumscribed_;
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
  const Runner runner(reach, half_step, outwards ? -1 : 1, more);

  std::vector<OverlayEdge> edges;
  const auto add = [&](const Ring& ring, double sign) {
    std::vector<Site> sites = snapped(ring, lattice);
    if (sites.empty()) return;
    if (signed_area(ring) * sign < 0) std::reverse(sites.begin(), sites.end());
    runner.run(sites, edges);
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

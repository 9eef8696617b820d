// As in offset.cpp, with a polygon for the disc: every ring is run round with each edge shifted by the corner of the
// reflected body that reaches farthest to its left, along the reflected body's border about each corner at which the region
// is reflex, by a detour over the corner itself at the others. The winding number of all these curves together is that
// of the region less the number of parallelograms (edge x corner) and fans (corner x stretch of border) that cover a
// point, so "above zero" is the answer exactly, for whatever overlaps.
//
// Why strips and fans are all that is to be taken off: grow the body at a free place p from a point until it first
// touches a wall. It touches an edge with one of its corners (then p lies in the edge's parallelogram) or a corner of the
// region with its border (then p lies in the corner's fan).
//
// Source      McMains, Chen: Polygon offsetting by computing winding numbers, 2005; convolution curves: Guibas, Ramshaw,
//             Stolfi, A kinetic framework for computational geometry, 1983.
// Decisions   1. An edge parallel to a side of the body is shifted by the side's first corner in the sense of the walk;
//                the rest of the side belongs to the fan at the edge's end. Where the region is not reflex there, the
//                next edge's strip holds it.
//             2. Along a fine curve most edges are shifted by the same corner: their parallelograms lie side by side and
//                cross nothing, so dents need no care of their own (offset.cpp unites them first).
#include "geometry/overlay/minkowski.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/overlay/arrangement.hpp"

namespace oxturn {
namespace {

constexpr double kSlack = 10;  // quanta by which the body grows or shrinks: see offset.cpp

std::int64_t cross(const Site& a, const Site& b) {
  return std::int64_t{a.x} * std::int64_t{b.y} - std::int64_t{a.y} * std::int64_t{b.x};
}
Site operator-(const Site& a, const Site& b) { return {a.x - b.x, a.y - b.y}; }
Site operator+(const Site& a, const Site& b) { return {a.x + b.x, a.y + b.y}; }

/// The reflected body on the lattice, its corners clockwise: the order in which a walk with free space on its left
/// comes by them at a reflex corner.
class Body {
 public:
  Body(const Ring& ring, double quantum, double grow) {
    double inner = 1e300;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point along = ring[(i + 1) % ring.size()] - ring[i];
      inner = std::min(inner, oxturn::cross(ring[i], along) / along.norm());
    }
    if (!(inner > 0))
      throw std::invalid_argument("body of a Minkowski difference does not hold the origin strictly inside");
    const double scale = std::max(0.0, 1 + grow * quantum / inner) / quantum;
    for (auto p = ring.rbegin(); p != ring.rend(); ++p) {
      const Site s{static_cast<std::int32_t>(std::lround(-p->x() * scale)),
                   static_cast<std::int32_t>(std::lround(-p->y() * scale))};
      if (corners_.empty() || corners_.back() != s) corners_.push_back(s);
    }
    while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
  }

  /// The corner farthest to the left of direction d; of two, the first in the sense of the walk.
  std::size_t farthest_left(const Site& d) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      const std::int64_t gain = cross(d, corners_[i]) - cross(d, corners_[best]);
      if (gain > 0 || (gain == 0 && along(d, corners_[i]) < along(d, corners_[best]))) best = i;
    }
    return best;
  }
  /// Clockwise.
  std::vector<Site> about(const Site& centre) const {
    std::vector<Site> ring;
    for (const Site& s : corners_) ring.push_back(centre + s);
    return ring;
  }
  const Site& at(std::size_t i) const { return corners_[i]; }
  std::size_t next(std::size_t i) const { return i + 1 == corners_.size() ? 0 : i + 1; }

 private:
  static std::int64_t along(const Site& d, const Site& s) {
    return std::int64_t{d.x} * std::int64_t{s.x} + std::int64_t{d.y} * std::int64_t{s.y};
  }
  std::vector<Site> corners_;
};

std::vector<Site> run(const std::vector<Site>& ring, const Body& body) {
  std::vector<Site> out;
  const std::size_t n = ring.size();
  std::vector<Site> along(n);
  std::vector<std::size_t> shift(n);
  for (std::size_t i = 0; i < n; ++i) {
    along[i] = ring[i + 1 == n ? 0 : i + 1] - ring[i];
    shift[i] = body.farthest_left(along[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t last = i == 0 ? n - 1 : i - 1;
    const std::int64_t turn = cross(along[last], along[i]);
    out.push_back(ring[i] + body.at(shift[last]));
    if (turn > 0) {
      if (shift[last] != shift[i]) out.push_back(ring[i]);
    } else {  // straight on: nothing; straight back: half a round
      for (std::size_t k = shift[last]; k != shift[i]; k = body.next(k)) out.push_back(ring[i] + body.at(k));
    }
    out.push_back(ring[i] + body.at(shift[i]));
  }
  return out;
}

bool positive(int winding, int) { return winding > 0; }

}  // namespace

Region erode(const Region& region, const Ring& body, Bound bound) {
  Box box = finite_box(region);
  Box reach;
  for (const Point& p : body) {
    if (!finite(p)) throw std::invalid_argument("body of a Minkowski difference has a coordinate that is not finite");
    reach.add(p);
  }
  if (body.empty()) throw std::invalid_argument("body of a Minkowski difference has no corners");
  if (box.empty()) return region;
  box.grow(1.5 * std::max(reach.high.cwiseAbs().maxCoeff(), reach.low.cwiseAbs().maxCoeff()));
  const Lattice lattice(box);
  const Body grown(body, lattice.quantum(), bound == Bound::inside ? kSlack : -kSlack);

  std::vector<OverlayEdge> edges;
  const auto add = [&](const Ring& ring, double sign) {
    std::vector<Site> sites = snapped(ring, lattice);
    if (sites.size() < 2) {  // smaller than the lattice resolves: no room inside, but still in the way
      if (sign < 0) add_ring(edges, grown.about(sites[0]), 1, 0);
      return;
    }
    if (signed_area(ring) * sign < 0) std::reverse(sites.begin(), sites.end());
    add_ring(edges, run(sites, grown), 1, 0);
  };
  for (const Polygon& p : region.polygons) {
    add(p.outer, 1);
    for (const Ring& h : p.holes) add(h, -1);
  }
  return to_region(rim(std::move(edges), positive), lattice);
}

}  // namespace oxturn

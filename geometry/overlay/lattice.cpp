#include "geometry/overlay/lattice.hpp"

#include <algorithm>

#include "base/throw_invalid.hpp"

namespace oxturn {

Lattice::Lattice(const Box& box) {
  if (box.empty()) return;
  constexpr int kBits = 30;          // of a coordinate, sign included
  constexpr int kMantissaBits = 52;  // of a double
  constexpr int kLeastExponent = -960;
  const double extent = std::max(box.size().x(), box.size().y());
  const double far = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  int extent_bits = -1000, far_bits = -1000;
  if (extent > 0) std::frexp(extent, &extent_bits);
  if (far > 0) std::frexp(far, &far_bits);
  // Far from the origin the lattice is no finer than the doubles there, so that point() is exact.
  quantum_ = std::ldexp(1.0, std::max({extent_bits - kBits, far_bits - kMantissaBits, kLeastExponent}));
  per_metre_ = 1 / quantum_;
  x_ = std::floor(box.centre().x() * per_metre_ + 0.5);
  y_ = std::floor(box.centre().y() * per_metre_ + 0.5);
}

void for_each_snapped_ring(const Region& region, const Lattice& lattice,
                           const std::function<void(std::vector<LatticePoint>&, RingKind)>& f) {
  std::vector<LatticePoint> points;
  const auto add = [&](const Ring& ring, RingKind kind) {
    if (ring.empty()) return;
    points.clear();
    points.reserve(ring.size());
    for (const Point& p : ring)
      if (const LatticePoint s = lattice.snap(p); points.empty() || points.back() != s) points.push_back(s);
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (signed_area(ring) * (kind == RingKind::outer ? 1 : -1) < 0) std::reverse(points.begin(), points.end());
    f(points, kind);
  };
  for (const Polygon& p : region.polygons) {
    add(p.outer, RingKind::outer);
    for (const Ring& h : p.holes) add(h, RingKind::hole);
  }
}

Box finite_box(const Region& region) {
  for_each_ring(region, [](const Ring& r) {
    for (const Point& p : r)
      if (!finite(p)) throw_invalid("region has a coordinate that is not a finite number");
  });
  return bounding_box(region);
}

}  // namespace oxturn

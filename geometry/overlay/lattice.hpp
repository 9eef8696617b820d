/// The integer lattice of the overlay: points, conversion from and to metres. Private to geometry, not installed.
///
///   const Lattice lattice(finite_box(region));
///   const LatticePoint s = lattice.snap(p);     // at most half a quantum away in x and in y
///   lattice.point(s);                           // back in metres, exactly
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "geometry/region.hpp"

namespace oxturn {

/// |x|, |y| <= 2^29, so that products of differences, and sums of two of them, fit into 64 bits.
struct LatticePoint {
  std::int32_t x = 0, y = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;  // by x, then by y
  friend LatticePoint operator+(const LatticePoint& p, const LatticePoint& q) { return {p.x + q.x, p.y + q.y}; }
  friend LatticePoint operator-(const LatticePoint& p, const LatticePoint& q) { return {p.x - q.x, p.y - q.y}; }
};

/// Cross and dot product of two differences of lattice points; exact.
inline std::int64_t cross(const LatticePoint& a, const LatticePoint& b) {
  return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}
inline std::int64_t dot(const LatticePoint& a, const LatticePoint& b) {
  return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y;
}
/// Twice the signed area of the triangle abc, exactly: positive if it turns left.
inline std::int64_t twice_area(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return cross(b - a, c - a);
}
/// The nearest lattice point; coordinates in quanta.
inline LatticePoint rounded(double x, double y) {
  const auto floor = [](double v) {  // std::floor is a call
    const auto towards_zero = static_cast<std::int32_t>(v);
    return towards_zero - (v < towards_zero ? 1 : 0);
  };
  return {floor(x + 0.5), floor(y + 0.5)};
}
/// Both coordinates in one number whose order is that of the points.
inline std::uint64_t sort_key(const LatticePoint& p) {
  constexpr std::uint32_t kSign = 0x80000000u;
  return (std::uint64_t{static_cast<std::uint32_t>(p.x) ^ kSign} << 32) | (static_cast<std::uint32_t>(p.y) ^ kSign);
}

/// A lattice over a box. Its quantum is a power of two, about 2^-30 of the box's extent, and its origin a multiple of
/// it: a point that was snapped to this or a coarser lattice is not moved again.
class Lattice {
 public:
  explicit Lattice(const Box& box);
  LatticePoint snap(const Point& p) const { return rounded(p.x() * per_metre_ - x_, p.y() * per_metre_ - y_); }
  Point point(const LatticePoint& p) const { return {(x_ + p.x) * quantum_, (y_ + p.y) * quantum_}; }
  /// Metres.
  double quantum() const { return quantum_; }

 private:
  double quantum_ = 1, per_metre_ = 1;  // powers of two: to multiply by one is exact, as to divide by the other is
  double x_ = 0, y_ = 0;                // the origin in quanta
};

enum class RingKind { outer, hole };
/// Calls f(points, kind) for every ring of a region that is not empty: its points on the lattice, those that coincide
/// with the one before left out. Outer rings come counter-clockwise and holes clockwise, whatever their orientation in
/// the region.
void for_each_snapped_ring(const Region& region, const Lattice& lattice,
                           const std::function<void(std::vector<LatticePoint>&, RingKind)>& f);

/// The bounding box. Throws std::invalid_argument unless all coordinates are finite.
Box finite_box(const Region& region);

}  // namespace oxturn

/// How far a taut tether can be driven before a corner of free space may bend it.
///
///   const std::size_t n = SweptTriangles(tether, points, first).without_corners(free_space);
///   if (n > 0) tether.drive(points[first + n - 1]);   // the same as driving to each of the n points in turn
///
/// O(points + corners near by).
#pragma once

#include <array>
#include <cstddef>

#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

/// The part of the plane that the tether's last segment sweeps over as it goes to each of several points: triangles at
/// the pivot that grow from point to point.
class SweptTriangles {
 public:
  static constexpr std::size_t kMost = 16;  // points

  /// Of points[first ..], as many as the tether keeps all bends for, kMost at most.
  SweptTriangles(const TautTether& tether, const Polyline& points, std::size_t first);

  /// So many of them have no corner near by, but the pivot.
  std::size_t without_corners(const TautSpace& corners) const;

 private:
  /// Its sides at the pivot are given by the tangents of their angles from the tether.
  struct Triangle {
    double low, high, reach;
  };

  Point pivot_, along_, aside_;
  std::size_t size_ = 0;
  std::array<Triangle, kMost> triangles_;
};

}  // namespace oxturn

#include "geometry/tether/straightened.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/tether/taut_space.hpp"

namespace oxturn {
namespace {

/// From its vertex `reach` metres along an axis, between two rays, given by the tangents of their angles from the axis.
struct Triangle {
  double low, high, reach;
};

/// The axis goes through the first point.
class Triangles {
 public:
  Triangles(const Point& from, const Polyline& points, std::size_t first)
      : from_(from), along_((points[first] - from).normalized()), aside_(perpendicular(along_)) {
    Triangle t{0, 0, 0};
    for (; size_ <= kMostSkipped && first + size_ < points.size(); triangles_[size_++] = t) {
      const Point d = points[first + size_] - from_;
      const double along = d.dot(along_), tangent = d.dot(aside_) / along;
      if (!(along > 0 && std::abs(tangent) <= 1)) return;
      t = {std::min(t.low, tangent), std::max(t.high, tangent), std::max(t.reach, along)};
    }
  }

  /// So many of the points lie in a triangle without a corner.
  std::size_t without_corners(const TautSpace& corners) const {
    if (size_ < 2) return size_;
    constexpr double kPad = 4 * TautSpace::kNear;
    const auto& [low, high, reach] = triangles_[size_ - 1];
    const std::array largest{from_, Point(from_ + reach * (along_ + low * aside_)),
                             Point(from_ + reach * (along_ + high * aside_))};
    std::size_t free = size_;
    corners.for_each_near(largest, kPad, [&](const TautSpace::Corner& c) {
      const Point d = c.at - from_;
      const double along = d.dot(along_), across = d.dot(aside_);
      if (along < -kPad) return;
      const auto near = [&](const Triangle& t) {
        return along <= t.reach + kPad && across >= t.low * along - kPad && across <= t.high * along + kPad;
      };
      while (free > 0 && near(triangles_[free - 1])) --free;
    });
    return free;
  }

 private:
  Point from_, along_, aside_;
  std::size_t size_ = 0;
  std::array<Triangle, kMostSkipped + 1> triangles_;
};

}  // namespace

std::size_t points_to_skip(const TautSpace& corners, const Point& from, const Polyline& points, std::size_t first) {
  if (points[first] == from) return 0;
  const std::size_t n = Triangles(from, points, first).without_corners(corners);
  return n > 0 ? n - 1 : 0;
}

}  // namespace oxturn

#include "geometry/tether/swept_triangles.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"

namespace oxturn {

SweptTriangles::SweptTriangles(const TautTether& tether, const Polyline& points, std::size_t first)
    : pivot_(tether.pivot()), along_((tether.robot() - pivot_).normalized()), aside_(perpendicular(along_)) {
  if (tether.robot() == pivot_) return;
  const auto& bends = tether.bends();
  const Point before = bends.size() > 1 ? bends[bends.size() - 2].at : tether.anchor();
  Triangle t{0, 0, (tether.robot() - pivot_).norm()};
  for (; size_ < kMost && first + size_ < points.size(); triangles_[size_++] = t) {
    const Point& p = points[first + size_];
    const double along = (p - pivot_).dot(along_), tangent = (p - pivot_).dot(aside_) / along;
    if (!(along > 0 && std::abs(tangent) <= 1)) return;
    if (!bends.empty() && bends.back().side * orientation(before, pivot_, p) <= 0) return;
    t = {std::min(t.low, tangent), std::max(t.high, tangent), std::max(t.reach, along)};
  }
}

std::size_t SweptTriangles::without_corners(const TautSpace& corners) const {
  if (size_ == 0) return 0;
  constexpr double kPad = 4 * TautSpace::kNear;
  const auto& [low, high, reach] = triangles_[size_ - 1];
  const std::array largest{pivot_, Point(pivot_ + reach * (along_ + low * aside_)),
                           Point(pivot_ + reach * (along_ + high * aside_))};
  std::size_t free = size_;
  corners.for_each_near(largest, kPad, [&](const TautSpace::Corner& c) {
    const Point d = c.at - pivot_;
    const double along = d.dot(along_), across = d.dot(aside_);
    if (c.at == pivot_ || along < -kPad) return;
    const auto near = [&](const Triangle& t) {
      return along <= t.reach + kPad && across >= t.low * along - kPad && across <= t.high * along + kPad;
    };
    while (free > 0 && near(triangles_[free - 1])) --free;
  });
  return free;
}

}  // namespace oxturn

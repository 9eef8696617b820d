#include "geometry/thinned.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

namespace oxturn {
namespace {

/// The directions in which a ray from `apex` passes within `error` of all points that were added.
class Cone {
 public:
  Cone(const Point& apex, double error) : apex_(apex), error_(error) {}

  /// False, and nothing changes: the ray to p leaves the cone, or p is nearer than one before it.
  bool add(const Point& p) {
    const double d = distance(apex_, p);
    if (d < reach_) return false;
    if (d <= error_) {  // any ray passes it
      reach_ = d;
      return true;
    }
    const double direction = math::atan2(p.y() - apex_.y(), p.x() - apex_.x()), half = math::asin(error_ / d);
    if (!open_) {
      first_ = direction, low_ = -half, high_ = half, open_ = true;
    } else {
      const double turn = std::remainder(direction - first_, 2 * kPi);
      if (turn < low_ || turn > high_) return false;
      low_ = std::max(low_, turn - half), high_ = std::min(high_, turn + half);
    }
    reach_ = d;
    return true;
  }

 private:
  Point apex_;
  double error_, reach_ = 0;
  double first_ = 0, low_ = 0, high_ = 0;  // radians; low_ and high_ from first_
  bool open_ = false;
};

}  // namespace

Polyline thinned(const Polyline& line, double error) {
  if (line.size() < 3) return line;
  Polyline out{line.front()};
  Cone cone(line.front(), error);
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (cone.add(line[k])) continue;
    out.push_back(line[k - 1]);
    cone = Cone(line[k - 1], error);
    cone.add(line[k]);
  }
  out.push_back(line.back());
  return out;
}

bool is_dense(const Polyline& line, double distance) {
  return line.size() > 2 && length(line) < distance * static_cast<double>(line.size());
}

}  // namespace oxturn

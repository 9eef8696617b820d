#include "algorithms/smoothing/route.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr std::size_t kMostLooks = 6;  // points that may be out of sight
constexpr double kMostPoints = 4000;   // of a route
constexpr double kBeside = 1e-9;       // spacings: two points of a route that are one

std::vector<Point> spaced(const Polyline& path, double spacing) {
  std::vector<Point> points;
  if (path.size() < 2) return points;
  spacing = std::max(spacing, length(path) / kMostPoints);
  points.push_back(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double edge = distance(path[i - 1], path[i]), parts = std::ceil(edge / spacing);
    for (double k = 1; k <= parts && edge > kBeside * spacing; ++k)
      points.push_back(lerp(path[i - 1], path[i], k / parts));
  }
  return points;
}

}  // namespace

Route::Route(const Polyline& path, const EdgeIndex& walls, double spacing)
    : points_(spaced(path, spacing)), rest_(points_.size(), 0), walls_(walls), grid_(points_) {
  for (std::size_t i = points_.size(); i-- > 1;) rest_[i - 1] = rest_[i] + distance(points_[i - 1], points_[i]);
}

double Route::rest(const Point& p) const {
  if (points_.empty()) return 0;
  double result = distance(p, points_.back());
  std::size_t looks = 0;
  grid_.visit(p, [&](std::size_t i, double metres) {
    if (!walls_.contains(p, points_[i])) return ++looks < kMostLooks;
    result = metres + rest_[i];
    return false;
  });
  return result;
}

}  // namespace oxturn

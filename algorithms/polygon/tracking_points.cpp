#include "algorithms/polygon/tracking_points.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

/// Where a ring crosses a line.
struct LineCrossing {
  double x;
  int obstacle;
};
using CrossingsByLine = std::vector<std::vector<LineCrossing>>;

/// y of the lines, descending.
std::vector<double> heights(const Box& box, double separation, double keep_off) {
  const double top = box.high.y() - keep_off, bottom = box.low.y() + keep_off;
  std::vector<double> all;
  for (int k = 0; all.empty() || top - k * separation > bottom; ++k) all.push_back(top - k * separation);
  if (all.back() > bottom + keep_off) all.push_back(bottom);
  return all;
}

/// A line belongs to what lies just above it: an edge crosses the line if one end is above it and the other is not.
void add_crossings(const Ring& ring, int obstacle, const std::vector<double>& lines, CrossingsByLine& crossings) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point &low = ring[i].y() <= ring[j].y() ? ring[i] : ring[j], &high = &low == &ring[i] ? ring[j] : ring[i];
    const auto first_below =
        std::lower_bound(lines.begin(), lines.end(), high.y(), [](double line, double y) { return line >= y; });
    for (auto k = static_cast<std::size_t>(first_below - lines.begin()); k < lines.size() && lines[k] >= low.y(); ++k) {
      const double t = (lines[k] - low.y()) / (high.y() - low.y());
      const double x = low.x() + t * (high.x() - low.x());
      crossings[k].push_back({std::clamp(x, std::min(low.x(), high.x()), std::max(low.x(), high.x())), obstacle});
    }
  }
}

}  // namespace

TrackingLines tracking_lines(const Region& space, double separation, double keep_off, double delta_x) {
  const Box box = bounding_box(space);
  const std::vector<double> lines = heights(box, separation, keep_off);
  CrossingsByLine crossings(lines.size());
  int obstacles = 0;
  for (const Polygon& polygon : space.polygons) {
    add_crossings(polygon.outer, 0, lines, crossings);
    for (const Ring& hole : polygon.holes) add_crossings(hole, ++obstacles, lines, crossings);
  }

  TrackingLines result;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    result.first.push_back(result.points.size());
    const auto add = [&](double x, int obstacle, Contact wall, Contact other) {
      result.points.push_back({{x, lines[k]}, static_cast<int>(k), obstacle == 0 ? wall : other, obstacle});
    };
    std::vector<LineCrossing>& on = crossings[k];
    std::stable_sort(on.begin(), on.end(), [](const LineCrossing& a, const LineCrossing& b) { return a.x < b.x; });
    for (std::size_t i = 0; i + 1 < on.size(); i += 2) {
      double left = on[i].x + keep_off, right = on[i + 1].x - keep_off;
      if (left > right) left = right = (on[i].x + on[i + 1].x) / 2;
      if (delta_x > 0) {
        left = box.low.x() + std::ceil((left - box.low.x()) / delta_x) * delta_x;
        right = box.low.x() + std::floor((right - box.low.x()) / delta_x) * delta_x;
        if (left > right) continue;
      }
      add(left, on[i].obstacle, Contact::left_wall, Contact::left_obstacle);
      add(right, on[i + 1].obstacle, Contact::right_wall, Contact::right_obstacle);
    }
  }
  result.first.push_back(result.points.size());
  return result;
}

}  // namespace oxturn

#include "algorithms/polygon/tracking_points.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

struct Crossing {
  double x;
  int obstacle;
};

std::vector<double> heights(const Box& box, double separation, double spare) {
  const double top = box.high.y() - spare, bottom = box.low.y() + spare;
  std::vector<double> all;
  for (int k = 0; all.empty() || top - k * separation > bottom; ++k) all.push_back(top - k * separation);
  if (all.back() > bottom + spare) all.push_back(bottom);
  return all;
}

}  // namespace

TrackingLines tracking_lines(const Region& space, double separation, double spare, double delta_x) {
  const Box box = bounding_box(space);
  const std::vector<double> lines = heights(box, separation, spare);
  std::vector<std::vector<Crossing>> crossings(lines.size());
  // A line belongs to what is just above it: an edge crosses it if one end is above and the other is not.
  const auto add = [&](const Ring& ring, int obstacle) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Point &low = ring[i].y() <= ring[j].y() ? ring[i] : ring[j], &high = &low == &ring[i] ? ring[j] : ring[i];
      auto k = static_cast<std::size_t>(
          std::lower_bound(lines.begin(), lines.end(), high.y(), [](double line, double y) { return line >= y; }) -
          lines.begin());
      for (; k < lines.size() && lines[k] >= low.y(); ++k) {
        const double t = (lines[k] - low.y()) / (high.y() - low.y());
        const double x = low.x() + t * (high.x() - low.x());
        crossings[k].push_back({std::clamp(x, std::min(low.x(), high.x()), std::max(low.x(), high.x())), obstacle});
      }
    }
  };
  int obstacles = 0;
  for (const Polygon& polygon : space.polygons) {
    add(polygon.outer, 0);
    for (const Ring& hole : polygon.holes) add(hole, ++obstacles);
  }

  TrackingLines result;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    result.first.push_back(result.points.size());
    std::vector<Crossing>& on = crossings[k];
    std::stable_sort(on.begin(), on.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    for (std::size_t i = 0; i + 1 < on.size(); i += 2) {
      double left = on[i].x + spare, right = on[i + 1].x - spare;
      if (left > right) left = right = (on[i].x + on[i + 1].x) / 2;
      if (delta_x > 0) {
        left = box.low.x() + std::ceil((left - box.low.x()) / delta_x) * delta_x;
        right = box.low.x() + std::floor((right - box.low.x()) / delta_x) * delta_x;
        if (left > right) continue;
      }
      const auto point = [&](double x, int obstacle, Contact wall, Contact other) {
        result.points.push_back({{x, lines[k]}, static_cast<int>(k), obstacle == 0 ? wall : other, obstacle});
      };
      point(left, on[i].obstacle, Contact::left_wall, Contact::left_obstacle);
      point(right, on[i + 1].obstacle, Contact::right_wall, Contact::right_obstacle);
    }
  }
  result.first.push_back(result.points.size());
  return result;
}

}  // namespace oxturn

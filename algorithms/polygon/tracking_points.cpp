#include "algorithms/polygon/tracking_points.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/lanes/lanes.hpp"

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

/// The contacts of the intervals that `needs(line, left, right)` keeps.
template <class Needs>
TrackingLines contacts_on(const std::vector<double>& lines, const Region& space, double keep_off, double delta_x,
                          Needs needs) {
  const Box box = bounding_box(space);
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
      if (!needs(k, on[i].x, on[i + 1].x)) continue;
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

}  // namespace

TrackingLines tracking_lines(const Region& space, double separation, double keep_off, double delta_x) {
  return contacts_on(heights(bounding_box(space), separation, keep_off), space, keep_off, delta_x,
                     [](std::size_t, double, double) { return true; });
}

TrackingLines tracking_lines(const Region& space, const Region& needed, double separation, double keep_off,
                             double delta_x) {
  if (needed.empty()) return {{}, {0}};
  const Region turned = LaneFrame(0).to_frame(needed);  // (x, y) becomes (-y, x)
  const Box box = bounding_box(turned);
  const Slabs slabs = slabs_over(box.low.x(), box.high.x(), separation);
  std::vector<double> lines;
  for (std::size_t k = 0; k < slabs.count; ++k) lines.push_back(-slabs.centre(k));
  std::vector<std::vector<LaneInterval>> needed_on(slabs.count);
  for (const LaneInterval& part : project(edges_of(turned), slabs).intervals) needed_on[part.slab].push_back(part);
  return contacts_on(lines, space, keep_off, delta_x, [&](std::size_t line, double left, double right) {
    return std::any_of(needed_on[line].begin(), needed_on[line].end(),
                       [&](const LaneInterval& part) { return part.low <= right && part.high >= left; });
  });
}

}  // namespace oxturn

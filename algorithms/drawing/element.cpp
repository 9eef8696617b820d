#include "algorithms/drawing/element.hpp"

#include <algorithm>

#include "base/math.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

/// `visit.entry` is the first point; the points before it follow after the last.
Polyline from_entry(const Polyline& closed, std::size_t entry) {
  const auto at = closed.begin() + static_cast<std::ptrdiff_t>(entry);
  Polyline points(at, closed.end());
  points.insert(points.end(), closed.begin() + 1, at + 1);
  return points;
}

/// The source's nodes, and points evenly between all.
std::vector<std::size_t> entries_of(const Polyline& closed, const std::vector<std::size_t>& nodes) {
  const std::size_t n = closed.size() - 1;
  std::vector<std::size_t> entries;
  const std::size_t step = std::max<std::size_t>(1, (n + kMostEntries - 1) / kMostEntries);
  for (std::size_t k = 0; k < n; k += step) entries.push_back(k);
  if (nodes.size() + entries.size() <= 2 * kMostEntries)
    for (const std::size_t node : nodes)
      if (node < n) entries.push_back(node);
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  return entries;
}

void check(const DrawnStroke& stroke, std::size_t number) {
  if (!(stroke.width > 0))
    throw_invalid("stroke {} ('{}') has width {}, expected above 0", number, stroke.element, stroke.width);
  for (const Point& p : stroke.points)
    if (!finite(p)) throw_invalid("stroke {} ('{}') has a point that is not finite", number, stroke.element);
  if (!(length(stroke.points) > 0)) throw_invalid("stroke {} ('{}') has no length", number, stroke.element);
}

}  // namespace

std::vector<DrawingElement> stroke_elements(const Drawing& drawing) {
  std::vector<DrawingElement> elements;
  for (const DrawnStroke& stroke : drawing.strokes) {
    check(stroke, elements.size());
    DrawingElement e{.name = stroke.element, .legs = {{.tool = stroke.tool, .points = stroke.points}}};
    e.legs[0].width = stroke.tool ? stroke.width : 0;
    e.closed = stroke.points.size() > 2 && stroke.points.front() == stroke.points.back();
    e.nodes = stroke.nodes;
    e.corners = stroke.corners;
    if (e.closed) e.entries = entries_of(stroke.points, stroke.nodes);
    elements.push_back(std::move(e));
  }
  return elements;
}

std::vector<Leg> driven(const DrawingElement& element, const ElementVisit& visit) {
  std::vector<Leg> legs = element.legs;
  if (element.closed) legs[0].points = from_entry(legs[0].points, visit.entry);
  if (!visit.backwards) return legs;
  std::reverse(legs.begin(), legs.end());
  for (Leg& leg : legs) std::reverse(leg.points.begin(), leg.points.end());
  return legs;
}

bool is_transit(const std::vector<Leg>& legs, std::size_t k) {
  return !legs[k].tool && (legs.front().tool || k % 2 == 1);
}

Point entry_of(const DrawingElement& element, const ElementVisit& visit) {
  if (element.closed) return element.legs[0].points[visit.entry];
  return visit.backwards ? element.last() : element.first();
}

Point exit_of(const DrawingElement& element, const ElementVisit& visit) {
  if (element.closed) return element.legs[0].points[visit.entry];
  return visit.backwards ? element.first() : element.last();
}

Pose first_heading(const Polyline& line) {
  const auto other = std::find_if(line.begin(), line.end(), [&](const Point& p) { return p != line.front(); });
  const Point d = (other == line.end() ? line.back() : *other) - line.front();
  return {line.front(), math::atan2(d.y(), d.x())};
}

Pose last_heading(const Polyline& line) {
  const auto other = std::find_if(line.rbegin(), line.rend(), [&](const Point& p) { return p != line.back(); });
  const Point d = line.back() - (other == line.rend() ? line.front() : *other);
  return {line.back(), math::atan2(d.y(), d.x())};
}

/// Without copying a closed stroke: of its points only those about the entry count.
Pose entry_pose(const DrawingElement& element, const ElementVisit& visit) {
  if (!element.closed)
    return visit.backwards ? turned_round(last_heading(element.legs.back().points))
                           : first_heading(element.legs.front().points);
  const Polyline& ring = element.legs[0].points;
  const std::size_t n = ring.size() - 1, next = visit.backwards ? (visit.entry + n - 1) % n : visit.entry + 1;
  return first_heading({ring[visit.entry], ring[next]});
}

Pose exit_pose(const DrawingElement& element, const ElementVisit& visit) {
  if (!element.closed)
    return visit.backwards ? turned_round(first_heading(element.legs.front().points))
                           : last_heading(element.legs.back().points);
  const Polyline& ring = element.legs[0].points;
  const std::size_t n = ring.size() - 1, before = visit.backwards ? visit.entry + 1 : (visit.entry + n - 1) % n;
  return last_heading({ring[before], ring[visit.entry]});
}

double length(const DrawingElement& element) {
  double sum = 0;
  for (const Leg& leg : element.legs) sum += length(leg.points);
  return sum;
}

}  // namespace oxturn

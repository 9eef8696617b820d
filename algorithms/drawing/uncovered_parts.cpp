#include "algorithms/drawing/uncovered_parts.hpp"

#include <algorithm>
#include <utility>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/overlay/swath.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 2e-3;   // tool widths: error of arcs
constexpr double kSliver = 0.05;  // tool widths: half the thickness of rests that are ignored
constexpr double kStep = 0.125;   // tool widths, along lines

using Span = std::pair<double, double>;

double half_width(const Leg& leg, double tool_width) { return (leg.width > 0 ? leg.width : tool_width) / 2; }

/// Metres along the line within which it is near the rest; longer by half a tool at both ends.
std::vector<Span> spans_near(const Polyline& line, const EdgeIndex& near, double width) {
  std::vector<Span> spans;
  double at = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double d = distance(line[k - 1], line[k]), parts = std::ceil(d / (kStep * width));
    for (double i = 0; i <= parts; ++i) {
      if (!near.contains(lerp(line[k - 1], line[k], parts > 0 ? i / parts : 0))) continue;
      const double here = at + (parts > 0 ? d * i / parts : 0);
      if (!spans.empty() && here - width / 2 <= spans.back().second)
        spans.back().second = here + width / 2;
      else
        spans.push_back({std::max(0.0, here - width / 2), here + width / 2});
    }
    at += d;
  }
  return spans;
}

Polyline part(const Polyline& line, const Span& span) {
  Polyline points;
  double at = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double d = distance(line[k - 1], line[k]);
    const double low = std::max(span.first, at), high = std::min(span.second, at + d);
    if (d > 0 && low < high) {
      if (points.empty()) points.push_back(lerp(line[k - 1], line[k], (low - at) / d));
      points.push_back(lerp(line[k - 1], line[k], (high - at) / d));
    }
    at += d;
  }
  return points;
}

}  // namespace

Region not_surely_covered(const Region& area, const std::vector<Leg>& legs, double tool_width) {
  std::vector<Region> swept;
  for (const Leg& leg : legs) {
    if (!leg.tool) continue;
    const double radius = half_width(leg, tool_width);
    for (Region& region : swath_parts({leg.points}, radius, kChord * radius, Bound::inside))
      swept.push_back(std::move(region));
  }
  return subtract(area, swept);
}

Region worthwhile(const Region& rest, double width) {
  if (rest.empty()) return rest;
  const Region core = erode(rest, kSliver * width, kChord * width, Bound::outside);
  return core.empty() ? core : dilate(core, kSliver * width, kChord * width, Bound::inside);
}

std::vector<Polyline> parts_near(const std::vector<Polyline>& lines, const Region& rest, double width) {
  std::vector<Polyline> parts;
  if (rest.empty()) return parts;
  const EdgeIndex near(dilate(rest, width / 2, kChord * width, Bound::inside));
  for (const Polyline& line : lines)
    for (const Span& span : spans_near(line, near, width))
      if (Polyline points = part(line, span); points.size() > 1) parts.push_back(std::move(points));
  return parts;
}

}  // namespace oxturn

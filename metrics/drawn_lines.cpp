#include "metrics/drawn_lines.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/thinned.hpp"

namespace oxturn {
namespace {

constexpr double kDense = 1e-3;     // metres
constexpr double kThinning = 1e-5;  // metres

/// By width, in driving order.
std::map<double, std::vector<PathSegment>> segments_of(const Path& path, double tool_width) {
  std::map<double, std::vector<PathSegment>> all;
  for (std::size_t l = 0; l < path.legs.size(); ++l) {
    const Leg& leg = path.legs[l];
    if (!leg.tool) continue;
    const double width = width_of(leg, tool_width);
    const Polyline line = line_of(leg);
    for (std::size_t i = 1; i < line.size(); ++i)
      if (line[i] != line[i - 1]) all[width].push_back({line[i - 1], line[i], l, width});
  }
  return all;
}

/// The t for which low <= value + t * slope <= high, within `part`.
bool clip(double value, double slope, double low, double high, LinePart& part) {
  if (slope == 0) return value >= low && value <= high;
  const double s = (low - value) / slope, t = (high - value) / slope;
  part.from = std::max(part.from, std::min(s, t));
  part.to = std::min(part.to, std::max(s, t));
  return part.from <= part.to;
}

/// Of ab within `reach` of the point c.
std::optional<LinePart> near_point(const Point& a, const Point& b, const Point& c, double reach) {
  const Point d = b - a, e = a - c;
  const double A = d.squaredNorm(), B = e.dot(d), C = e.squaredNorm() - reach * reach, D = B * B - A * C;
  if (A <= 0 || D < 0) return std::nullopt;
  const double root = std::sqrt(D);
  const LinePart part{std::max(0.0, (-B - root) / A), std::min(1.0, (-B + root) / A)};
  return part.from <= part.to ? std::optional<LinePart>(part) : std::nullopt;
}

}  // namespace

double width_of(const Leg& leg, double tool_width) {
  return leg.width > 0 ? std::min(leg.width, tool_width) : tool_width;
}

Polyline line_of(const Leg& leg) { return is_dense(leg.points, kDense) ? thinned(leg.points, kThinning) : leg.points; }

PathSegments::PathSegments(const Path& path, double tool_width) {
  for (auto& of_width : segments_of(path, tool_width)) {
    std::vector<PathSegment>& segments = of_width.second;
    first_leg_ = widths_.empty() ? segments.front().leg : std::min(first_leg_, segments.front().leg);
    UniformGrid grid(segments.size(), [&](std::size_t i) { return std::array{segments[i].a, segments[i].b}; });
    widths_.push_back({std::move(segments), std::move(grid)});
  }
}

std::optional<LinePart> within(const Point& a, const Point& b, const Point& c, const Point& d, double reach) {
  std::optional<LinePart> all;
  const auto join = [&](const std::optional<LinePart>& part) {
    if (part) all = all ? LinePart{std::min(all->from, part->from), std::max(all->to, part->to)} : *part;
  };
  join(near_point(a, b, c, reach));
  join(near_point(a, b, d, reach));
  const double length = distance(c, d);
  if (length <= 0) return all;
  const Point along = (d - c) / length;
  LinePart part{0, 1};
  if (clip(along.dot(a - c), along.dot(b - a), 0, length, part) &&
      clip(cross(along, a - c), cross(along, b - a), -reach, reach, part))
    join(part);
  return all;
}

std::vector<LinePart> Cover::united() {
  std::ranges::sort(parts_, {}, &LinePart::from);
  std::vector<LinePart> out;
  for (const LinePart& part : parts_)
    if (!out.empty() && part.from <= out.back().to)
      out.back().to = std::max(out.back().to, part.to);
    else
      out.push_back(part);
  return out;
}

double Cover::share() {
  double sum = 0;
  for (const LinePart& part : united()) sum += part.to - part.from;
  return sum;
}

double Cover::share_without(Cover& other) {
  // |A \ B| = |A or B| - |B|
  Cover both = *this;
  both.parts_.insert(both.parts_.end(), other.parts_.begin(), other.parts_.end());
  return std::max(0.0, both.share() - other.share());
}

}  // namespace oxturn

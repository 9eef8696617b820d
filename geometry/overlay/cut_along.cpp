#include "geometry/overlay/cut_along.hpp"

#include <cmath>
#include <span>

#include "base/math.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

constexpr double kSharpestMitre = 1;  // radians; at sharper bends both strips end squarely

/// The strip along one segment: a rectangle that extends past an end by half its width, or, where the line goes on,
/// ends at the mitre that it shares with the next one. With a square end it contains a disc of that radius about it, so
/// strips that share a point overlap whatever their directions. Overlaps at each small bend would leave steps there.
struct Strip {
  Point a, b, along;  // unit vector
  Point left[2], right[2];
  Strip(const Point& from, const Point& to, double width) : a(from), b(to) {
    const double size = distance(a, b);
    along = size > 0 ? Point((b - a) / size) : Point(1, 0);
    const Point ahead = along * (width / 2), across = perpendicular(ahead);
    left[0] = a - ahead + across, left[1] = b + ahead + across;
    right[0] = a - ahead - across, right[1] = b + ahead - across;
  }
};

/// Mitres the end of a strip and the beginning of the next, if the bend is not sharp for their lengths: false if it is.
bool join(Strip& one, Strip& next, double width) {
  const double turn = math::atan2(cross(one.along, next.along), one.along.dot(next.along));
  const double shift = width / 2 * std::abs(math::tan(turn / 2));  // of the mitre's ends along the strips
  if (std::abs(turn) > kSharpestMitre || 2 * shift > std::min(distance(one.a, one.b), distance(next.a, next.b)))
    return false;
  const Point middle = one.along + next.along;  // of length 2 cos(turn / 2)
  const Point aside = perpendicular(middle) * (width / middle.squaredNorm());
  one.left[1] = next.left[0] = one.b + aside;
  one.right[1] = next.right[0] = one.b - aside;
  return true;
}

/// Of strips that share their mitres. Where they overlap, it has winding numbers above 1.
Ring outline(std::span<const Strip> strips) {
  Ring ring{strips.front().right[0]};
  for (const Strip& strip : strips) ring.push_back(strip.right[1]);
  for (std::size_t i = strips.size(); i-- > 0;) ring.push_back(strips[i].left[1]);
  ring.push_back(strips.front().left[0]);
  return ring;
}

void append_strips(const Polyline& line, double width, std::vector<Region>& out) {
  std::vector<Strip> strips;
  if (line.size() == 1) strips.push_back({line[0], line[0], width});
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i - 1] != line[i] || line.size() == 2) strips.push_back({line[i - 1], line[i], width});
  for (std::size_t first = 0, i = 1; i <= strips.size(); ++i)
    if (i == strips.size() || !join(strips[i - 1], strips[i], width)) {
      out.push_back({{{outline(std::span(strips).subspan(first, i - first)), {}}}});
      first = i;
    }
}

}  // namespace

Region cut_along(const Region& region, const std::vector<Polyline>& lines, double width) {
  const Box box = bounding_box(region);
  if (box.empty()) return region;
  if (!(width > std::ldexp(box.size().maxCoeff(), -26)))
    throw_invalid("cuts are too narrow for the size of the region; widen them");
  std::vector<Region> strips;
  for (const Polyline& line : lines) {
    for (const Point& p : line)
      if (!finite(p)) throw_invalid("a line to cut a region along has a point that is not finite");
    append_strips(line, width, strips);
  }
  if (strips.empty()) return region;
  return subtract(region, strips);
}

}  // namespace oxturn

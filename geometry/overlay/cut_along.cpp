#include "geometry/overlay/cut_along.hpp"

#include <cmath>

#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

/// A rectangle about the segment that extends past both ends by half its width. It contains a disc of that radius about
/// either end, so strips that share a point overlap whatever their directions.
Region strip(const Point& a, const Point& b, double width) {
  const double length = distance(a, b);
  const Point along = length > 0 ? Point((b - a) / length * (width / 2)) : Point(width / 2, 0);
  const Point across = perpendicular(along);
  return {{{{a - along - across, b + along - across, b + along + across, a - along + across}, {}}}};
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
    if (line.size() == 1) strips.push_back(strip(line[0], line[0], width));
    for (std::size_t i = 1; i < line.size(); ++i) strips.push_back(strip(line[i - 1], line[i], width));
  }
  if (strips.empty()) return region;
  return subtract(region, unite(strips));
}

}  // namespace oxturn

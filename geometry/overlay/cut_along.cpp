#include "geometry/overlay/cut_along.hpp"

#include <cmath>
#include <stdexcept>

#include "geometry/overlay/boolean.hpp"

namespace oxturn {

Region cut_along(const Region& region, const std::vector<Polyline>& lines, double width) {
  const Box box = bounding_box(region);
  if (box.empty()) return region;
  if (!(width > std::ldexp(box.size().maxCoeff(), -26)))
    throw std::invalid_argument("slits are too narrow for the size of the region; widen them");
  // Each segment becomes a rectangle that reaches past both ends by half the width: it holds a disc of that radius about
  // either end, so strips that share a point overlap whatever their directions.
  std::vector<Region> strips;
  const auto add = [&](const Point& a, const Point& b) {
    const double long_path = distance(a, b);
    const Point along = long_path > 0 ? Point((b - a) / long_path * (width / 2)) : Point(width / 2, 0);
    const Point across = perpendicular(along);
    strips.push_back({{{{a - along - across, b + along - across, b + along + across, a - along + across}, {}}}});
  };
  for (const Polyline& line : lines) {
    for (const Point& p : line) {
      if (!finite(p)) throw std::invalid_argument("a line to slit a region along has a point that is not finite");
    }
    if (line.size() == 1) add(line[0], line[0]);
    for (std::size_t i = 1; i < line.size(); ++i) add(line[i - 1], line[i]);
  }
  if (strips.empty()) return region;
  return subtract(region, unite(strips));
}

}  // namespace oxturn

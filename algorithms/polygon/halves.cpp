#include "algorithms/polygon/halves.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "algorithms/polygon/distant_holes.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

constexpr double kMargin = 1e-6;  // of the extent: rings nearer to a cut are cut, too

/// The part of a region in one half of its bounding box. Holes that do not reach `cut`, the line between both halves
/// with a margin, are not looked at but in a polygon that does.
Region half_of(const Region& region, const Box& half, const Box& cut) {
  Region part;
  for (const Polygon& polygon : region.polygons) {
    const Box box = bounding_box(polygon.outer);
    if (!box.overlaps(half)) continue;
    if (!box.overlaps(cut)) {
      part.polygons.push_back(polygon);
      continue;
    }
    auto [near, far] = without_holes_off(cut, polygon);
    std::erase_if(far, [&](const Ring& hole) { return !half.contains(hole[0]); });
    Region inside = intersect({{std::move(near)}}, box_region(half.low, half.high));
    if (!put_back(far, inside)) inside = intersect({{polygon}}, box_region(half.low, half.high));
    std::ranges::move(inside.polygons, std::back_inserter(part.polygons));
  }
  return part;
}

void add_halves(Region region, const std::function<bool(const Region&)>& small, std::vector<Region>& parts) {
  if (region.empty()) return;
  if (small(region)) return parts.push_back(std::move(region));
  const Box all = bounding_box(region);
  const bool wide = all.size().x() > all.size().y();
  const Point middle = all.centre();
  const Box low{all.low, wide ? Point(middle.x(), all.high.y()) : Point(all.high.x(), middle.y())};
  const Box high{wide ? Point(middle.x(), all.low.y()) : Point(all.low.x(), middle.y()), all.high};
  Box cut{high.low, low.high};
  cut.grow(kMargin * all.size().maxCoeff());
  add_halves(half_of(region, low, cut), small, parts);
  add_halves(half_of(region, high, cut), small, parts);
}

}  // namespace

std::vector<Region> halved_until(const Region& region, const std::function<bool(const Region&)>& small) {
  std::vector<Region> parts;
  add_halves(region, small, parts);
  return parts;
}

}  // namespace oxturn

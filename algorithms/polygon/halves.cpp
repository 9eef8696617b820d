#include "algorithms/polygon/halves.hpp"

#include <utility>

#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

void add_halves(Region region, const std::function<bool(const Region&)>& small, std::vector<Region>& parts) {
  if (region.empty()) return;
  if (small(region)) return parts.push_back(std::move(region));
  const Box all = bounding_box(region);
  const bool wide = all.size().x() > all.size().y();
  const Point middle = all.centre();
  const Point high = wide ? Point(middle.x(), all.high.y()) : Point(all.high.x(), middle.y());
  const Point low = wide ? Point(middle.x(), all.low.y()) : Point(all.low.x(), middle.y());
  add_halves(intersect(region, box_region(all.low, high)), small, parts);
  add_halves(intersect(region, box_region(low, all.high)), small, parts);
}

}  // namespace

std::vector<Region> halved_until(const Region& region, const std::function<bool(const Region&)>& small) {
  std::vector<Region> parts;
  add_halves(region, small, parts);
  return parts;
}

}  // namespace oxturn

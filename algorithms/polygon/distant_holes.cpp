#include "algorithms/polygon/distant_holes.hpp"

#include "geometry/edge_index.hpp"

namespace oxturn {

std::pair<Polygon, std::vector<Ring>> without_holes_off(const Box& box, const Polygon& polygon) {
  Polygon rest{polygon.outer, {}};
  std::vector<Ring> off;
  for (const Ring& hole : polygon.holes) (bounding_box(hole).overlaps(box) ? rest.holes : off).push_back(hole);
  return {std::move(rest), std::move(off)};
}

bool put_back(const std::vector<Ring>& holes, Region& region) {
  if (holes.empty()) return true;
  std::vector<EdgeIndex> polygons;
  if (region.polygons.size() > 1)
    for (const Polygon& polygon : region.polygons) polygons.emplace_back(Region{{polygon}});
  for (const Ring& hole : holes) {
    std::size_t in = 0;
    while (in < polygons.size() && !polygons[in].contains(hole[0])) ++in;
    if (in == region.polygons.size()) return false;
    region.polygons[in].holes.push_back(hole);
  }
  return true;
}

}  // namespace oxturn

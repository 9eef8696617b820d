#include "algorithms/polygon/distant_holes.hpp"

#include "geometry/edge_index.hpp"
#include "geometry/point_outside.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kFewHoles = 16;  // for which an index of the polygons would cost more than it saves

}  // namespace

std::pair<Polygon, std::vector<Ring>> without_holes_off(const Box& box, const Polygon& polygon) {
  Polygon rest{polygon.outer, {}};
  std::vector<Ring> off;
  for (const Ring& hole : polygon.holes) (bounding_box(hole).overlaps(box) ? rest.holes : off).push_back(hole);
  return {std::move(rest), std::move(off)};
}

bool put_back(const std::vector<Ring>& holes, Region& region) {
  if (holes.empty()) return true;
  const std::size_t n = region.polygons.size();
  std::vector<EdgeIndex> indices;
  if (n > 1 && holes.size() > kFewHoles)
    for (const Polygon& polygon : region.polygons) indices.emplace_back(Region{{polygon}});
  const auto holds = [&](std::size_t k, const Point& p) {
    if (n == 1) return true;
    return indices.empty() ? nearly_contains(region.polygons[k], p, 0) : indices[k].contains(p);
  };
  for (const Ring& hole : holes) {
    std::size_t in = 0;
    while (in < n && !holds(in, hole[0])) ++in;
    if (in == n) return false;
    region.polygons[in].holes.push_back(hole);
  }
  return true;
}

}  // namespace oxturn

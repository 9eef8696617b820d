#include "maps/drawings/painted_areas.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "base/disjoint_sets.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kFewVertices = 4500;
constexpr double kMostLength = 6000;
constexpr std::size_t kMostWork = 30'000'000;  // vertices; an overlay takes some 0.3 microseconds for each

}  // namespace

void require_untangled(const std::vector<Ring>& rings) {
  Box box;
  std::size_t vertices = 0;
  for (const Ring& ring : rings) {
    vertices += ring.size();
    box.add(bounding_box(ring));
  }
  if (vertices <= kFewVertices) return;
  const Point size = box.size().cwiseMax(1e-300);
  double length = 0;
  for (const Ring& ring : rings)
    for_each_edge(ring, [&](const Point& a, const Point& b) { length += (b - a).cwiseQuotient(size).norm(); });
  if (length > kMostLength)
    throw std::length_error("the filled curves are too tangled: they may cross millions of times");
}

void PaintedAreas::add(const std::string& element, const Region& region) {
  for (const Polygon& polygon : region.polygons) areas_.push_back({element, polygon, bounding_box(polygon.outer)});
}

void PaintedAreas::erase(const Region& region) {
  unite_overlapping();
  const Box box = bounding_box(region);
  std::vector<Area> left;
  for (Area& area : areas_) {
    if (!area.box.overlaps(box)) {
      left.push_back(std::move(area));
      continue;
    }
    for (const Polygon& polygon : subtract({{area.polygon}}, region).polygons)
      left.push_back({area.element, polygon, bounding_box(polygon.outer), false});
  }
  areas_ = std::move(left);
}

std::vector<FilledArea> PaintedAreas::take() {
  unite_overlapping();
  std::vector<FilledArea> out;
  for (Area& area : areas_) out.push_back({std::move(area.element), std::move(area.polygon), {}});
  areas_.clear();
  return out;
}

bool PaintedAreas::overlap(const Polygon& a, const Polygon& b) {
  work_ += vertex_count({{a}}) + vertex_count({{b}});
  if (work_ > kMostWork) throw std::length_error("too many filled areas lie over each other");
  const Region both = intersect({{a}}, {{b}});
  return area(both) > tolerance_ * perimeter(both);
}

void PaintedAreas::unite_overlapping() {
  DisjointSets sets(areas_.size());
  std::vector<std::size_t> order(areas_.size());  // by left border
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return areas_[i].box.low.x(); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Area& a = areas_[order[k]];
    for (std::size_t m = k + 1; m < order.size() && areas_[order[m]].box.low.x() <= a.box.high.x(); ++m) {
      const Area& b = areas_[order[m]];
      if ((!a.fresh && !b.fresh) || !a.box.overlaps(b.box) || sets.find(order[k]) == sets.find(order[m])) continue;
      if (overlap(a.polygon, b.polygon)) sets.unite(order[k], order[m]);
    }
  }
  std::vector<std::vector<Region>> members(areas_.size());  // by set
  for (std::size_t i = 0; i < areas_.size(); ++i) members[sets.find(i)].push_back({{areas_[i].polygon}});
  std::vector<Area> united;
  for (std::size_t i = 0; i < areas_.size(); ++i) {  // a set comes where its first area stands
    std::vector<Region>& parts = members[sets.find(i)];
    if (parts.empty()) continue;
    const Region all = parts.size() == 1 ? parts.front() : unite(parts);
    for (const Polygon& polygon : all.polygons)
      united.push_back({areas_[i].element, polygon, bounding_box(polygon.outer), false});
    parts.clear();
  }
  areas_ = std::move(united);
}

}  // namespace oxturn

#include "geometry/ring_boxes.hpp"

#include <array>
#include <optional>
#include <utility>

#include "base/sorting.hpp"

namespace oxturn {
namespace {

/// Counter-clockwise.
std::array<Point, 4> vertices_of(const Box& box) {
  return {box.low, Point(box.high.x(), box.low.y()), box.high, Point(box.low.x(), box.high.y())};
}

/// The part of a ring on one side of a line parallel to an axis: sign * p[axis] <= sign * limit. It runs along the line
/// where the ring is beyond it (Sutherland and Hodgman 1974).
Ring clipped(const Ring& ring, int axis, double sign, double limit) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool a_in = sign * a[axis] <= sign * limit, b_in = sign * b[axis] <= sign * limit;
    if (a_in) kept.push_back(a);
    if (a_in == b_in) continue;
    kept.push_back(lerp(a, b, (limit - a[axis]) / (b[axis] - a[axis])));
    kept.back()[axis] = limit;
  }
  return kept;
}

}  // namespace

BoxIndex::BoxIndex(std::vector<Box> boxes)
    : boxes_(std::move(boxes)), grid_(boxes_.size(), [&](std::size_t i) { return vertices_of(boxes_[i]); }) {}

std::vector<std::uint32_t> BoxIndex::overlapping(const Box& box) const {
  std::vector<std::uint32_t> found;
  grid_.visit_items(vertices_of(box), 0, [&](std::uint32_t i) {
    found.push_back(i);
    return false;
  });
  sort_unique(found);
  std::erase_if(found, [&](std::uint32_t i) { return !boxes_[i].overlaps(box); });
  return found;
}

RingBoxes::RingBoxes(const Region& region) : region_(region) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < region.polygons.size(); ++i) {
    rings_.push_back({i, 0});
    boxes.push_back(bounding_box(region.polygons[i].outer));
    for (std::size_t k = 0; k < region.polygons[i].holes.size(); ++k) {
      rings_.push_back({i, k + 1});
      boxes.push_back(bounding_box(region.polygons[i].holes[k]));
    }
  }
  boxes_ = BoxIndex(std::move(boxes));
}

Region RingBoxes::near(std::span<const Box> boxes) const {
  std::vector<std::uint32_t> rings;
  for (const Box& box : boxes) {
    const std::vector<std::uint32_t> overlapping = boxes_.overlapping(box);
    rings.insert(rings.end(), overlapping.begin(), overlapping.end());
  }
  sort_unique(rings);
  Region found;
  std::optional<std::size_t> last;  // polygon
  for (const std::uint32_t i : rings) {
    const Where& ring = rings_[i];
    const Polygon& polygon = region_.polygons[ring.polygon];
    if (ring.hole == 0) {
      found.polygons.push_back({polygon.outer, {}});
      last = ring.polygon;
    } else if (last == ring.polygon) {
      found.polygons.back().holes.push_back(polygon.holes[ring.hole - 1]);
    }
  }
  return found;
}

Region clipped(Region region, const Box& box) {
  for (Polygon& polygon : region.polygons)
    for (int axis = 0; axis < 2; ++axis) {
      polygon.outer = clipped(polygon.outer, axis, 1, box.high[axis]);
      polygon.outer = clipped(polygon.outer, axis, -1, box.low[axis]);
    }
  std::erase_if(region.polygons, [](const Polygon& polygon) { return polygon.outer.size() < 3; });
  return region;
}

}  // namespace oxturn

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

}  // namespace

BoxIndex::BoxIndex(std::vector<Box> boxes)
    : boxes_(std::move(boxes)), grid_(boxes_.size(), [&](std::size_t i) { return vertices_of(boxes_[i]); }) {}

std::vector<std::uint32_t> BoxIndex::overlapping(const Box& box) const {
  std::vector<std::uint32_t> found;
  grid_.visit(vertices_of(box), 0, [&](std::size_t cell) {
    const auto items = grid_.items(cell);
    found.insert(found.end(), items.begin(), items.end());
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

Region RingBoxes::near(const Box& box) const {
  Region found;
  std::optional<std::size_t> last;  // polygon
  for (const std::uint32_t i : boxes_.overlapping(box)) {
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

}  // namespace oxturn

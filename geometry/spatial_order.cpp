#include "geometry/spatial_order.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace oxturn {
namespace {

/// Position along Morton's curve of a point in the unit square.
std::uint64_t morton(double x, double y) {
  std::uint64_t code = 0;
  const auto i = static_cast<std::uint32_t>(x * 65535), j = static_cast<std::uint32_t>(y * 65535);
  for (int bit = 15; bit >= 0; --bit) code = (code << 2) | ((i >> bit & 1u) << 1) | (j >> bit & 1u);
  return code;
}

}  // namespace

std::vector<std::size_t> spatial_order(const std::vector<Box>& boxes) {
  Box whole;
  for (const Box& box : boxes) whole.add(box);
  const Point size = whole.size().cwiseMax(1e-300);
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    const Point at = (boxes[i].centre() - whole.low).cwiseQuotient(size).cwiseMax(0).cwiseMin(1);
    order.emplace_back(morton(at.x(), at.y()), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> indices;
  indices.reserve(order.size());
  for (const auto& [code, i] : order) indices.push_back(i);
  return indices;
}

void put_neighbours_together(Region& region) {
  std::vector<Box> boxes;
  for (const Polygon& polygon : region.polygons) boxes.push_back(bounding_box(polygon.outer));
  std::vector<Polygon> ordered;
  for (const std::size_t k : spatial_order(boxes)) ordered.push_back(std::move(region.polygons[k]));
  region.polygons = std::move(ordered);
}

}  // namespace oxturn

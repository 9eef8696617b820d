#include "algorithms/lanes/nearby_segments.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "geometry/uniform_grid.hpp"

namespace oxturn {

NearbySegments::NearbySegments(const Polyline& path) : path_(path), held_(path.size() - 1) {
  std::iota(held_.begin(), held_.end(), 0U);
  build();
}

NearbySegments::NearbySegments(const Polyline& path, const std::vector<Point>& points, double within) : path_(path) {
  const UniformGrid grid(points.size(), [&](std::size_t i) { return std::span(&points[i], 1); });
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const std::span ends(&path[k], 2);
    const bool is_near = grid.visit_items(
        ends, within, [&](std::uint32_t i) { return distance_to_segment(points[i], ends[0], ends[1]) <= within; });
    if (is_near) held_.push_back(static_cast<std::uint32_t>(k));
  }
  build();
}

void NearbySegments::build() {
  std::vector<Box> boxes(held_.size());
  for (std::size_t i = 0; i < held_.size(); ++i) {
    boxes[i].add(path_[held_[i]]);
    boxes[i].add(path_[held_[i] + 1]);
  }
  index_ = BoxIndex(std::move(boxes));
}

std::vector<NearbySegments::Near> NearbySegments::near(const Point& p, double within, std::size_t most) const {
  std::vector<Near> all;
  const Point corner(within, within);
  for (const std::uint32_t i : index_.overlapping({p - corner, p + corner})) {
    const std::size_t k = held_[i];
    const Point at = nearest_on_segment(p, path_[k], path_[k + 1]);
    if (distance(at, p) < within) all.push_back({distance(at, p), k, at});
  }
  std::ranges::sort(all, {}, [](const Near& n) { return std::pair(n.distance, n.segment); });
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), most)), all.end());
  return all;
}

}  // namespace oxturn

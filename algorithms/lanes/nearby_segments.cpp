#include "algorithms/lanes/nearby_segments.hpp"

#include <algorithm>
#include <utility>

namespace oxturn {

NearbySegments::NearbySegments(const Polyline& path) : path_(path) {
  std::vector<Box> boxes(path.size() - 1);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    boxes[k].add(path[k]);
    boxes[k].add(path[k + 1]);
  }
  index_ = BoxIndex(std::move(boxes));
}

std::vector<NearbySegments::Near> NearbySegments::near(const Point& p, double within, std::size_t most) const {
  std::vector<Near> all;
  const Point corner(within, within);
  for (const std::size_t k : index_.overlapping({p - corner, p + corner})) {
    const Point at = nearest_on_segment(p, path_[k], path_[k + 1]);
    if (distance(at, p) < within) all.push_back({distance(at, p), k, at});
  }
  std::ranges::sort(all, {}, [](const Near& n) { return std::pair(n.distance, n.segment); });
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), most)), all.end());
  return all;
}

}  // namespace oxturn

#include "geometry/overlay/boolean.hpp"

#include <algorithm>

#include "geometry/overlay/arrangement.hpp"

namespace oxturn {
namespace {

bool in_first(int first, int) { return first > 0; }
bool in_both(int first, int second) { return first > 0 && second > 0; }
bool in_first_only(int first, int second) { return first > 0 && second <= 0; }

Lattice common_lattice(const Region& a, const Region& b) {
  Box box = finite_box(a);
  const Box other = finite_box(b);
  if (!other.empty()) {
    box.add(other.low);
    box.add(other.high);
  }
  return Lattice(box);
}

Region combine(const Region& a, const Region& b, Inside inside) {
  const Lattice lattice = common_lattice(a, b);
  std::vector<OverlayEdge> edges;
  add_region(edges, a, lattice, 1, 0);
  add_region(edges, b, lattice, 0, 1);
  return to_region(rim(std::move(edges), inside), lattice);
}

/// Position along Morton's curve of a point in the unit square: neighbours are united first.
std::uint64_t morton(double x, double y) {
  std::uint64_t code = 0;
  const auto i = static_cast<std::uint32_t>(x * 65535), j = static_cast<std::uint32_t>(y * 65535);
  for (int bit = 15; bit >= 0; --bit) code = (code << 2) | ((i >> bit & 1u) << 1) | (j >> bit & 1u);
  return code;
}

}  // namespace

Region unite(const std::vector<Region>& parts) {
  Box box;
  std::vector<Box> boxes;
  for (const Region& p : parts) {
    boxes.push_back(finite_box(p));
    if (boxes.back().empty()) continue;
    box.add(boxes.back().low);
    box.add(boxes.back().high);
  }
  if (box.empty()) return {};
  const Lattice lattice(box);

  // In groups of neighbours, then groups of groups: parts that overlap many deep cost the sum, not the square.
  constexpr std::size_t kGroup = 32;
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  const Point size = box.size().cwiseMax(1e-300);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (boxes[i].empty()) continue;
    const Point at = (boxes[i].centre() - box.low).cwiseQuotient(size).cwiseMax(0).cwiseMin(1);
    order.emplace_back(morton(at.x(), at.y()), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::vector<BoundaryEdge>> level;
  for (std::size_t i = 0; i < order.size(); i += kGroup) {
    std::vector<OverlayEdge> edges;
    for (std::size_t k = i; k < std::min(i + kGroup, order.size()); ++k)
      add_region(edges, parts[order[k].second], lattice, 1, 0);
    level.push_back(rim(std::move(edges), in_first));
  }
  while (level.size() > 1) {
    std::vector<std::vector<BoundaryEdge>> above;
    for (std::size_t i = 0; i < level.size(); i += kGroup) {
      std::vector<OverlayEdge> edges;
      for (std::size_t k = i; k < std::min(i + kGroup, level.size()); ++k) add_boundary(edges, level[k], 1, 0);
      above.push_back(rim(std::move(edges), in_first));
    }
    level.swap(above);
  }
  return to_region(level.front(), lattice);
}

Region intersect(const Region& a, const Region& b) { return combine(a, b, in_both); }
Region subtract(const Region& a, const Region& b) { return combine(a, b, in_first_only); }

}  // namespace oxturn

#include "geometry/mesh/partition.hpp"
#include "geometry/mesh/plane_sweep.hpp"

namespace oxturn {

std::vector<Ring> trapezoid_partition(const Region& region) {
  std::vector<Ring> parts;
  for (const PlaneSweepCell& c : plane_sweep_cells(region, Cuts::every_vertex)) {
    Ring ring;
    const auto add = [&](const Point& p) {
      if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
    };
    for (const ChainPoint& p : c.lower) add(p.point);
    for (std::size_t i = c.upper.size(); i-- > 0;) add(c.upper[i].point);
    if (ring.size() >= 3) parts.push_back(std::move(ring));
  }
  return parts;
}

}  // namespace oxturn

#include "geometry/overlay/divided.hpp"

#include "geometry/overlay/arrangement.hpp"

namespace oxturn {

DividedRegion divided(const Region& region, const Region& by) {
  Box box = finite_box(region);
  box.add(finite_box(by));
  const Lattice lattice(box);
  std::vector<OverlayEdge> edges;
  add_region(edges, region, lattice, {1, 0});
  add_region(edges, by, lattice, {0, 1});
  const auto [outside, inside] =
      boundaries_of(std::move(edges), {[](Windings v) { return v.first > 0 && v.second <= 0; },
                                       [](Windings v) { return v.first > 0 && v.second > 0; }});
  return {to_region(outside, lattice), to_region(inside, lattice)};
}

}  // namespace oxturn

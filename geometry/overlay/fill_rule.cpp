#include "geometry/overlay/fill_rule.hpp"

#include "geometry/overlay/arrangement.hpp"

namespace oxturn {

Region enclosed(const std::vector<Ring>& rings, FillRule rule) {
  Region all;  // only for its box
  for (const Ring& ring : rings) all.polygons.push_back({ring, {}});
  const Box box = finite_box(all);
  if (box.empty()) return {};
  const Lattice lattice(box);
  std::vector<OverlayEdge> edges;
  for (const Ring& ring : rings) {
    std::vector<LatticePoint> snapped;
    for (const Point& p : ring)
      if (const LatticePoint q = lattice.snap(p); snapped.empty() || snapped.back() != q) snapped.push_back(q);
    while (snapped.size() > 1 && snapped.back() == snapped.front()) snapped.pop_back();
    if (snapped.size() > 2) add_ring(edges, snapped, {1, 0});
  }
  const Inside inside = rule == FillRule::nonzero ? Inside([](Windings w) { return w.first != 0; })
                                                  : Inside([](Windings w) { return w.first % 2 != 0; });
  return to_region(boundary_of(std::move(edges), inside), lattice);
}

}  // namespace oxturn

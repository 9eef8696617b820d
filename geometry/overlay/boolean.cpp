#include "geometry/overlay/boolean.hpp"

#include <algorithm>
#include <utility>

#include "geometry/overlay/arrangement.hpp"
#include "geometry/spatial_order.hpp"

namespace oxturn {
namespace {

/// Two regions on a lattice of their own, counted first and second.
struct Overlay {
  Lattice lattice;
  std::vector<OverlayEdge> edges = {};

  static Lattice lattice_of(const Region& a, const Region& b) {
    Box box = finite_box(a);
    box.add(finite_box(b));
    return Lattice(box);
  }
  Overlay(const Region& a, const Region& b) : lattice(lattice_of(a, b)) {
    edges.reserve(vertex_count(a) + vertex_count(b));
    add_region(edges, a, lattice, {1, 0});
    add_region(edges, b, lattice, {0, 1});
  }
};

Region combine(const Region& a, const Region& b, Inside inside) {
  Overlay overlay(a, b);
  return to_region(boundary_of(std::move(overlay.edges), inside), overlay.lattice);
}

using Boundaries = std::vector<std::vector<BoundaryEdge>>;
constexpr std::size_t kGroup = 16;  // parts that are united at a time
constexpr std::size_t kFew = 32;    // parts that need not be united

/// The boundaries of the unions of groups of consecutive items; add(edges, k) adds item k of n to an overlay.
template <class Add>
Boundaries united_groups(std::size_t n, Add add_item) {
  Boundaries unions;
  for (std::size_t i = 0; i < n; i += kGroup) {
    std::vector<OverlayEdge> edges;
    for (std::size_t k = i; k < std::min(i + kGroup, n); ++k) add_item(edges, k);
    unions.push_back(boundary_of(std::move(edges), inside_first));
  }
  return unions;
}

std::size_t edge_count(const std::vector<Region>& parts) {
  std::size_t n = 0;
  for (const Region& p : parts) n += vertex_count(p);
  return n;
}
std::size_t edge_count(const Boundaries& boundaries) {
  std::size_t n = 0;
  for (const std::vector<BoundaryEdge>& b : boundaries) n += b.size();
  return n;
}

/// The parts as unions of some of them. Groups of neighbours are united first, then groups of groups, as long as that
/// halves their edges: parts that overlap many deep cost their sum, not its square.
Boundaries few_unions(const std::vector<Region>& parts, const std::vector<Box>& boxes, const Lattice& lattice) {
  const std::vector<std::size_t> order = spatial_order(boxes);
  std::size_t before = edge_count(parts);
  Boundaries unions = united_groups(order.size(), [&](std::vector<OverlayEdge>& edges, std::size_t k) {
    add_region(edges, parts[order[k]], lattice, {1, 0});
  });
  for (std::size_t edges = edge_count(unions); unions.size() > kGroup && 2 * edges < before;) {
    unions = united_groups(unions.size(), [&](std::vector<OverlayEdge>& sum, std::size_t k) {
      add_boundary(sum, unions[k], {1, 0});
    });
    before = std::exchange(edges, edge_count(unions));
  }
  return unions;
}

std::vector<Box> finite_boxes(const std::vector<Region>& parts) {
  std::vector<Box> boxes;
  boxes.reserve(parts.size());
  for (const Region& p : parts) boxes.push_back(finite_box(p));
  return boxes;
}

/// What lies `inside` of a region, counted first, and the parts, counted second.
Region combine(const Region& a, const std::vector<Region>& parts, Inside inside) {
  const std::vector<Box> boxes = finite_boxes(parts);
  Box box = finite_box(a);
  for (const Box& b : boxes) box.add(b);
  if (box.empty()) return {};
  const Lattice lattice(box);
  std::vector<OverlayEdge> edges;
  if (parts.size() <= kFew) {
    edges.reserve(vertex_count(a) + edge_count(parts));
    for (const Region& p : parts) add_region(edges, p, lattice, {0, 1});
  } else {
    const Boundaries unions = few_unions(parts, boxes, lattice);
    edges.reserve(vertex_count(a) + edge_count(unions));
    for (const auto& boundary : unions) add_boundary(edges, boundary, {0, 1});
  }
  add_region(edges, a, lattice, {1, 0});
  return to_region(boundary_of(std::move(edges), inside), lattice);
}

bool in_second(Windings w) { return w.second > 0; }

}  // namespace

Region unite(const std::vector<Region>& parts) { return combine({}, parts, in_second); }
Region intersect(const Region& a, const Region& b) { return combine(a, b, inside_both); }
Region subtract(const Region& a, const Region& b) { return combine(a, b, inside_first_only); }
Region subtract(const Region& a, const std::vector<Region>& parts) { return combine(a, parts, inside_first_only); }

DividedRegion divided(const Region& region, const Region& by) {
  Overlay overlay(region, by);
  const auto [outside, inside] = boundaries_of(std::move(overlay.edges), {inside_first_only, inside_both});
  return {to_region(outside, overlay.lattice), to_region(inside, overlay.lattice)};
}

}  // namespace oxturn

// Method      Crossings are searched among close pairs of edges, with exact predicates. A region whose overlay on the
//             integer lattice gives back its own rings is canonical already and keeps its coordinates to the last bit;
//             any other is replaced by the overlay.
#include "geometry/overlay/validity.hpp"

#include <algorithm>

#include "base/throw_invalid.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/arrangement.hpp"
#include "geometry/overlay/close_pairs.hpp"
#include "geometry/overlay/straight_vertices.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {

Ring without_straight_vertices(const Ring& ring) {
  return without_straight_vertices(
      ring, [](const Point& a, const Point& b, const Point& c) { return orientation(a, b, c) == 0; });
}

namespace {

bool has_three_different_points(const Ring& ring) {
  const Point& a = ring[0];
  const auto b = std::find_if(ring.begin(), ring.end(), [&](const Point& p) { return p != a; });
  return std::any_of(b, ring.end(), [&](const Point& p) { return p != a && p != *b; });
}

struct Edge {
  Point a, b;
};

/// Where two edges cross, rounded, for the message.
Point meeting_point(const Edge& e, const Edge& f) {
  const Point d = e.b - e.a, g = f.b - f.a;
  const double det = cross(d, g);
  return det == 0 ? e.b : lerp(e.a, e.b, std::clamp(cross(f.a - e.a, g) / det, 0.0, 1.0));
}

std::optional<Flaw> find_crossing(const std::vector<Edge>& edges) {
  constexpr double kRounding = 1e-14;  // of the coordinates, in the clipping of close pairs
  double size = 0;
  for (const auto& [a, b] : edges) size = std::max({size, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
  const auto segment = [&](std::size_t i) {
    const auto& [a, b] = edges[i];
    const bool a_first = a.x() <= b.x();
    const Point &left = a_first ? a : b, &right = a_first ? b : a;
    return SegmentPart{left.x(), left.y(), right.x(), right.y(), static_cast<std::uint32_t>(i)};
  };
  std::optional<std::pair<std::uint32_t, std::uint32_t>> first;  // the least pair: independent of the search's order
  for_close_pairs(edges.size(), segment, size * kRounding, {}, [&](std::uint32_t i, std::uint32_t j) {
    const std::pair pair(std::min(i, j), std::max(i, j));
    if ((!first || pair < *first) && crossing(edges[i].a, edges[i].b, edges[j].a, edges[j].b) == Crossing::proper)
      first = pair;
  });
  if (!first) return std::nullopt;
  return Flaw{"edges cross", meeting_point(edges[first->first], edges[first->second])};
}

/// A point inside the ring: in the middle of the widest intersection with a horizontal line, which lies in the middle
/// of the largest gap between the heights of vertices.
Point inner_point(const Ring& ring) {
  std::vector<double> heights;
  for (const Point& p : ring) heights.push_back(p.y());
  std::sort(heights.begin(), heights.end());
  double y = heights.front(), gap = -1;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    if (heights[i] - heights[i - 1] <= gap) continue;
    gap = heights[i] - heights[i - 1];
    y = heights[i - 1] + gap / 2;
  }
  std::vector<double> crossings;
  for_each_edge(ring, [&](const Point& a, const Point& b) {
    if ((a.y() <= y) != (b.y() <= y)) crossings.push_back(a.x() + (b.x() - a.x()) * ((y - a.y()) / (b.y() - a.y())));
  });
  std::sort(crossings.begin(), crossings.end());
  Point best = ring[0];
  double width = -1;
  for (std::size_t i = 1; i < crossings.size(); i += 2) {
    if (crossings[i] - crossings[i - 1] <= width) continue;
    width = crossings[i] - crossings[i - 1];
    best = {crossings[i - 1] + width / 2, y};
  }
  return best;
}

/// No edges cross, so a hole with one vertex inside its polygon lies in it, though it may touch the boundary.
bool lies_outside(const Ring& hole, const EdgeIndex& outer) {
  const auto is_inside = [&](const Point& p) { return outer.contains(p) && !outer.on_boundary(p); };
  if (std::any_of(hole.begin(), hole.end(), is_inside)) return false;
  return !std::all_of(hole.begin(), hole.end(), [&](const Point& p) { return outer.on_boundary(p); }) ||
         !is_inside(inner_point(hole));
}

/// What is wrong with a ring by itself, crossings apart.
std::optional<Flaw> find_ring_flaw(const Ring& ring) {
  for (const Point& p : ring)
    if (!finite(p)) return Flaw{"coordinate is not a finite number", p};
  if (ring.empty() || !has_three_different_points(ring))
    return Flaw{"ring has fewer than 3 different points", ring.empty() ? Point(0, 0) : ring[0]};
  return std::nullopt;
}

bool same(const Region& r, const Region& s) {
  return std::equal(r.polygons.begin(), r.polygons.end(), s.polygons.begin(), s.polygons.end(),
                    [](const Polygon& p, const Polygon& q) { return p.outer == q.outer && p.holes == q.holes; });
}

/// `first` counts outer rings (+1), `second` holes (-1): an island in a hole counts 2 - 1. Away from holes, a ring that
/// passes through itself at a vertex has a part that counts -1 and belongs to the region nevertheless.
bool in_outers_not_in_holes(Windings w) { return w.second == 0 ? w.first != 0 : w.first + w.second > 0; }

/// Without straight vertices, rings in their orientation.
Region cleaned(Region region) {
  const auto clean = [](Ring& ring, double sign) {
    ring = without_straight_vertices(ring);
    if (signed_area(ring) * sign < 0) std::reverse(ring.begin(), ring.end());
  };
  for (Polygon& p : region.polygons) {
    clean(p.outer, 1);
    for (Ring& h : p.holes) clean(h, -1);
  }
  return region;
}

}  // namespace

std::optional<Flaw> find_flaw(const Region& region) {
  std::optional<Flaw> flaw;
  std::vector<Edge> edges;
  for_each_ring(region, [&](const Ring& r) {
    if (flaw || (flaw = find_ring_flaw(r))) return;
    const Ring ring = without_straight_vertices(r);
    if (ring.empty()) flaw = Flaw{"ring has no area", r[0]};
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) edges.push_back({ring[j], ring[i]});
  });
  if (flaw || (flaw = find_crossing(edges))) return flaw;
  for (const Polygon& p : region.polygons) {
    if (p.holes.empty()) continue;
    const EdgeIndex outer(Region{{{p.outer, {}}}});
    for (const Ring& h : p.holes)
      if (lies_outside(h, outer)) return Flaw{"hole lies outside its polygon", h[0]};
  }
  return std::nullopt;
}

Region repaired(const Region& region) {
  if (const auto flaw = find_flaw(region))
    throw_invalid("{} at ({}, {}); expected polygons whose edges do not cross, with holes inside them", flaw->reason,
                  flaw->point.x(), flaw->point.y());
  Region clean = cleaned(region);
  const Lattice lattice(bounding_box(clean));
  std::vector<OverlayEdge> edges;
  Region expected;  // the overlay's result if there is nothing to repair
  const auto add = [&](const Ring& ring, Windings weight) {
    std::vector<LatticePoint> points;
    for (const Point& p : ring) points.push_back(lattice.snap(p));
    add_ring(edges, points, weight);
    return canonical_ring(points, lattice);
  };
  for (const Polygon& p : clean.polygons) {
    expected.polygons.push_back({add(p.outer, {1, 0}), {}});
    for (const Ring& h : p.holes) expected.polygons.back().holes.push_back(add(h, {0, 1}));
  }
  put_in_order(expected);
  Region overlay = to_region(boundary_of(std::move(edges), in_outers_not_in_holes), lattice);
  return same(expected, overlay) ? clean : overlay;
}

}  // namespace oxturn

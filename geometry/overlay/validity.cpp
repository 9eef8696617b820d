// Crossings are looked for among close pairs with exact predicates. A region whose overlay on the integer lattice
// gives its own rings back is sound, and keeps its coordinates to the last bit; any other is replaced by the overlay.
#include "geometry/overlay/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/overlay/arrangement.hpp"
#include "geometry/overlay/close_pairs.hpp"
#include "geometry/predicates.hpp"
#include "geometry/overlay/straight_vertices.hpp"

namespace oxturn {
namespace {

Ring cleaned(const Ring& ring) {
  return without_straight_vertices(
      ring, [](const Point& a, const Point& b, const Point& c) { return orientation(a, b, c) == 0; });
}

bool three_different(const Ring& ring) {
  const Point& a = ring[0];
  const auto b = std::find_if(ring.begin(), ring.end(), [&](const Point& p) { return p != a; });
  return std::any_of(b, ring.end(), [&](const Point& p) { return p != a && p != *b; });
}

struct Edge {
  Point a, b;
};

/// Where two edges cross, for the message.
Point meeting(const Edge& e, const Edge& f) {
  const Point d = e.b - e.a, g = f.b - f.a;
  const double det = cross(d, g);
  return det == 0 ? e.b : lerp(e.a, e.b, std::clamp(cross(f.a - e.a, g) / det, 0.0, 1.0));
}

std::optional<Flaw> find_crossing(const std::vector<Edge>& edges) {
  double size = 0;
  for (const auto& [a, b] : edges) size = std::max({size, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
  const auto stretch = [&](std::size_t i) {
    const auto& [a, b] = edges[i];
    const bool east = a.x() <= b.x();
    const Point &west = east ? a : b, &other = east ? b : a;
    return SegmentPart{west.x(), west.y(), other.x(), other.y(), static_cast<std::uint32_t>(i)};
  };
  std::pair<std::uint32_t, std::uint32_t> first{0xffffffffu, 0};  // the least pair: independent of search order
  for_close_pairs(edges.size(), stretch, size * 1e-14, {}, [&](std::uint32_t i, std::uint32_t j) {
    const std::pair pair(std::min(i, j), std::max(i, j));
    if (pair < first && crossing(edges[i].a, edges[i].b, edges[j].a, edges[j].b) == Crossing::proper) first = pair;
  });
  if (first.first == 0xffffffffu) return std::nullopt;
  return Flaw{"edges cross", meeting(edges[first.first], edges[first.second])};
}

/// Edges of a ring by rows, for point location.
class Rows {
 public:
  explicit Rows(const Ring& ring) : ring_(ring) {
    Box box;
    for (const Point& p : ring) box.add(p);
    low_ = box.low.y();
    const std::size_t n = std::max<std::size_t>(1, ring.size() / 4);
    const double height = box.size().y();
    scale_ = height > 0 ? static_cast<double>(n) / height : 0;
    rows_.resize(n);
    for (std::uint32_t i = 0; i < ring.size(); ++i) {
      const auto [a, b] = edge(i);
      const std::size_t last = row(std::max(a.y(), b.y()));
      for (std::size_t r = row(std::min(a.y(), b.y())); r <= last; ++r) rows_[r].push_back(i);
    }
  }
  /// +1 inside, 0 on the ring, -1 outside.
  int side(const Point& p) const {
    bool odd = false;
    for (const std::uint32_t i : rows_[row(p.y())]) {
      const auto [a, b] = edge(i);
      if (on_segment(p, a, b)) return 0;
      const bool up = a.y() <= p.y();
      if (up == (b.y() <= p.y()) || (a.x() < p.x() && b.x() < p.x())) continue;
      if ((orientation(a, b, p) > 0) == up) odd = !odd;
    }
    return odd ? 1 : -1;
  }

 private:
  Edge edge(std::size_t i) const { return {ring_[i], ring_[i + 1 == ring_.size() ? 0 : i + 1]}; }
  std::size_t row(double y) const {
    const double r = std::floor((y - low_) * scale_);
    return static_cast<std::size_t>(std::clamp(r, 0.0, static_cast<double>(rows_.size() - 1)));
  }
  const Ring& ring_;
  double low_ = 0, scale_ = 0;
  std::vector<std::vector<std::uint32_t>> rows_;
};

/// A point inside the ring, well away from its corners' heights.
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
  std::vector<double> across;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point &a = ring[j], &b = ring[i];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    across.push_back(a.x() + (b.x() - a.x()) * ((y - a.y()) / (b.y() - a.y())));
  }
  std::sort(across.begin(), across.end());
  Point best = ring[0];
  double width = -1;
  for (std::size_t i = 1; i < across.size(); i += 2) {
    if (across[i] - across[i - 1] <= width) continue;
    width = across[i] - across[i - 1];
    best = {across[i - 1] + width / 2, y};
  }
  return best;
}

/// No edges cross, so a hole with any corner inside its polygon is, at worst, partly cut out at the border.
bool outside(const Ring& hole, const Rows& outer) {
  bool some_outside = false;
  for (const Point& p : hole) {
    const int side = outer.side(p);
    if (side > 0) return false;
    some_outside = some_outside || side < 0;
  }
  return some_outside || outer.side(inner_point(hole)) <= 0;
}

bool same(const Region& r, const Region& s) {
  return std::equal(r.polygons.begin(), r.polygons.end(), s.polygons.begin(), s.polygons.end(),
                    [](const Polygon& p, const Polygon& q) { return p.outer == q.outer && p.holes == q.holes; });
}

/// Outer rings wind +1, holes -1: an island in a hole counts 2 - 1. Away from holes, a ring that runs through itself
/// at a corner has one part that winds -1: that is no less a part of it.
bool outers_less_holes(int first, int second) { return second == 0 ? first != 0 : first + second > 0; }

}  // namespace

std::optional<Flaw> find_flaw(const Region& region) {
  std::optional<Flaw> flaw;
  std::vector<Edge> edges;
  for_each_ring(region, [&](const Ring& r) {
    if (flaw) return;
    for (const Point& p : r)
      if (!finite(p)) {
        flaw = Flaw{"coordinate is not a finite number", p};
        return;
      }
    if (r.empty() || !three_different(r)) {
      flaw = Flaw{"ring has fewer than 3 different corners", r.empty() ? Point(0, 0) : r[0]};
      return;
    }
    const Ring ring = cleaned(r);
    if (ring.empty()) flaw = Flaw{"ring has no area", r[0]};
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) edges.push_back({ring[j], ring[i]});
  });
  if (flaw) return flaw;
  if ((flaw = find_crossing(edges))) return flaw;
  for (const Polygon& p : region.polygons) {
    if (p.holes.empty()) continue;
    const Rows outer(p.outer);
    for (const Ring& h : p.holes)
      if (outside(h, outer)) return Flaw{"hole lies outside its polygon", h[0]};
  }
  return std::nullopt;
}

Region repaired(const Region& region) {
  if (const auto flaw = find_flaw(region))
    throw std::invalid_argument(fmt::format("{} at ({}, {})", flaw->reason, flaw->point.x(), flaw->point.y()));
  Region clean;
  for (const Polygon& p : region.polygons) {
    const auto oriented = [](const Ring& ring, double sign) {
      Ring r = cleaned(ring);
      if (signed_area(r) * sign < 0) std::reverse(r.begin(), r.end());
      return r;
    };
    clean.polygons.push_back({oriented(p.outer, 1), {}});
    for (const Ring& h : p.holes) clean.polygons.back().holes.push_back(oriented(h, -1));
  }

  const Lattice lattice(bounding_box(clean));
  std::vector<OverlayEdge> edges;
  Region snapped;  // what the overlay gives if nothing is wrong
  const auto add = [&](const Ring& ring, int first, int second) {
    std::vector<Site> sites;
    for (const Point& p : ring) sites.push_back(lattice.snap(p));
    add_ring(edges, sites, first, second);
    return canonical_ring(sites, lattice);
  };
  for (const Polygon& p : clean.polygons) {
    snapped.polygons.push_back({add(p.outer, 1, 0), {}});
    for (const Ring& h : p.holes) snapped.polygons.back().holes.push_back(add(h, 0, 1));
  }
  put_in_order(snapped);
  Region overlay = to_region(rim(std::move(edges), outers_less_holes), lattice);
  return same(snapped, overlay) ? clean : overlay;
}

}  // namespace oxturn

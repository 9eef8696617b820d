#include "geometry/overlay/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/overlay/close_pairs.hpp"
#include "geometry/overlay/edge_below.hpp"
#include "base/spread_sort.hpp"
#include "geometry/overlay/straight_vertices.hpp"

namespace oxturn {
namespace {

/// An edge while it is being split. Loud: it has not met all others yet.
struct Piece {
  OverlayEdge edge;
  bool loud = true;
};

struct Cut {
  std::uint32_t edge;
  Site at;
  friend bool operator==(const Cut&, const Cut&) = default;
};

/// In the order of sites.
std::uint64_t packed(const Site& s) {
  return (std::uint64_t{static_cast<std::uint32_t>(s.x) ^ 0x80000000u} << 32) |
         (static_cast<std::uint32_t>(s.y) ^ 0x80000000u);
}

bool edge_order(const OverlayEdge& e, const OverlayEdge& f) { return e.a != f.a ? e.a < f.a : e.b < f.b; }

/// Does the edge ab bend to p? p within half a quantum (upright for flat edges, sideways for steep ones).
bool passes(const Site& a, const Site& b, const Site& p, std::int64_t twice_area) {
  if (p == a || p == b) return false;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  if (2 * std::abs(twice_area) > std::max(std::abs(dx), std::abs(dy))) return false;
  const std::int64_t along = dx * (std::int64_t{p.x} - a.x) + dy * (std::int64_t{p.y} - a.y);
  return along > 0 && along < dx * dx + dy * dy;
}

/// Where do two edges have to be split for each other's sake?
void split_pair(const std::vector<Piece>& pieces, std::uint32_t i, std::uint32_t j, std::vector<Cut>& cuts) {
  const OverlayEdge &e = pieces[i].edge, &f = pieces[j].edge;
  const std::int64_t ea = turn(f.a, f.b, e.a), eb = turn(f.a, f.b, e.b);
  const std::int64_t fa = turn(e.a, e.b, f.a), fb = turn(e.a, e.b, f.b);
  const std::size_t had = cuts.size();
  if (passes(e.a, e.b, f.a, fa)) cuts.push_back({i, f.a});
  if (passes(e.a, e.b, f.b, fb)) cuts.push_back({i, f.b});
  if (passes(f.a, f.b, e.a, ea)) cuts.push_back({j, e.a});
  if (passes(f.a, f.b, e.b, eb)) cuts.push_back({j, e.b});
  if (cuts.size() != had) return;  // the pieces meet again in the next round
  if (!((ea < 0 && eb > 0) || (ea > 0 && eb < 0)) || !((fa < 0 && fb > 0) || (fa > 0 && fb < 0))) return;
  const double t = static_cast<double>(ea) / (static_cast<double>(ea) - static_cast<double>(eb));
  const Site p{static_cast<std::int32_t>(std::floor(e.a.x + t * (static_cast<double>(e.b.x) - e.a.x) + 0.5)),
               static_cast<std::int32_t>(std::floor(e.a.y + t * (static_cast<double>(e.b.y) - e.a.y) + 0.5))};
  if (p != e.a && p != e.b) cuts.push_back({i, p});
  if (p != f.a && p != f.b) cuts.push_back({j, p});
}

/// Quiet pieces, in order, and loud ones in any order: equal edges become one, edges without weight vanish.
std::vector<Piece> merged(const std::vector<Piece>& quiet, std::vector<Piece>& loud) {
  spread_sort(
      loud, [](const Piece& p) { return packed(p.edge.a); },
      [](const Piece& p, const Piece& q) { return edge_order(p.edge, q.edge); });
  std::vector<Piece> out;
  out.reserve(quiet.size() + loud.size());
  const auto settle = [&] {
    if (!out.empty() && out.back().edge.first == 0 && out.back().edge.second == 0) out.pop_back();
  };
  const auto add = [&](const Piece& p) {
    if (!out.empty() && out.back().edge.a == p.edge.a && out.back().edge.b == p.edge.b) {
      out.back().edge.first += p.edge.first;
      out.back().edge.second += p.edge.second;
      out.back().loud = out.back().loud && p.loud;  // a quiet edge there has met everything already
    } else {
      settle();
      out.push_back(p);
    }
  };
  auto q = quiet.begin();
  for (const Piece& p : loud) {
    for (; q != quiet.end() && !edge_order(p.edge, q->edge); ++q) add(*q);
    add(p);
  }
  for (; q != quiet.end(); ++q) add(*q);
  settle();
  return out;
}

std::vector<Cut> find_cuts(const std::vector<Piece>& pieces) {
  std::vector<std::uint8_t> loud(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) loud[i] = pieces[i].loud ? 1 : 0;
  const auto stretch = [&](std::size_t i) {
    const OverlayEdge& e = pieces[i].edge;
    return SegmentPart{double(e.a.x), double(e.a.y), double(e.b.x), double(e.b.y), static_cast<std::uint32_t>(i)};
  };
  std::vector<Cut> cuts;
  for_close_pairs(pieces.size(), stretch, 1.0, loud,
                  [&](std::uint32_t i, std::uint32_t j) { split_pair(pieces, std::min(i, j), std::max(i, j), cuts); });
  spread_sort(
      cuts, [](const Cut& c) { return std::uint64_t{c.edge}; },
      [](const Cut& c, const Cut& d) { return c.edge != d.edge ? c.edge < d.edge : c.at < d.at; });
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

void append(std::vector<OverlayEdge>& edges, const Site& from, const Site& to, int first, int second) {
  if (from < to)
    edges.push_back({from, to, first, second});
  else if (to < from)
    edges.push_back({to, from, -first, -second});
}

/// Splits until edges meet at common ends only.
void resolve(std::vector<OverlayEdge>& edges) {
  std::vector<Piece> pieces, quiet, loud;
  loud.reserve(edges.size());
  for (const OverlayEdge& e : edges) loud.push_back({e, true});
  pieces = merged(quiet, loud);
  for (int round = 0;; ++round) {
    // Each round moves edges by under a quantum and only next to lattice points already there; three rounds are
    // usual, more than ten unheard of.
    if (round == 200) throw std::runtime_error("overlay of regions does not settle on its lattice");
    const std::vector<Cut> cuts = find_cuts(pieces);
    if (cuts.empty()) break;
    quiet.clear();
    loud.clear();
    std::vector<Site> stops;
    std::vector<OverlayEdge> parts;
    for (std::size_t i = 0, c = 0; i < pieces.size(); ++i) {
      const OverlayEdge e = pieces[i].edge;
      stops.clear();
      for (; c < cuts.size() && cuts[c].edge == i; ++c) stops.push_back(cuts[c].at);
      if (stops.empty()) {
        quiet.push_back({e, false});
        continue;
      }
      const auto along = [&](const Site& s) {
        return (std::int64_t{e.b.x} - e.a.x) * (std::int64_t{s.x} - e.a.x) +
               (std::int64_t{e.b.y} - e.a.y) * (std::int64_t{s.y} - e.a.y);
      };
      std::sort(stops.begin(), stops.end(), [&](const Site& s, const Site& t) {
        const std::int64_t u = along(s), v = along(t);
        return u != v ? u < v : s < t;
      });
      Site at = e.a;
      stops.push_back(e.b);
      parts.clear();
      for (const Site& s : stops) {
        append(parts, at, s, e.first, e.second);
        at = s;
      }
      for (const OverlayEdge& part : parts) loud.push_back({part, true});
    }
    pieces = merged(quiet, loud);
  }
  edges.clear();
  for (const Piece& p : pieces) edges.push_back(p.edge);
}

/// Half-edges round each vertex, counter-clockwise from straight down (exclusive). Half-edge 2e leaves edge e's a,
/// 2e + 1 its b.
struct Fans {
  std::vector<std::uint32_t> start, half, tail;  // fan of v: half[start[v] .. start[v+1]); tail: vertex of half-edge

  template <class Ends>  // Ends(h): {vertex, other end} of half-edge h; edges in the order of their western ends
  Fans(std::size_t half_edges, Ends ends) : half(half_edges), tail(half_edges) {
    struct End {
      std::uint64_t site;
      std::uint32_t half;
    };
    std::vector<End> west(half_edges / 2), east(half_edges / 2);
    for (std::uint32_t h = 0; h < half_edges; h += 2) {
      const auto [a, b] = ends(h);
      const bool eastwards = a < b;
      west[h / 2] = {packed(eastwards ? a : b), eastwards ? h : h + 1};
      east[h / 2] = {packed(eastwards ? b : a), eastwards ? h + 1 : h};
    }
    spread_sort(
        east, [](const End& e) { return e.site; },
        [](const End& e, const End& f) { return e.site != f.site ? e.site < f.site : e.half < f.half; });
    std::uint64_t site = 0;
    for (std::uint32_t k = 0, w = 0, e = 0; k < half_edges; ++k) {
      const End& end = e == east.size() || (w < west.size() && west[w].site <= east[e].site) ? west[w++] : east[e++];
      if (k == 0 || end.site != site) start.push_back(k);
      site = end.site;
      half[k] = end.half;
      tail[end.half] = static_cast<std::uint32_t>(start.size()) - 1;
    }
    start.push_back(static_cast<std::uint32_t>(half_edges));
    const auto angle = [&](std::uint32_t g, std::uint32_t h) {
      const auto [v, p] = ends(g);
      const auto [w, q] = ends(h);
      const bool east_p = v < p, east_q = w < q;
      if (east_p != east_q) return east_p;
      return turn(v, p, q) > 0;
    };
    for (std::size_t v = 0; v < vertices(); ++v) std::sort(half.begin() + start[v], half.begin() + start[v + 1], angle);
  }
  std::size_t vertices() const { return start.size() - 1; }
};

struct Windings {
  int first = 0, second = 0;
};

/// Winding numbers left of each edge (seen from a to b).
std::vector<Windings> wind(const std::vector<OverlayEdge>& edges) {
  const Fans fans(2 * edges.size(), [&](std::size_t h) {
    const OverlayEdge& e = edges[h / 2];
    return h % 2 == 0 ? std::pair(e.a, e.b) : std::pair(e.b, e.a);
  });
  std::vector<EdgeBelow::Edge> slanted;
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    if (edges[i].a.x < edges[i].b.x) slanted.push_back({edges[i].a, edges[i].b, i});
  const EdgeBelow below(std::move(slanted));

  std::vector<Windings> left(edges.size());
  std::vector<std::uint8_t> reached(fans.vertices(), 0);
  std::vector<std::uint32_t> todo;  // half-edges whose edge is known, to be walked round at their tail
  const auto walk = [&](std::size_t position, std::uint32_t v, Windings w) {
    const std::uint32_t begin = fans.start[v], n = fans.start[v + 1] - begin;
    for (std::uint32_t k = 0; k < n; ++k) {  // w: the wedge just before the half-edge
      const std::uint32_t h = fans.half[begin + (position + k) % n];
      const OverlayEdge& e = edges[h / 2];
      if (h % 2 == 0) {
        w.first += e.first;
        w.second += e.second;
      }
      left[h / 2] = w;
      if (h % 2 == 1) {
        w.first -= e.first;
        w.second -= e.second;
      }
      if (!reached[fans.tail[h ^ 1u]]) todo.push_back(h ^ 1u);
    }
  };
  for (std::uint32_t root = 0; root < fans.vertices(); ++root) {  // west to east: what lies below is known
    if (reached[root]) continue;
    reached[root] = 1;
    const std::uint32_t h0 = fans.half[fans.start[root]];
    const Site site = h0 % 2 == 0 ? edges[h0 / 2].a : edges[h0 / 2].b;
    const std::uint32_t e = below.below(site);
    walk(0, root, e == EdgeBelow::kNone ? Windings{} : left[e]);
    while (!todo.empty()) {
      const std::uint32_t h = todo.back();
      todo.pop_back();
      const std::uint32_t v = fans.tail[h];
      if (reached[v]) continue;
      reached[v] = 1;
      std::size_t position = 0;
      while (fans.half[fans.start[v] + position] != h) ++position;
      Windings before = left[h / 2];  // right of h: for an edge's own direction that is the other side
      if (h % 2 == 0) {
        before.first -= edges[h / 2].first;
        before.second -= edges[h / 2].second;
      }
      walk(position, v, before);
    }
  }
  return left;
}

bool straight(const Site& a, const Site& b, const Site& c) { return turn(a, b, c) == 0; }

}  // namespace

Lattice::Lattice(const Box& box) {
  if (box.empty()) return;
  const double extent = std::max(box.size().x(), box.size().y());
  const double far = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  int extent_bits = -1000, far_bits = -1000;
  if (extent > 0) std::frexp(extent, &extent_bits);
  if (far > 0) std::frexp(far, &far_bits);
  // Far from the origin doubles are no finer than far * 2^-52: nor is the lattice, so that placing is exact.
  quantum_ = std::ldexp(1.0, std::max({extent_bits - 30, far_bits - 52, -960}));
  x_ = std::floor(box.centre().x() / quantum_ + 0.5);
  y_ = std::floor(box.centre().y() / quantum_ + 0.5);
}

Site Lattice::snap(const Point& p) const {
  return {static_cast<std::int32_t>(std::floor(p.x() / quantum_ - x_ + 0.5)),
          static_cast<std::int32_t>(std::floor(p.y() / quantum_ - y_ + 0.5))};
}

Point Lattice::place(const Site& s) const { return {(x_ + s.x) * quantum_, (y_ + s.y) * quantum_}; }

Box finite_box(const Region& region) {
  for_each_ring(region, [](const Ring& r) {
    for (const Point& p : r)
      if (!finite(p)) throw std::invalid_argument("region has a coordinate that is not a finite number");
  });
  return bounding_box(region);
}

std::vector<Site> snapped(const Ring& ring, const Lattice& lattice) {
  std::vector<Site> sites;
  for (const Point& p : ring) {
    const Site s = lattice.snap(p);
    if (sites.empty() || sites.back() != s) sites.push_back(s);
  }
  while (sites.size() > 1 && sites.back() == sites.front()) sites.pop_back();
  return sites;
}

void add_ring(std::vector<OverlayEdge>& edges, const std::vector<Site>& ring, int first, int second) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) append(edges, ring[j], ring[i], first, second);
}

void add_region(std::vector<OverlayEdge>& edges, const Region& region, const Lattice& lattice, int first, int second) {
  std::vector<Site> sites;
  const auto add = [&](const Ring& ring, int sign) {
    sites.clear();
    for (const Point& p : ring) sites.push_back(lattice.snap(p));
    if (signed_area(ring) * sign < 0) sign = -sign, std::reverse(sites.begin(), sites.end());
    add_ring(edges, sites, first, second);
  };
  for (const Polygon& p : region.polygons) {
    add(p.outer, 1);
    for (const Ring& h : p.holes) add(h, -1);
  }
}

void add_boundary(std::vector<OverlayEdge>& edges, const std::vector<BoundaryEdge>& rim, int first, int second) {
  for (const BoundaryEdge& e : rim) append(edges, e.from, e.to, first, second);
}

std::vector<BoundaryEdge> rim(std::vector<OverlayEdge> edges, Inside inside) {
  resolve(edges);
  const std::vector<Windings> left = wind(edges);
  std::vector<BoundaryEdge> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const OverlayEdge& e = edges[i];
    const bool l = inside(left[i].first, left[i].second);
    if (l == inside(left[i].first - e.first, left[i].second - e.second)) continue;
    out.push_back(l ? BoundaryEdge{e.a, e.b} : BoundaryEdge{e.b, e.a});
  }
  return out;
}

Ring canonical_ring(const std::vector<Site>& sites, const Lattice& lattice) {
  std::vector<Site> s = without_straight_vertices(sites, straight);
  std::rotate(s.begin(), std::min_element(s.begin(), s.end()), s.end());
  Ring ring;
  ring.reserve(s.size());
  for (const Site& p : s) ring.push_back(lattice.place(p));
  return ring;
}

void put_in_order(Region& region) {
  const auto by_corners = [](const Ring& r, const Ring& s) {
    return std::lexicographical_compare(r.begin(), r.end(), s.begin(), s.end(), before);
  };
  for (Polygon& p : region.polygons) std::sort(p.holes.begin(), p.holes.end(), by_corners);
  std::sort(region.polygons.begin(), region.polygons.end(),
            [&](const Polygon& p, const Polygon& q) { return by_corners(p.outer, q.outer); });
}

Region to_region(const std::vector<BoundaryEdge>& rim, const Lattice& lattice) {
  const Fans fans(2 * rim.size(), [&](std::size_t h) {
    const BoundaryEdge& e = rim[h / 2];
    return h % 2 == 0 ? std::pair(e.from, e.to) : std::pair(e.to, e.from);
  });
  // The next edge round the same inside wedge: clockwise from the way back.
  const auto next = [&](std::uint32_t edge) {
    const std::uint32_t h = 2 * edge + 1, v = fans.tail[h], begin = fans.start[v], n = fans.start[v + 1] - begin;
    std::uint32_t k = 0;
    while (fans.half[begin + k] != h) ++k;
    return fans.half[begin + (k + n - 1) % n] / 2;
  };

  struct Loop {
    std::vector<Site> sites;
    std::uint32_t cycle;  // loops cut from one cycle bound the same face
  };
  std::vector<Loop> loops;
  std::vector<std::uint32_t> cycle_of(rim.size(), 0xffffffffu);
  std::vector<Site> cycle_low;  // westernmost, then southernmost
  std::vector<std::uint32_t> stack_position(fans.vertices(), 0xffffffffu), chain;
  for (std::uint32_t first = 0; first < rim.size(); ++first) {
    if (cycle_of[first] != 0xffffffffu) continue;
    const std::uint32_t cycle = static_cast<std::uint32_t>(cycle_low.size());
    cycle_low.push_back(rim[first].from);
    chain.clear();  // edges walked; where the walk comes back to a vertex, a loop is cut off
    std::uint32_t e = first;
    do {
      cycle_of[e] = cycle;
      cycle_low.back() = std::min(cycle_low.back(), rim[e].from);
      stack_position[fans.tail[2 * e]] = static_cast<std::uint32_t>(chain.size());
      chain.push_back(e);
      const std::uint32_t head = fans.tail[2 * e + 1], at = stack_position[head];
      if (at != 0xffffffffu) {
        Loop loop{{}, cycle};
        for (std::size_t k = at; k < chain.size(); ++k) {
          loop.sites.push_back(rim[chain[k]].from);
          stack_position[fans.tail[2 * chain[k]]] = 0xffffffffu;
        }
        chain.resize(at);
        loops.push_back(std::move(loop));
      }
      e = next(e);
    } while (e != first);
  }

  // Each cycle's polygon: its own counter-clockwise loop, or that of the edge below its westernmost point.
  const auto twice_area = [](const std::vector<Site>& s) {
    double sum = 0;
    for (std::size_t i = 2; i < s.size(); ++i) sum += static_cast<double>(turn(s[0], s[i - 1], s[i]));
    return sum;
  };
  std::vector<std::uint32_t> polygon_of(cycle_low.size(), 0xffffffffu);
  Region region;
  std::vector<const Loop*> holes;
  for (const Loop& loop : loops) {
    if (twice_area(loop.sites) < 0) {
      holes.push_back(&loop);
      continue;
    }
    polygon_of[loop.cycle] = static_cast<std::uint32_t>(region.polygons.size());
    region.polygons.push_back({canonical_ring(loop.sites, lattice), {}});
  }
  if (!holes.empty()) {
    std::vector<EdgeBelow::Edge> slanted;
    for (std::uint32_t i = 0; i < rim.size(); ++i) {
      if (rim[i].from.x == rim[i].to.x) continue;
      const bool east = rim[i].from < rim[i].to;
      slanted.push_back({east ? rim[i].from : rim[i].to, east ? rim[i].to : rim[i].from, i});
    }
    const EdgeBelow below(std::move(slanted));
    std::vector<std::uint32_t> order(cycle_low.size());
    for (std::uint32_t c = 0; c < order.size(); ++c) order[c] = c;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t c, std::uint32_t d) { return cycle_low[c] < cycle_low[d]; });
    for (const std::uint32_t c : order) {
      if (polygon_of[c] != 0xffffffffu) continue;
      const std::uint32_t e = below.below(cycle_low[c]);
      if (e == EdgeBelow::kNone) throw std::logic_error("overlay left a hole without a polygon");
      polygon_of[c] = polygon_of[cycle_of[e]];
    }
    for (const Loop* hole : holes)
      region.polygons[polygon_of[hole->cycle]].holes.push_back(canonical_ring(hole->sites, lattice));
  }
  put_in_order(region);
  return region;
}

}  // namespace oxturn

#include "geometry/overlay/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/disjoint_sets.hpp"
#include "geometry/overlay/close_pairs.hpp"
#include "geometry/overlay/edge_below.hpp"
#include "geometry/overlay/half_edges.hpp"

namespace oxturn {
namespace {

using Edges = std::vector<OverlayEdge>;

/// Sorted edges, while they are being split. Resolved ones have been intersected with all other resolved ones.
struct Pieces {
  Edges edges;
  std::vector<std::uint8_t> unresolved;  // by edge; empty: all are
};

/// A point at which an edge is to be split.
struct Cut {
  std::uint32_t edge;
  LatticePoint at;
  friend bool operator==(const Cut&, const Cut&) = default;
};

/// The greater of an edge's extents in x and y.
std::int32_t wide(const OverlayEdge& e) { return std::max(e.b.x - e.a.x, std::abs(e.b.y - e.a.y)); }

bool edge_order(const OverlayEdge& e, const OverlayEdge& f) { return e.a != f.a ? e.a < f.a : e.b < f.b; }

/// Does the edge bend to p, which lies off its line by `twice_area` of the triangle? It does if p is within half a
/// quantum, measured vertically for flat edges and horizontally for steep ones. Few points pass the first line.
bool bends_to(const OverlayEdge& e, const LatticePoint& p, std::int64_t area) {
  if (2 * std::abs(area) > wide(e)) return false;
  const LatticePoint d = e.b - e.a;
  const std::int64_t along = dot(d, p - e.a);
  return along > 0 && along < dot(d, d);
}

bool opposite_signs(std::int64_t s, std::int64_t t) { return (s < 0 && t > 0) || (s > 0 && t < 0); }

/// Do the edges have a common end, and are they so far from parallel that neither bends to the other's far end? So do
/// most that come near each other: neighbours along a ring.
bool meet_at_an_end_only(const OverlayEdge& e, const OverlayEdge& f) {
  if (e.b != f.a && e.a != f.a && e.b != f.b && e.a != f.b) return false;
  return 2 * std::abs(cross(e.b - e.a, f.b - f.a)) > std::max(wide(e), wide(f));
}

/// The points at which two edges have to be split because of each other.
void add_cuts(const Edges& edges, std::uint32_t i, std::uint32_t j, std::vector<Cut>& cuts) {
  const OverlayEdge &e = edges[i], &f = edges[j];
  const std::int64_t ea = twice_area(f.a, f.b, e.a), eb = twice_area(f.a, f.b, e.b);
  const std::int64_t fa = twice_area(e.a, e.b, f.a), fb = twice_area(e.a, e.b, f.b);
  const std::size_t before = cuts.size();
  if (bends_to(e, f.a, fa)) cuts.push_back({i, f.a});
  if (bends_to(e, f.b, fb)) cuts.push_back({i, f.b});
  if (bends_to(f, e.a, ea)) cuts.push_back({j, e.a});
  if (bends_to(f, e.b, eb)) cuts.push_back({j, e.b});
  if (cuts.size() != before) return;  // if the parts still cross, they do so in the next round
  if (!opposite_signs(ea, eb) || !opposite_signs(fa, fb)) return;
  const double t = static_cast<double>(ea) / (static_cast<double>(ea) - static_cast<double>(eb));
  const LatticePoint p =
      rounded(e.a.x + t * (static_cast<double>(e.b.x) - e.a.x), e.a.y + t * (static_cast<double>(e.b.y) - e.a.y));
  if (p != e.a && p != e.b) cuts.push_back({i, p});
  if (p != f.a && p != f.b) cuts.push_back({j, p});
}

/// Resolved edges, sorted, and unresolved ones, in any order, in one sorted list. Equal edges become one; edges without
/// weight vanish.
void merge(const Edges& resolved, Edges& unresolved, Pieces& out) {
  spread_sort(
      unresolved, [](const OverlayEdge& e) { return sort_key(e.a); }, edge_order);
  out.edges.clear();
  out.unresolved.clear();
  out.edges.reserve(resolved.size() + unresolved.size());
  const bool all = resolved.empty();
  if (!all) out.unresolved.reserve(resolved.size() + unresolved.size());
  const auto drop_weightless = [&] {
    if (out.edges.empty() || out.edges.back().weight != Windings{}) return;
    out.edges.pop_back();
    if (!all) out.unresolved.pop_back();
  };
  const auto add = [&](const OverlayEdge& e, std::uint8_t is_unresolved) {
    if (!out.edges.empty() && out.edges.back().a == e.a && out.edges.back().b == e.b) {
      out.edges.back().weight = out.edges.back().weight + e.weight;
      if (!all) out.unresolved.back() &= is_unresolved;  // an equal edge has been intersected already
    } else {
      drop_weightless();
      out.edges.push_back(e);
      if (!all) out.unresolved.push_back(is_unresolved);
    }
  };
  auto r = resolved.begin();
  for (const OverlayEdge& e : unresolved) {
    for (; r != resolved.end() && !edge_order(e, *r); ++r) add(*r, 0);
    add(e, 1);
  }
  for (; r != resolved.end(); ++r) add(*r, 0);
  drop_weightless();
}

/// The edges within a quantum of the bounding box of those that are not resolved.
std::vector<std::uint32_t> near_unresolved(const Pieces& pieces) {
  const Edges& edges = pieces.edges;
  LatticePoint low{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
  LatticePoint high{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (pieces.unresolved[i] == 0) continue;
    const OverlayEdge& e = edges[i];
    low = {std::min(low.x, e.a.x), std::min({low.y, e.a.y, e.b.y})};
    high = {std::max(high.x, e.b.x), std::max({high.y, e.a.y, e.b.y})};
  }
  low = low - LatticePoint{1, 1};
  high = high + LatticePoint{1, 1};
  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < edges.size() && edges[i].a.x <= high.x; ++i) {
    const OverlayEdge& e = edges[i];
    if (e.b.x >= low.x && std::min(e.a.y, e.b.y) <= high.y && std::max(e.a.y, e.b.y) >= low.y)
      near.push_back(static_cast<std::uint32_t>(i));
  }
  return near;
}

/// Sorted by edge, then point; no repeats.
std::vector<Cut> find_cuts(const Pieces& pieces) {
  const bool all = pieces.unresolved.empty();
  const std::vector<std::uint32_t> near = all ? std::vector<std::uint32_t>{} : near_unresolved(pieces);
  const auto segment = [&](std::size_t k) {
    const std::uint32_t i = all ? static_cast<std::uint32_t>(k) : near[k];
    const OverlayEdge& e = pieces.edges[i];
    return SegmentPart{double(e.a.x), double(e.a.y), double(e.b.x), double(e.b.y), i};
  };
  std::vector<Cut> cuts;
  for_close_pairs(all ? pieces.edges.size() : near.size(), segment, 1.0, pieces.unresolved,
                  [&](std::uint32_t i, std::uint32_t j) {
                    if (!meet_at_an_end_only(pieces.edges[i], pieces.edges[j]))
                      add_cuts(pieces.edges, std::min(i, j), std::max(i, j), cuts);
                  });
  spread_sort(
      cuts, [](const Cut& c) { return std::uint64_t{c.edge}; },
      [](const Cut& c, const Cut& d) { return c.edge != d.edge ? c.edge < d.edge : c.at < d.at; });
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// Calls f(edge) for the edge from p to q, with the given weight to its left; for none if p == q.
template <class F>
void directed(const LatticePoint& p, const LatticePoint& q, Windings weight, F f) {
  if (p < q)
    f(OverlayEdge{p, q, weight});
  else if (q < p)
    f(OverlayEdge{q, p, Windings{} - weight});
}

/// Splits the edges at the cuts. Those without a cut are resolved then and keep their order.
void split(const Edges& edges, const std::vector<Cut>& cuts, Edges& resolved, Edges& unresolved) {
  std::size_t split_edges = 0;
  for (std::size_t c = 0; c < cuts.size(); ++c) split_edges += c == 0 || cuts[c].edge != cuts[c - 1].edge ? 1 : 0;
  resolved.clear();
  resolved.reserve(edges.size() - split_edges);
  unresolved.clear();
  unresolved.reserve(cuts.size() + split_edges);
  std::vector<LatticePoint> stops;
  for (std::size_t i = 0, c = 0; i < edges.size(); ++i) {
    const OverlayEdge e = edges[i];
    stops.clear();
    for (; c < cuts.size() && cuts[c].edge == i; ++c) stops.push_back(cuts[c].at);
    if (stops.empty()) {
      resolved.push_back(e);
      continue;
    }
    std::sort(stops.begin(), stops.end(), [&](const LatticePoint& p, const LatticePoint& q) {
      const std::int64_t u = dot(e.b - e.a, p - e.a), v = dot(e.b - e.a, q - e.a);
      return u != v ? u < v : p < q;
    });
    stops.push_back(e.b);
    LatticePoint at = e.a;
    for (const LatticePoint& stop : stops) {
      directed(at, stop, e.weight, [&](const OverlayEdge& part) { unresolved.push_back(part); });
      at = stop;
    }
  }
}

/// Splits the edges until they meet at common ends only; sorts and merges them.
void resolve(Edges& edges) {
  // A round moves edges by less than a quantum and only to lattice points that are vertices already. Three rounds are
  // usual, more than ten have never been seen.
  constexpr int kMostRounds = 200;
  Edges resolved, unresolved = std::move(edges);
  Pieces pieces;
  merge(resolved, unresolved, pieces);
  for (int round = 0;; ++round) {
    if (round == kMostRounds) throw std::runtime_error("overlay of regions does not converge on its lattice");
    const std::vector<Cut> cuts = find_cuts(pieces);
    if (cuts.empty()) break;
    split(pieces.edges, cuts, resolved, unresolved);
    merge(resolved, unresolved, pieces);
  }
  edges = std::move(pieces.edges);
}

/// Computes the winding numbers to the left of each edge a -> b: component by component, or, where millions of edges do
/// not fit in the processor's cache, from left to right, as they are stored. To follow them wherever they lead takes
/// twice as long then.
class WindingNumbers {
 public:
  explicit WindingNumbers(const std::vector<OverlayEdge>& edges)
      : edges_(edges),
        fans_(edges.size(), Ends{edges}),
        below_(edges.size(), Ends{edges}),
        left_(edges.size()),
        reached_(fans_.vertices(), 0) {}

  std::vector<Windings> run() {
    edges_.size() <= kInCache ? run_by_components() : run_from_left();
    return std::move(left_);
  }

 private:
  static constexpr std::size_t kInCache = std::size_t{1} << 15;  // edges
  struct Ends {
    const std::vector<OverlayEdge>& edges;
    std::pair<LatticePoint, LatticePoint> operator()(std::uint32_t e) const { return {edges[e].a, edges[e].b}; }
  };

  /// In the order of their first vertices: what lies below such a vertex is known by then.
  void run_by_components() {
    passed_ = static_cast<std::uint32_t>(fans_.vertices());
    for (std::uint32_t root = 0; root < passed_; ++root) {
      if (reached_[root] != 0) continue;
      begin_at(root);
      follow_open();
    }
  }
  void run_from_left() {
    const std::vector<std::uint32_t> roots = first_vertices();
    std::vector<std::uint32_t> waiting;  // what lies below them is not known yet
    auto root = roots.begin();
    for (passed_ = 0; passed_ < fans_.vertices(); ++passed_) {
      if (root != roots.end() && *root == passed_ && !begin_at(*root++)) waiting.push_back(passed_);
      if (reached_[passed_] == 0) reach_from_left(passed_);
      follow_open();
    }
    for (const std::uint32_t r : waiting) {
      begin_at(r);
      follow_open();
    }
  }

  /// Of each connected component, ascending.
  std::vector<std::uint32_t> first_vertices() const {
    DisjointSets components(fans_.vertices());
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      components.unite(fans_.tail(HalfEdge::forward(e)), fans_.tail(HalfEdge::backward(e)));
    std::vector<bool> met(fans_.vertices());
    std::vector<std::uint32_t> first;
    for (std::uint32_t v = 0; v < fans_.vertices(); ++v) {
      const std::size_t component = components.find(v);
      if (!met[component]) first.push_back(v);
      met[component] = true;
    }
    return first;
  }
  /// A component, at its first vertex. False, if what lies below is not known yet.
  bool begin_at(std::uint32_t root) {
    const std::uint32_t e = below_.below(edges_[fans_.at(root).front().edge()].a);
    if (e != EdgeBelow::kNone && reached_[fans_.tail(HalfEdge::forward(e))] == 0 &&
        reached_[fans_.tail(HalfEdge::backward(e))] == 0)
      return false;
    walk_around(root, first_from_below(root), e == EdgeBelow::kNone ? Windings{} : left_[e]);
    return true;
  }
  /// From an edge that ends there and is known, if there is one. Otherwise what the vertex is connected with follows.
  void reach_from_left(std::uint32_t vertex) {
    const auto fan = fans_.at(vertex);
    for (std::size_t k = 0; k < fan.size(); ++k)
      if (!fan[k].is_forward() && reached_[fans_.head(fan[k])] != 0) return walk_around(vertex, k, right_of(fan[k]));
  }
  /// Back to vertices that have been passed.
  void follow_open() {
    while (!open_.empty()) {
      const HalfEdge h = open_.back();
      open_.pop_back();
      if (reached_[fans_.tail(h)] == 0) walk_around(fans_.tail(h), fans_.position(h), right_of(h));
    }
  }
  /// The position of the half-edge just counter-clockwise of straight down at a component's first vertex: all lead to
  /// the right or straight up.
  std::size_t first_from_below(std::uint32_t root) const {
    const auto fan = fans_.at(root);
    if (fan.size() != 2) return 0;
    const OverlayEdge &e = edges_[fan[0].edge()], &f = edges_[fan[1].edge()];
    return twice_area(e.a, e.b, f.b) < 0 ? 1 : 0;
  }
  /// All about a vertex; `before` are the winding numbers just clockwise of the half-edge at `position`.
  void walk_around(std::uint32_t vertex, std::size_t position, Windings before) {
    reached_[vertex] = 1;
    const auto fan = fans_.at(vertex);
    std::int32_t first = before.first, second = before.second;  // two numbers stay in registers
    for (std::size_t k = 0, i = position; k < fan.size(); ++k, i = i + 1 == fan.size() ? 0 : i + 1) {
      const HalfEdge h = fan[i];
      const OverlayEdge& e = edges_[h.edge()];
      if (h.is_forward()) first += e.weight.first, second += e.weight.second;
      left_[h.edge()] = {first, second};
      if (!h.is_forward()) first -= e.weight.first, second -= e.weight.second;
      if (fans_.head(h) < passed_ && reached_[fans_.head(h)] == 0) open_.push_back(h.twin());
    }
  }
  Windings right_of(HalfEdge h) const {
    const Windings left_of_edge = left_[h.edge()];
    return h.is_forward() ? left_of_edge - edges_[h.edge()].weight : left_of_edge;
  }

  const std::vector<OverlayEdge>& edges_;
  VertexFans fans_;
  FewEdgesBelow<Ends> below_;
  std::vector<Windings> left_;
  std::vector<std::uint8_t> reached_;  // by vertex
  std::uint32_t passed_ = 0;           // so many vertices: the others are reached when it is their turn
  std::vector<HalfEdge> open_;         // their edges are known, the vertices they leave are not
};

}  // namespace

void add_ring(std::vector<OverlayEdge>& edges, const std::vector<LatticePoint>& ring, Windings weight) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    directed(ring[j], ring[i], weight, [&](const OverlayEdge& e) { edges.push_back(e); });
}

void add_region(std::vector<OverlayEdge>& edges, const Region& region, const Lattice& lattice, Windings weight) {
  for_each_snapped_ring(region, lattice,
                        [&](const std::vector<LatticePoint>& ring, RingKind) { add_ring(edges, ring, weight); });
}

void add_boundary(std::vector<OverlayEdge>& edges, const std::vector<BoundaryEdge>& boundary, Windings weight) {
  for (const BoundaryEdge& b : boundary)
    directed(b.from, b.to, weight, [&](const OverlayEdge& e) { edges.push_back(e); });
}

namespace {

std::vector<BoundaryEdge> boundary_where(const std::vector<OverlayEdge>& edges, const std::vector<Windings>& left,
                                         Inside inside) {
  std::vector<BoundaryEdge> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const OverlayEdge& e = edges[i];
    const bool inside_left = inside(left[i]);
    if (inside_left == inside(left[i] - e.weight)) continue;
    out.push_back(inside_left ? BoundaryEdge{e.a, e.b} : BoundaryEdge{e.b, e.a});
  }
  return out;
}

}  // namespace

std::vector<BoundaryEdge> boundary_of(std::vector<OverlayEdge> edges, Inside inside) {
  resolve(edges);
  return boundary_where(edges, WindingNumbers(edges).run(), inside);
}

std::array<std::vector<BoundaryEdge>, 2> boundaries_of(std::vector<OverlayEdge> edges, std::array<Inside, 2> inside) {
  resolve(edges);
  const std::vector<Windings> left = WindingNumbers(edges).run();
  return {boundary_where(edges, left, inside[0]), boundary_where(edges, left, inside[1])};
}

}  // namespace oxturn

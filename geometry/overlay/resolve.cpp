#include "geometry/overlay/resolve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/sorting.hpp"
#include "geometry/overlay/close_pairs.hpp"

namespace oxturn {
namespace {

using Edges = std::vector<OverlayEdge>;

constexpr double kClose = 2;  // quanta: pieces of edges that are farther apart do not meet

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
inline bool meet_at_an_end_only(const OverlayEdge& e, const OverlayEdge& f) {
  if (e.b != f.a && e.a != f.a && e.b != f.b && e.a != f.b) return false;
  return 2 * std::abs(cross(e.b - e.a, f.b - f.a)) > std::max(wide(e), wide(f));
}

/// Is a point so far off the edge's line that no piece of an edge which ends or is split there meets one of this edge
/// beside it? `area`: twice that of the triangle. Splitting moves either edge by less than a quantum.
bool is_off(const OverlayEdge& e, std::int64_t area) { return std::abs(area) > 4 * std::int64_t{wide(e)}; }

/// Does another edge lie on one side of e's line, and both of its ends off it? Then their pieces do not meet.
bool is_beside(const OverlayEdge& e, std::int64_t a, std::int64_t b) {
  return (a > 0) == (b > 0) && is_off(e, a) && is_off(e, b);
}

/// The points at which two edges have to be split because of each other. Could pieces of them meet, if others split
/// them, too?
bool add_cuts(const OverlayEdge& e, const OverlayEdge& f, std::uint32_t i, std::uint32_t j, std::vector<Cut>& cuts) {
  const std::int64_t ea = twice_area(f.a, f.b, e.a), eb = twice_area(f.a, f.b, e.b);
  if (is_beside(f, ea, eb)) return false;
  const std::int64_t fa = twice_area(e.a, e.b, f.a), fb = twice_area(e.a, e.b, f.b);
  if (is_beside(e, fa, fb)) return false;
  const std::size_t before = cuts.size();
  if (bends_to(e, f.a, fa)) cuts.push_back({i, f.a});
  if (bends_to(e, f.b, fb)) cuts.push_back({i, f.b});
  if (bends_to(f, e.a, ea)) cuts.push_back({j, e.a});
  if (bends_to(f, e.b, eb)) cuts.push_back({j, e.b});
  if (cuts.size() != before) return true;  // if the parts still cross, they do so in the next round
  if (!opposite_signs(ea, eb) || !opposite_signs(fa, fb)) return true;
  const double t = static_cast<double>(ea) / (static_cast<double>(ea) - static_cast<double>(eb));
  const LatticePoint p =
      rounded(e.a.x + t * (static_cast<double>(e.b.x) - e.a.x), e.a.y + t * (static_cast<double>(e.b.y) - e.a.y));
  if (p != e.a && p != e.b) cuts.push_back({i, p});
  if (p != f.a && p != f.b) cuts.push_back({j, p});
  return true;
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

/// Sorted by edge, then along it; no repeats. Calls close(i, j) for each pair of edges whose pieces could meet.
template <class Close>
std::vector<Cut> find_cuts(const Pieces& pieces, Close close) {
  const Edges& edges = pieces.edges;
  const bool all = pieces.unresolved.empty();
  const std::vector<std::uint32_t> near = all ? std::vector<std::uint32_t>{} : near_unresolved(pieces);
  const auto segment = [&](std::size_t k) {
    const std::uint32_t i = all ? static_cast<std::uint32_t>(k) : near[k];
    const OverlayEdge& e = edges[i];
    return SegmentPart{double(e.a.x), double(e.a.y), double(e.b.x), double(e.b.y), i};
  };
  std::vector<Cut> cuts;
  for_close_pairs(all ? edges.size() : near.size(), segment, kClose, pieces.unresolved,
                  [&](std::uint32_t i, std::uint32_t j) {
                    if (j < i) std::swap(i, j);
                    if (meet_at_an_end_only(edges[i], edges[j]) || add_cuts(edges[i], edges[j], i, j, cuts))
                      close(i, j);
                  });
  const auto along = [&](const Cut& c) { return dot(edges[c.edge].b - edges[c.edge].a, c.at - edges[c.edge].a); };
  spread_sort(
      cuts, [](const Cut& c) { return std::uint64_t{c.edge}; },
      [&](const Cut& c, const Cut& d) {
        if (c.edge != d.edge) return c.edge < d.edge;
        const std::int64_t u = along(c), v = along(d);
        return u != v ? u < v : c.at < d.at;
      });
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// Looks at the pieces of edges that are to be split.
class PiecesToBe {
 public:
  PiecesToBe(const Edges& edges, const std::vector<Cut>& cuts)
      : edges_(edges), cuts_(cuts), first_(edges.size() + 1, 0) {
    for (const Cut& c : cuts) ++first_[c.edge + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  /// Those that have to be split again, if pieces can meet in the given pairs of edges only. Pieces of one edge meet at
  /// their ends only.
  Edges to_be_split(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    for (const auto& [i, j] : pairs)
      if ((pieces(i) > 1 || pieces(j) > 1) && !meet_at_stops_only(i, j)) look_at(i, j);
    return std::move(found_);
  }

 private:
  struct Range {
    std::size_t from, to;
  };
  static constexpr std::size_t kFew = 8;      // pieces of an edge, all of which are looked at
  static constexpr std::size_t kMany = 1024;  // pairs of pieces, of which all are taken to meet

  std::size_t pieces(std::uint32_t edge) const { return first_[edge + 1] - first_[edge] + 1; }
  /// The k-th end of the pieces of an edge.
  const LatticePoint& stop(std::uint32_t edge, std::size_t k) const {
    if (k == 0) return edges_[edge].a;
    return k == pieces(edge) ? edges_[edge].b : cuts_[first_[edge] + k - 1].at;
  }
  OverlayEdge piece(std::uint32_t edge, std::size_t k) const {
    const LatticePoint &p = stop(edge, k), &q = stop(edge, k + 1);
    return p < q ? OverlayEdge{p, q, {}} : OverlayEdge{q, p, {}};
  }

  /// Are all stops of either edge off the other one's line, but for common ones?
  bool meet_at_stops_only(std::uint32_t i, std::uint32_t j) const {
    return pieces(i) <= kFew && pieces(j) <= kFew && are_off_or_common(i, j) && are_off_or_common(j, i);
  }
  bool are_off_or_common(std::uint32_t i, std::uint32_t j) const {
    for (std::size_t k = 0; k <= pieces(i); ++k) {
      const LatticePoint& p = stop(i, k);
      if (!is_off(edges_[j], twice_area(edges_[j].a, edges_[j].b, p)) && !is_stop_of(j, p)) return false;
    }
    return true;
  }
  bool is_stop_of(std::uint32_t edge, const LatticePoint& p) const {
    for (std::size_t k = 0; k <= pieces(edge); ++k)
      if (stop(edge, k) == p) return true;
    return false;
  }
  /// The pieces of an edge that may lie near the line of another one: its cuts advance along it, towards the line or
  /// away from it.
  Range near_line(std::uint32_t edge, const OverlayEdge& line) const {
    const std::int64_t width = 8 * std::int64_t{wide(line)};
    const auto side = [&](const LatticePoint& p) { return twice_area(line.a, line.b, p); };
    const int sense = side(edges_[edge].a) <= side(edges_[edge].b) ? 1 : -1;
    const auto begin = cuts_.begin() + first_[edge], end = cuts_.begin() + first_[edge + 1];
    const auto low = std::partition_point(begin, end, [&](const Cut& c) { return sense * side(c.at) < -width; });
    const auto high = std::partition_point(low, end, [&](const Cut& c) { return sense * side(c.at) <= width; });
    return {static_cast<std::size_t>(low - begin), static_cast<std::size_t>(high - begin) + 1};
  }
  void look_at(std::uint32_t i, std::uint32_t j) {
    const Range of_i = near_line(i, edges_[j]), of_j = near_line(j, edges_[i]);
    const bool many = (of_i.to - of_i.from) * (of_j.to - of_j.from) > kMany;
    for (std::size_t p = of_i.from; p < of_i.to; ++p)
      for (std::size_t q = of_j.from; q < of_j.to; ++q) look_at(piece(i, p), piece(j, q), many);
  }
  void look_at(const OverlayEdge& p, const OverlayEdge& q, bool is_found) {
    if (p.a == p.b || q.a == q.b) return;
    if (p.b.x + 1 < q.a.x || q.b.x + 1 < p.a.x || std::max(p.a.y, p.b.y) + 1 < std::min(q.a.y, q.b.y) ||
        std::max(q.a.y, q.b.y) + 1 < std::min(p.a.y, p.b.y))
      return;
    if (!is_found) {
      if (meet_at_an_end_only(p, q)) return;
      scratch_.clear();
      edge_order(q, p) ? add_cuts(q, p, 0, 1, scratch_) : add_cuts(p, q, 0, 1, scratch_);
      if (scratch_.empty()) return;
    }
    found_.push_back(p);
    found_.push_back(q);
  }

  const Edges& edges_;
  const std::vector<Cut>& cuts_;
  std::vector<std::uint32_t> first_;  // the cuts of edge e: cuts_[first_[e] .. first_[e + 1])
  std::vector<Cut> scratch_;
  Edges found_;
};

/// Marks as unresolved no edges but these, where they still are.
void leave_unresolved(const Edges& these, Pieces& pieces) {
  pieces.unresolved.assign(pieces.edges.size(), 0);
  for (const OverlayEdge& e : these) {
    const auto at = std::ranges::lower_bound(pieces.edges, e, edge_order);
    if (at != pieces.edges.end() && at->a == e.a && at->b == e.b)
      pieces.unresolved[static_cast<std::size_t>(at - pieces.edges.begin())] = 1;
  }
}

/// Splits the edges at the cuts. Those without a cut are resolved then and keep their order.
void split(const Edges& edges, const std::vector<Cut>& cuts, Edges& resolved, Edges& unresolved) {
  std::size_t split_edges = 0;
  for (std::size_t c = 0; c < cuts.size(); ++c) split_edges += c == 0 || cuts[c].edge != cuts[c - 1].edge ? 1 : 0;
  resolved.clear();
  resolved.reserve(edges.size() - split_edges);
  unresolved.clear();
  unresolved.reserve(cuts.size() + split_edges);
  for (std::size_t i = 0, c = 0; i < edges.size(); ++i) {
    const OverlayEdge& e = edges[i];
    if (c == cuts.size() || cuts[c].edge != i) {
      resolved.push_back(e);
      continue;
    }
    const auto add = [&](const OverlayEdge& piece) { unresolved.push_back(piece); };
    LatticePoint at = e.a;
    for (; c < cuts.size() && cuts[c].edge == i; at = cuts[c++].at) directed(at, cuts[c].at, e.weight, add);
    directed(at, e.b, e.weight, add);
  }
}

/// Where edges have to be split, and which of the pieces again.
struct FirstLook {
  std::vector<Cut> cuts;
  Edges again;
};
FirstLook look_at_all(const Pieces& pieces) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> close;
  FirstLook found{find_cuts(pieces, [&](std::uint32_t i, std::uint32_t j) { close.emplace_back(i, j); }), {}};
  if (!found.cuts.empty()) found.again = PiecesToBe(pieces.edges, found.cuts).to_be_split(close);
  return found;
}

}  // namespace

void resolve(std::vector<OverlayEdge>& edges) {
  // A round moves edges by less than a quantum and only to lattice points that are vertices already. Three rounds are
  // usual, more than ten have never been seen.
  constexpr int kMostRounds = 200;
  Edges resolved, unresolved = std::move(edges);
  Pieces pieces;
  const auto split_at = [&](const std::vector<Cut>& cuts) {
    split(pieces.edges, cuts, resolved, unresolved);
    merge(resolved, unresolved, pieces);
  };
  merge(resolved, unresolved, pieces);
  unresolved = Edges();  // memory for what follows
  const FirstLook first = look_at_all(pieces);
  if (!first.cuts.empty()) split_at(first.cuts);
  if (!first.again.empty()) {
    leave_unresolved(first.again, pieces);
    for (int round = 1;; ++round) {
      if (round == kMostRounds) throw std::runtime_error("overlay of regions does not converge on its lattice");
      const std::vector<Cut> cuts = find_cuts(pieces, [](std::uint32_t, std::uint32_t) {});
      if (cuts.empty()) break;
      split_at(cuts);
    }
  }
  edges = std::move(pieces.edges);
}

}  // namespace oxturn

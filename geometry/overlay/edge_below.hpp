/// The edge next below a lattice point, for many points. Private to geometry, not installed.
///
///   const EdgeBelow below(edges);
///   const std::uint32_t id = below.below(p);    // EdgeBelow::kNone if there is none
///
/// Method: columns bounded by quantiles of the edges' left ends, and in each column levels of equal height by the
/// edges' lowest points. A query searches the levels of its column downwards until no edge farther down reaches up to
/// the best one found. O(1) for edges spread evenly, O(sqrt(n)) where many share few levels. UniformGrid would not do:
/// a query looks down a whole column, and its cells do not adapt to crowded areas.
///
/// FewEdgesBelow looks at the edges one by one as long as that costs less than an EdgeBelow: most overlays ask for a
/// few points, and those near the left end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/overlay/lattice.hpp"

namespace oxturn {

class EdgeBelow {
 public:
  struct Edge {
    LatticePoint a, b;  // a.x < b.x
    std::uint32_t id;
  };
  /// The edges must meet at common ends only.
  explicit EdgeBelow(std::vector<Edge> edges);
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// The id of the first edge below p among those with a.x < p.x <= b.x, judged on the vertical line just left of p; p
  /// must not lie on any of them.
  std::uint32_t below(const LatticePoint& p) const;

  /// Is p to the right of edge e's left end and not of its right end, and above it?
  static bool is_below(const Edge& e, const LatticePoint& p) {
    return e.a.x < p.x && e.b.x >= p.x && std::min(e.a.y, e.b.y) <= p.y && twice_area(e.a, e.b, p) > 0;
  }
  /// Is e above f just left of x? Both span x and do not cross.
  static bool higher(const Edge& e, const Edge& f, std::int32_t x);

 private:
  template <class F>
  void for_each_cell_of_edges(F f) const;
  std::size_t column(std::int32_t x) const;
  std::size_t level(std::int32_t y) const;

  std::vector<Edge> edges_;                   // by a.x
  std::vector<std::int32_t> borders_;         // left borders of the columns
  std::int64_t low_ = 0, height_ = 1;         // of the lowest level; of each level
  std::size_t levels_ = 1;                    // per column
  std::vector<std::uint32_t> first_, items_;  // edges of cell c: items_[first_[c] .. first_[c + 1]); level by level
  std::vector<std::int32_t> top_;  // by cell: the highest point of any edge of its column on its level or below
};

/// ends(k): the lower and the upper end of the k-th of n edges, which come in the order of their lower ends and meet at
/// common ends only; vertical ones are never below anything.
template <class Ends>
class FewEdgesBelow {
 public:
  FewEdgesBelow(std::size_t n, Ends ends) : n_(n), ends_(std::move(ends)) {}
  /// As EdgeBelow::below(); the id is the number of the edge.
  std::uint32_t below(const LatticePoint& p) {
    if (index_) return index_->below(p);
    std::optional<EdgeBelow::Edge> best;
    std::uint32_t k = 0;
    for (; k < n_; ++k) {
      const auto [a, b] = ends_(k);
      if (a.x >= p.x) break;
      const EdgeBelow::Edge e{a, b, k};
      if (EdgeBelow::is_below(e, p) && (!best || EdgeBelow::higher(e, *best, p.x))) best = e;
    }
    looked_at_ += k;
    if (looked_at_ > kWorthIndex * n_) build();
    return best ? best->id : EdgeBelow::kNone;
  }

 private:
  static constexpr std::size_t kWorthIndex = 2;  // looks at each edge; building an index costs about as much

  void build() {
    std::vector<EdgeBelow::Edge> slanted;
    for (std::uint32_t k = 0; k < n_; ++k)
      if (const auto [a, b] = ends_(k); a.x < b.x) slanted.push_back({a, b, k});
    index_.emplace(std::move(slanted));
  }

  std::size_t n_;
  Ends ends_;
  std::size_t looked_at_ = 0;
  std::optional<EdgeBelow> index_;
};

}  // namespace oxturn

/// The edge next below a lattice point, for many points. Private to geometry, not installed.
///
///   const EdgeBelow below(edges);
///   const std::uint32_t id = below.below(p);    // EdgeBelow::kNone if there is none
///
/// Method: columns bounded by quantiles of the edges' left ends, and in each column levels of equal height by the
/// edges' lowest points. A query searches the levels of its column downwards until no edge farther down reaches up to
/// the best one found. O(1) for edges spread evenly, O(sqrt(n)) where many share few levels. UniformGrid would not do:
/// a query looks down a whole column, and its cells do not adapt to crowded areas.
#pragma once

#include <cstdint>

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

}  // namespace oxturn

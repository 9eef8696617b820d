// The edge next below a lattice point, for many points. Private to geometry: not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/overlay/arrangement.hpp"

namespace oxturn {

/// Twice the signed area of abc, exactly.
inline std::int64_t turn(const Site& a, const Site& b, const Site& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// Looks down along the line just left of a point. Edges (a < b) meet at common ends only. Columns at quantiles of
/// the edges' left ends, their edges in levels by lowest point: a question searches levels downwards until no edge
/// further down comes up to the best. O(1) for edges spread evenly, O(sqrt(n)) where they crowd on a few levels.
class EdgeBelow {
 public:
  struct Edge {
    Site a, b;  // a.x < b.x
    std::uint32_t id;
  };
  explicit EdgeBelow(std::vector<Edge> edges);
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// The id of the first edge with a.x < p.x <= b.x below p; p must not lie on an edge that comes from its left.
  std::uint32_t below(const Site& p) const;

 private:
  std::size_t column(std::int32_t x) const;
  std::size_t level(std::int32_t y) const;
  std::vector<Edge> edges_;
  std::vector<std::int32_t> borders_;
  std::int64_t low_ = 0, height_ = 1;  // of the lowest level; of each
  std::size_t levels_ = 1;
  std::vector<std::uint32_t> start_, index_;  // column by column, level by level
  std::vector<std::int32_t> top_;             // the highest point of any edge of that column on this level or below
};

}  // namespace oxturn

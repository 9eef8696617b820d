// The edge next below a lattice point, for many points. Private to geometry: not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/arrangement.hpp"

namespace oxturn {

/// Twice the signed area of abc, exactly.
inline std::int64_t turn(const Site& a, const Site& b, const Site& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// Looks down along the line just left of a point. Edges (a < b) meet at common ends only. Columns at quantiles of
/// the edges' left ends; a question costs about sqrt(n).
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
  std::vector<Edge> edges_;
  std::vector<std::int32_t> borders_;
  std::vector<std::uint32_t> start_, index_;
};

}  // namespace oxturn

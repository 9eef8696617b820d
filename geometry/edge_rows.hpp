/// The edges of a region in horizontal rows: point location that is built in a fraction of an EdgeIndex's time.
///
///   const EdgeRows rows(region);
///   for (const Point& p : points) inside += rows.contains(p);
///
/// For regions that are asked about as many points as they have edges, and then change. Build O(n) for n edges; a query
/// about as many edges as cross a horizontal line.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

class EdgeRows {
 public:
  explicit EdgeRows(const Region& region);
  /// The same as contains(region, p).
  bool contains(const Point& p) const;

 private:
  struct Edge {
    Point a, b;
  };
  std::size_t row(double y) const { return static_cast<std::size_t>((y - low_) * rows_per_metre_); }

  double low_ = 0, high_ = -1, rows_per_metre_ = 0;
  std::vector<std::uint32_t> first_;  // of each row in edges_
  std::vector<Edge> edges_;           // an edge in each row that it reaches
};

}  // namespace oxturn

// The target seen tile by tile, row after row. Internal to metrics/.
//
// Method      In a tile, a point is in the target if the winding number at the tile's lower left corner, plus the
//             edges crossed on the way right along the tile's lower side, plus those crossed on the way up, says 1.
//             So the area of target and a convex piece is a signed sum of half-plane clips of the piece: no local
//             arrangement is built and no predicate decides, each rounding costs its own size of area and no more.
// Complexity  O(E + sum over rows of edges in the row), one row in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region.hpp"
#include "metrics/convex.hpp"

namespace oxturn {

/// What one tile (the unit square about the origin) sees of the target.
class TileTarget {
 public:
  bool outside() const { return edges_.empty() && crossings_.empty() && winding_ == 0; }
  bool inside() const { return edges_.empty() && crossings_.empty() && winding_ == 1; }
  /// Area of the target within `c`.
  double area_in(const Convex& c) const;
  double area_in(const std::vector<Convex>& pieces) const;

 private:
  friend class TargetRows;
  struct Edge {
    double from, to;
    HalfPlane above;
    int sign;
  };  // over from <= x <= to
  struct Step {
    double x;
    int sign;
  };  // along the lower side
  int winding_ = 0;
  std::vector<Edge> edges_;
  std::vector<Step> crossings_;
};

class TargetRows {
 public:
  /// Point p of the region becomes (p - origin) / side; tile (i, j) is the unit square from (i, j).
  TargetRows(const Region& region, const Point& origin, double side);
  /// Rows must be asked for in ascending order, and within a row columns in ascending order.
  void start_row(std::int64_t row);
  const TileTarget& tile(std::int64_t column);

 private:
  struct Edge {
    Vec a, b;
  };
  struct InRow {
    std::int64_t first, last;
    std::size_t edge;
  };
  std::vector<Edge> edges_;  // by lowest y
  std::size_t next_ = 0;     // first edge that the rows have not reached yet
  std::vector<std::size_t> active_;
  std::int64_t row_ = 0;
  std::vector<InRow> in_row_;  // by first column
  std::size_t next_in_row_ = 0;
  std::vector<InRow> here_;
  std::vector<TileTarget::Step> crossings_;  // of the row's lower line, by x
  std::size_t next_crossing_ = 0;
  int winding_ = 0;
  TileTarget tile_;
};

}  // namespace oxturn

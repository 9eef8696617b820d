/// The target tile by tile, row after row. Private to metrics/.
///
///   TargetRows rows(target, origin, side);
///   rows.start_row(7);
///   const double wanted = rows.tile(3).area_in(pieces);          // of tile (3, 7), in tile areas
///
/// Method      A point of a tile is in the target if its winding number is 1: the winding number at the tile's lower
///             left corner, plus the edges crossed along the tile's lower side to the point's x, plus those crossed
///             from there upwards. So the area of the target in a convex piece is a signed sum of half-plane clips of
///             the piece. No arrangement is built and no predicate decides: a rounding error costs as much area as its
///             own size.
///
///                 |   p |
///                 |   ^ |
///                 |   | |
///                 *--->-+
///
/// Complexity  O(edges + sum over rows of the edges in the row); memory for one row
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region.hpp"
#include "metrics/convex.hpp"

namespace oxturn {

/// The target in one tile, the unit square about the origin.
class TileTarget {
 public:
  bool outside() const { return edges_.empty() && crossings_.empty() && winding_ == 0; }
  bool inside() const { return edges_.empty() && crossings_.empty() && winding_ == 1; }
  bool contains(Vec p) const;
  /// Cuts the pieces so that none has points on both sides of the target's boundary. In tiles with more than kMostEdges
  /// edges they are left as they are, and the result is false.
  bool cut(std::vector<Convex>& pieces, std::vector<Convex>& spare) const;
  /// Area of the target within `c`.
  double area_in(const Convex& c) const;
  double area_in(const std::vector<Convex>& pieces) const;

 private:
  friend class TargetRows;
  static constexpr std::size_t kMostEdges = 64;
  struct Edge {  // over from <= x <= to
    double from, to;
    HalfPlane above;
    int sign;
  };
  struct Step {  // where an edge crosses the tile's lower side
    double x;
    int sign;
  };
  int winding_ = 0;
  std::vector<Edge> edges_;
  std::vector<Step> crossings_;
};

class TargetRows {
 public:
  /// Point p of the region becomes (p - origin) / side; tile (i, j) is the unit square from (i, j).
  TargetRows(const Region& region, const Point& origin, double side);
  /// Rows must be requested in ascending order, and within a row columns in ascending order.
  void start_row(std::int64_t row);
  const TileTarget& tile(std::int64_t column);
  /// The tiles from this one on are all alike up to this column (excluded), if tile(column) is inside or outside.
  std::int64_t alike_until(std::int64_t column) const;
  /// The last row and the last column with an edge.
  std::int64_t last_row() const { return last_row_; }
  std::int64_t last_column() const { return last_column_; }

 private:
  struct Edge {
    Vec a, b;
  };
  struct InRow {  // an edge and the columns that it meets in the row
    std::int64_t first, last;
    std::size_t edge;
  };
  void add_to_row(std::size_t edge);
  std::vector<Edge> edges_;  // by lowest y
  std::size_t next_ = 0;     // first edge that the rows have not reached yet
  std::vector<std::size_t> active_;
  std::int64_t row_ = 0, last_row_ = 0, last_column_ = 0;
  std::vector<InRow> in_row_;  // by first column
  std::size_t next_in_row_ = 0;
  std::vector<InRow> here_;                  // those of the present column
  std::vector<TileTarget::Step> crossings_;  // of the row's lower line, by x
  std::size_t next_crossing_ = 0;
  int winding_ = 0;
  TileTarget tile_;
};

}  // namespace oxturn

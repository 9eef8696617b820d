/// Connected pieces of the target that the path leaves uncovered. Private to metrics/.
///
///   UncoveredPieces pieces;
///   pieces.start_row(7);
///   pieces.add_tile(3, {convex...}, target);          // what is left uncovered of tile (3, 7)
///   pieces.add_run(4, 90);                            // tiles (4, 7) to (89, 7): all of them target, none covered
///   std::vector<MissedPiece> missed = pieces.take(origin, side, least);
///
/// Method      Tiles are added row by row. The uncovered polygons of a tile are cut along the target's edges; the parts
///             that share an edge, in the tile or across its border, are joined (disjoint sets).
/// Complexity  near-linear in the parts; a tile with p parts O(p log p) plus the pairs above each other
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "metrics/convex.hpp"
#include "metrics/swept_area.hpp"
#include "metrics/target_rows.hpp"

namespace oxturn {

class UncoveredPieces {
 public:
  explicit UncoveredPieces(MissedOutlines outlines = MissedOutlines::kept) : outlines_(outlines) {}
  MissedOutlines outlines() const { return outlines_; }

  static constexpr double kLeastArea = 1e-9;  // tiles; smaller parts of a tile are rounding
  /// Rows in ascending order, and columns within a row.
  void start_row(std::int64_t row);
  /// `uncovered`: relative to the tile's centre.
  void add_tile(std::int64_t column, const std::vector<Convex>& uncovered, const TileTarget& target);
  /// Whole tiles, `to` excluded.
  void add_run(std::int64_t from, std::int64_t to);

  /// Pieces of more than `least` tiles, largest first. Tile coordinates are (p - origin) / side. Empties this object.
  std::vector<MissedPiece> take(const Point& origin, double side, double least);

 private:
  struct Part {
    double area;
    Vec middle;  // in tile coordinates
  };
  /// An edge of a part on a border of its tile.
  struct Touch {
    double from, to;  // along the border
    std::size_t part;
  };
  template <class Vertices>
  std::size_t new_part(double area, Vec centre, const Vertices& vertices);
  void add_part(const Convex& c, double area, Vec centre);
  std::vector<double> areas_of_pieces();
  Ring take_outline(const Point& origin, double side, std::size_t size);
  void join_within(std::size_t first);
  void join(std::vector<Touch>& left, std::vector<Touch>& right);

  std::int64_t row_ = -1, column_ = -1;  // column_: right of the tile added last
  MissedOutlines outlines_;
  std::deque<Part> parts_;                   // deques: they grow without being copied
  std::deque<Vec> vertices_;                 // of all parts in turn, in tile coordinates, if outlines are kept
  std::vector<std::uint8_t> sizes_;          // how many vertices each part has there
  DisjointSets joined_{0};                   // the parts
  std::vector<Touch> left_, right_;          // of the present tile, of the one before
  std::vector<Touch> bottom_, top_, below_;  // of the present row; below_: top_ of the row before
  std::vector<Convex> pieces_, spare_;
  std::vector<Extent> boxes_;                          // around the pieces
  std::vector<std::pair<double, std::size_t>> order_;  // left ends of the pieces, with their numbers
};

}  // namespace oxturn

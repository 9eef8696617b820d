/// How often a path covers each point of a fine raster of the target.
///
///   Witnesses witnesses(target, 0.05 * w, w / 2);
///   witnesses.add(witnesses.capsule(a, b));                    // an edge of the path
///   const long change = witnesses.exchange(old_edges, new_edges);   // of the number of uncovered points
///
/// One byte a point. The raster is turned, so that no row runs along a wall. A capsule, the points within the radius of
/// an edge, is convex: one interval in each row. Exchanging a capsule for one near by touches only what lies in one of
/// the two. Counters run modulo 256, and points outside the target start at 128: a path that lies 128 times on itself
/// would be misjudged, until it does so no more.
///
/// Complexity  O(A / cell^2) bytes and time to build for a box of area A; a capsule costs a few operations for each
///             row, an exchange in addition one for each point in the difference
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/raster_rows.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// Columns and rows of a raster, from the first ones to those before the end.
struct CellRange {
  int column = 0, row = 0, end_column = 0, end_row = 0;
};

class Witnesses {
 public:
  /// The points of row first + k that an edge covers: low[k] to high[k] - 1.
  struct Capsule {
    int first = 0, rows = 0;
    std::vector<std::int32_t> low, high;
  };

  /// Of the whole target. `cell`: distance of the points; `radius`: half of the tool's width, both in metres.
  Witnesses(const Region& target, double cell, double radius);
  /// Of the part in `window`, where both are turned().
  Witnesses(const Region& turned_target, const Box& window, double cell, double radius);
  /// Of the columns and rows from the given ones on: a part of the raster `target`, whose first point is in a cell that
  /// begins at `origin`, where that is turned().
  Witnesses(const RasterRows& target, const Point& origin, const CellRange& part, double cell, double radius);

  /// In the directions of the raster's rows and columns.
  static Point turned(const Point& p);
  static Region turned(const Region& region);

  /// Does not depend on the order of the ends. Writes to `out`, to spare the allocation.
  void capsule(const Point& a, const Point& b, Capsule& out) const;
  void add(const Capsule& capsule) { apply({}, capsule); }
  /// False: exchange() would return more than `most`. Changes nothing, and ends as soon as that is decided. Points that
  /// only one or two old capsules cover are lost if no new one holds them; at most the uncovered points of new ones
  /// are gained, and of the tiles that these meet.
  bool may_change(std::span<const Capsule> removed, std::span<const Capsule> added, long most) const;
  /// Takes the old capsules away and adds the new ones. The change of the number of uncovered points.
  long exchange(std::span<const Capsule> removed, std::span<const Capsule> added);

  /// Of each eight points side by side, an uncovered one if there is one; of these at most `most`, from all over the
  /// raster. O(bytes / 8).
  std::vector<Point> uncovered_points(std::size_t most) const;

  long points() const { return points_; }        // of the target
  long uncovered() const { return uncovered_; }  // of these
  double area_each() const { return cell_ * cell_; }
  std::size_t bytes() const { return counts_.size(); }

 private:
  static constexpr std::uint8_t kOutside = 128;
  static constexpr int kTile = 32;  // points along a side of a tile
  std::uint8_t* row(int r) { return counts_.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_); }
  const std::uint8_t* row(int r) const {
    return counts_.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_);
  }
  Point in_raster(const Point& p) const;
  void set_target(const RasterRows& target, const CellRange& part);
  void apply(const Capsule& old, const Capsule& next);
  void count_uncovered(int r, int low, int high, std::uint64_t value, int sign);
  long most_uncovered(std::span<const Capsule> capsules) const;
  std::size_t tile(int r, int column) const {
    return static_cast<std::size_t>(r / kTile) * static_cast<std::size_t>(tile_columns_) +
           static_cast<std::size_t>(column / kTile);
  }

  double cell_, radius_;
  Point origin_{0, 0};  // of the turned raster
  int columns_ = 0, rows_ = 0;
  long points_ = 0, uncovered_ = 0;
  int tile_columns_ = 0;
  std::vector<std::int32_t> tiles_;   // uncovered points of each tile, a square, row by row
  std::vector<std::uint8_t> counts_;  // and some bytes more: eight are read at once
};

}  // namespace oxturn

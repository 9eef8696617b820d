/// How a rectangle of cells is driven: in columns, or in rows where it is wider than high.
///
///   const RectangleLanes lanes(graph, options, robot);
///   if (const auto start = lanes.start_of(rectangle))
///     for (const Lane& lane : lanes.in(rectangle, *start).lanes) ...
///
/// O(cells of the rectangle).
#pragma once

#include <optional>
#include <vector>

#include "algorithms/grid/lane.hpp"
#include "algorithms/grid/rectangle_options.hpp"

namespace oxturn {

class RectangleLanes {
 public:
  /// `graph` and `options` must outlive it.
  RectangleLanes(const GridGraph& graph, const RectangleOptions& options, const Robot& robot);

  /// The parts of the lane that can be driven without leaving it.
  std::vector<Lane> runs(const Lane& whole) const;

  /// MyCarbot, section 2.3: as near to the lower left as possible, up to `shift` cells higher; otherwise in the next
  /// column. Where lanes are rows, in the first row that can be driven at all. `r` loses columns and rows without such
  /// a start. None if it is too small or cannot be driven.
  std::optional<Lane> start_of(CellRectangle& r) const;

  struct Found {
    std::vector<Lane> lanes;    // in the order of their lines; all in columns, or all in rows
    std::vector<Lane> skipped;  // lines in which the robot fits nowhere
    Lane before_start;          // cells of the first line; may be empty
  };
  /// Lanes so far apart that every cell between two of them is under the tool from both sides.
  Found in(const CellRectangle& r, const Lane& start) const;

 private:
  bool free(const Lane& lane, int along) const {
    return lane.upright ? graph_.free(lane.line, along) : graph_.free(along, lane.line);
  }
  bool passable(const Lane& lane, int along) const {
    return lane.upright ? graph_.passable(lane.line, along, kNorth) : graph_.passable(along, lane.line, kEast);
  }
  bool upright(const CellRectangle& r) const { return along_ == Along::columns || r.height() >= r.width(); }

  const GridGraph& graph_;
  Along along_;
  int smallest_, shift_, distance_;  // cells: sides of a rectangle, of a start, from one lane to the next one
};

}  // namespace oxturn

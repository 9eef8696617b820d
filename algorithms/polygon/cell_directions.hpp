/// Cells that are each driven in a direction of their own: a generalised tour chooses order, directions and patterns.
///
///   std::vector<DirectedCell> cells = directed_cells(problem, region, {.spacing = 0.4}, connector, context);
///   std::vector<Strip> strips = strips_of(problem, cells, options, context);
///
///      +-----------+------+
///      | --------- | |  | |     A cell can be driven along its edges, if every line across the lanes meets it once;
///      | --------- | |  | |     along each direction from either side, and beginning at either end of the first lane.
///      | --------- | |  | |
///      +-----------+------+
///
/// Source      Bähnemann, Lawrance, Chung, Pantic, Siegwart, Nieto, "Revisiting boustrophedon coverage path planning as
///             a generalized traveling salesman problem", Field and Service Robotics 2019
/// Complexity  for c cells up to 16 decompositions, 16 c patterns, and the tour (tour/generalised_tour.hpp)
#pragma once

#include <optional>
#include <vector>

#include "algorithms/polygon/cell_strips.hpp"

namespace oxturn {

/// What the tour makes least: metres driven, or seconds, turns included.
enum class TourMeasure { length, time };

struct CellDirections {
  double spacing = 0;              // of lanes, metres
  std::optional<double> cut = {};  // degrees; none given: the cheapest of up to 16
  LaneFit fit = LaneFit::fitted;
  TourMeasure objective = TourMeasure::length;
};

struct DirectedCell {
  double degrees;          // of its lanes
  BoustrophedonCell cell;  // in LaneFrame(degrees); without neighbours
};

/// The cell for lanes in another direction; nullopt if a line across them meets it more than once.
std::optional<BoustrophedonCell> turned(const BoustrophedonCell& cell, const LaneFrame& from, const LaneFrame& to);

/// The cells of a region with the directions of the cheapest tour found. Ends early if cancelled, with any directions.
std::vector<DirectedCell> directed_cells(const Problem& problem, const Region& region, const CellDirections& options,
                                         Context& context);
/// A strip for each cell that is not covered by lanes of others.
std::vector<Strip> strips_of(const Problem& problem, const std::vector<DirectedCell>& cells,
                             const CellDirections& options, Context& context);

}  // namespace oxturn

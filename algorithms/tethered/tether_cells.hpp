/// The cells of a grid that a tethered robot reaches from its start, each with its geodesic distance from the anchor.
///
///   const TetherCells cells(problem, problem.configuration_space(), side, CellKind::any);
///   cells[cells.root()].at;                              // the start
///
/// The start is the centre of a cell. A cell is one position of the robot's centre, and possibly walls to be driven.
/// Complexity  O(lattice nodes), one query of the geodesic field for each cell, and one for the nearest wall for each
///             cell whose centre is not connected to the start over the lattice; `partial`: also O(vertices of walls)
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

enum class CellKind {
  any,      // `joined`, and every other cell in which the robot fits: at the free point nearest to the cell's centre
  joined,   // centre free and connected to the start's cell by free edges of the lattice
  partial,  // every cell that meets the space, also where the nearest free point is outside; with the walls inside it
};

using CellList = std::vector<std::size_t>;  // indices of cells

class TetherCells {
 public:
  struct Position {
    Point at;         // the centre, or the free point nearest to it
    double distance;  // metres of tether along the geodesic
  };
  /// Throws Infeasible if the start's cell is the only one.
  TetherCells(const Problem& problem, const Region& space, double side, CellKind kind);

  /// Cells are numbered row by row.
  std::size_t size() const { return cells_.size(); }
  const Position& operator[](std::size_t c) const { return cells_[c]; }
  std::size_t root() const { return root_; }  // the start's cell
  double side() const { return lattice_.side(); }
  /// The adjacent cell, if the segment between the centres is free, or, unless both centres are joined to the start
  /// over the lattice, if the path between the cells' points is no longer than two cells.
  std::optional<std::size_t> neighbour(std::size_t c, Direction d) const {
    const std::size_t n = neighbours_[c][d];
    return n == kNone ? std::nullopt : std::optional(n);
  }
  /// The pieces of the space's boundary inside the cell: everything that the tool reaches from this cell's part of the
  /// space is within reach from the free centre or from these (w >= sqrt 2 D). Empty unless `partial`.
  const std::vector<Polyline>& walls(std::size_t c) const { return walls_[walls_.size() == 1 ? 0 : nodes_[c]]; }

  const GridGraph& lattice() const { return lattice_; }
  /// Of these cells, those whose position is the centre.
  std::vector<Cell> central(const CellList& list) const;

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  using Walls = std::vector<std::vector<Polyline>>;
  std::optional<Point> position_in(std::size_t node, CellKind kind, bool joined, const EdgeIndex& walls) const;

  GridGraph lattice_;
  Walls walls_;  // by node; only one, without walls, unless `partial`
  std::vector<Position> cells_;
  std::vector<std::size_t> nodes_;  // of the lattice, by cell
  std::vector<std::array<std::size_t, 4>> neighbours_;
  std::size_t root_ = 0;
};

}  // namespace oxturn

// The cells of a grid that a tethered robot gets to from its start, each with its tether distance.
//
// A cell's centre stands at the start; a cell is one place of the robot's centre.
// Complexity  O(lattice) for the cells; a question to the geodesic field each, and for cells that are not wholly free
//             one for the nearest wall
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

enum class CellKind {
  joined,  // centre free, joined to the start's cell by free edges of the lattice
  any,     // and every other cell in which the robot can stand at that free place which is nearest to the centre
};

class TetherCells {
 public:
  struct Cell {
    int column, row;
    Point place;      // the centre, or the free place nearest to it
    double distance;  // metres of string along the geodesic
  };
  /// Throws Infeasible if there is no cell beside the start's.
  TetherCells(const Problem& problem, const Region& space, double side, CellKind kind);

  /// Row by row.
  std::size_t size() const { return cells_.size(); }
  const Cell& operator[](std::size_t c) const { return cells_[c]; }
  std::size_t root() const { return root_; }  // the start's cell
  double side() const { return side_; }
  /// The cell beside c, if the straight way from centre to centre is free; if one is no wholly free cell, if the way
  /// from place to place is no longer than two cells.
  std::optional<std::size_t> neighbour(std::size_t c, Direction d) const {
    const std::size_t n = neighbours_[c][d];
    return n == kNone ? std::nullopt : std::optional(n);
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<Cell> cells_;
  std::vector<std::array<std::size_t, 4>> neighbours_;
  std::size_t root_ = 0;
  double side_;
};

}  // namespace oxturn

// Where the robot's centre may drive on a square lattice: nodes at cell centres, edges between neighbours.
//
// A node is free if it lies in configuration space; an edge is free if its whole closed segment does. That is
// exact for what grid planners drive (they only follow edges), so a cell needs no safety margin of its own.
// Complexity: O(nodes + lattice edges crossed by walls), 10^6 nodes in about 50 ms; 1 byte a node.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/raster.hpp"
#include "maps/problem.hpp"

namespace oxturn {

enum Direction : int { kEast = 0, kNorth = 1, kWest = 2, kSouth = 3 };
inline constexpr std::array<Direction, 4> kAllDirections{kEast, kNorth, kWest, kSouth};
inline constexpr std::array<int, 4> kColumnStep{1, 0, -1, 0};
inline constexpr std::array<int, 4> kRowStep{0, 1, 0, -1};
inline Direction opposite(Direction d) { return static_cast<Direction>((d + 2) % 4); }
inline Direction left_of(Direction d) { return static_cast<Direction>((d + 1) % 4); }
inline Direction right_of(Direction d) { return static_cast<Direction>((d + 3) % 4); }

class GridGraph {
 public:
  /// Nodes at origin + rotation by `angle` of ((i + 1/2) side, (j + 1/2) side).
  GridGraph(const Region& configuration_space, double side, double angle, const Point& origin, int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double side() const { return side_; }
  bool free(int i, int j) const { return inside(i, j) && (cells_[at(i, j)] & kFree) != 0; }
  /// The straight way from (i, j) to its neighbour is free (both ends included).
  bool passable(int i, int j, Direction d) const {
    if (!inside(i, j)) return false;
    switch (d) {
      case kEast:
        return (cells_[at(i, j)] & kEastOpen) != 0;
      case kNorth:
        return (cells_[at(i, j)] & kNorthOpen) != 0;
      case kWest:
        return i > 0 && (cells_[at(i - 1, j)] & kEastOpen) != 0;
      default:
        return j > 0 && (cells_[at(i, j - 1)] & kNorthOpen) != 0;
    }
  }
  /// Learns what lies between the nodes, for the two questions below: O(nodes + lattice diagonals crossed by walls).
  void look_between(const Region& configuration_space);
  /// The straight way from (i, j) to (i + di, j + dj), both of them 1 or -1, is free.
  bool diagonal(int i, int j, int di, int dj) const {
    if (!inside(i, j) || !inside(i + di, j + dj)) return false;
    const std::uint8_t square = cells_[at(std::min(i, i + di), std::min(j, j + dj))];
    return (square & (di == dj ? kRisingOpen : kFallingOpen)) != 0;
  }
  /// The straight way between two nodes is free, and so is all of every square between nodes that it meets.
  bool straight(int i, int j, int i2, int j2) const;

  Point centre(double i, double j) const {  // of cell (i, j); fractions address points between centres
    return origin_ + side_ * ((i + 0.5) * across_ + (j + 0.5) * up_);
  }
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  std::size_t size() const { return cells_.size(); }
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_; }
  /// Cell coordinates (fractions) of a point: centre() backwards.
  Point coordinates(const Point& p) const {
    const Point q = p - origin_;
    return {q.dot(across_) / side_ - 0.5, q.dot(up_) / side_ - 0.5};
  }

 private:
  static constexpr std::uint8_t kFree = 1, kEastOpen = 2, kNorthOpen = 4;
  // Of the square between (i, j) and (i + 1, j + 1): its diagonals are free; all of it is.
  static constexpr std::uint8_t kRisingOpen = 8, kFallingOpen = 16, kClear = 32;
  bool clear(int i, int j) const { return inside(i, j) && (cells_[at(i, j)] & kClear) != 0; }
  double side_;
  Point origin_, across_, up_;
  int columns_, rows_;
  std::vector<std::uint8_t> cells_;
};

/// How a grid lies over the map: the parameters that all grid planners share.
struct GridSettings {
  double cell_size = 0;             // metres; 0: the planner's default
  std::string align = "axes";       // axes: with the map's coordinates; edges: with the direction most walls run in
  double shift_x = 0, shift_y = 0;  // of the grid's origin, in cells
  double turn = 0;                  // radians, on top of what `align` says
};

/// Side of a cell: `given`, or by default tool width / sqrt 2, so that a disc tool on the centre lines covers cells.
double cell_side(double given, const Robot& robot);

/// A lattice over the problem's configuration space with `multiple` x `multiple` cells to a block; columns and rows
/// are whole numbers of blocks. Unshifted, the first cell centres stand on the lower left edges of configuration
/// space: the closest that the robot gets to a wall (with cells as wide as the robot that is the grid aligned to the
/// map's bounding box); `margin` adds so many cells on every side. Cells shrink by up to 1/1000 of their side where a
/// whole number of them then spans the room. Throws std::invalid_argument if that makes more than 10^8 cells.
GridGraph make_grid_graph(const Problem& problem, const GridSettings& settings, double side, int multiple,
                          int margin = 0);

/// A lattice over `space`, turned by `angle`, of which one node, an even number of cells from the lower left, stands at
/// `place`. Throws as make_grid_graph does.
GridGraph make_grid_graph_at(const Region& space, const std::string& map_name, const Point& place, double side,
                             double angle = 0);

/// The cells of a lattice that a region sets, or all cells of a lattice over it: `parts` x `parts` of them to a cell, and
/// `margin` of the lattice's cells more on every side.
BitGrid rasterise(const Region& region, const GridGraph& lattice, int parts, int margin, CellRule rule);

/// Direction (radians, in [0, pi/2)) that most of the walls' length runs in, modulo a quarter turn.
double dominant_direction(const Region& region);

}  // namespace oxturn

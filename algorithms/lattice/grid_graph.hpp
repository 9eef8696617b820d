/// Where the robot's centre may drive on a square lattice: nodes at cell centres, edges between neighbours.
///
///   const GridGraph graph = make_grid_graph(problem, {.side = 0.25});
///   if (graph.free(i, j) && graph.passable(i, j, kEast)) path.drive(graph.centre(i + 1, j), true);
///
/// A node is free if it lies in configuration space; an edge is free if its whole closed segment does. Grid planners
/// drive edges only, so this is exact and a cell needs no safety margin of its own.
/// O(nodes + lattice edges crossed by walls), 10^6 nodes in about 50 ms; 1 byte a node.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/graph_search.hpp"
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

/// A cell of a lattice: column i, row j.
struct Cell {
  int i = 0, j = 0;
  bool operator==(const Cell&) const = default;
};
inline Cell neighbour(const Cell& c, Direction d) { return {c.i + kColumnStep[d], c.j + kRowStep[d]}; }

/// Numbers for the cells of a lattice, row by row.
class CellNumbers {
 public:
  CellNumbers(int columns, int rows) : columns_(columns), rows_(rows) {}
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t size() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_; }
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  std::size_t at(const Cell& c) const { return at(c.i, c.j); }
  int column(std::size_t number) const { return static_cast<int>(number % static_cast<std::size_t>(columns_)); }
  int row(std::size_t number) const { return static_cast<int>(number / static_cast<std::size_t>(columns_)); }
  Cell cell(std::size_t number) const { return {column(number), row(number)}; }

 protected:
  int columns_, rows_;
};

class GridGraph : public CellNumbers {
 public:
  /// Nodes at origin + rotation by `angle` of ((i + 1/2) side, (j + 1/2) side).
  GridGraph(const Region& configuration_space, double side, double angle, const Point& origin, int columns, int rows);

  double side() const { return side_; }
  bool free(const Cell& c) const { return free(c.i, c.j); }
  bool free(int i, int j) const { return inside(i, j) && (cells_[at(i, j)] & kFree) != 0; }
  /// The edge from a cell's centre to its neighbour's is free.
  bool passable(const Cell& c, Direction d) const { return passable(c.i, c.j, d); }
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
  /// Takes a node and its edges out of the graph; before add_diagonals().
  void remove(const Cell& c);
  /// Finds out what lies between the nodes; diagonal() and straight() need it.
  /// O(nodes + lattice edges and diagonals crossed by walls).
  void add_diagonals(const Region& configuration_space);
  /// The segment from (i, j) to (i + di, j + dj) is free; di and dj are 1 or -1.
  bool diagonal(int i, int j, int di, int dj) const {
    if (!inside(i, j) || !inside(i + di, j + dj)) return false;
    const std::uint8_t square = cells_[at(std::min(i, i + di), std::min(j, j + dj))];
    return (square & (di == dj ? kRisingOpen : kFallingOpen)) != 0;
  }
  /// The segment between two nodes is free, and so are the squares between nodes that it meets.
  bool straight(const Cell& from, const Cell& to) const;

  /// Of cell (i, j); fractions address points between centres.
  Point centre(double i, double j) const { return origin_ + side_ * ((i + 0.5) * across_ + (j + 0.5) * up_); }
  Point centre(const Cell& c) const { return centre(c.i, c.j); }
  Point centre(std::size_t node) const { return centre(column(node), row(node)); }
  /// Cell coordinates of a point, with fractions: the inverse of centre().
  Point coordinates(const Point& p) const {
    const Point q = p - origin_;
    return {q.dot(across_) / side_ - 0.5, q.dot(up_) / side_ - 0.5};
  }
  /// The cell that contains the point, which may be outside of the lattice.
  Cell cell_of(const Point& p) const;

 private:
  struct Edge {
    Point a, b;
  };
  static constexpr std::uint8_t kFree = 1, kEastOpen = 2, kNorthOpen = 4;
  // Of the square between (i, j) and (i + 1, j + 1): its diagonals are free; all of it is free.
  static constexpr std::uint8_t kRisingOpen = 8, kFallingOpen = 16, kClear = 32;
  bool clear(int i, int j) const { return inside(i, j) && (cells_[at(i, j)] & kClear) != 0; }
  void close(int i, int j, std::uint8_t bits) {
    if (inside(i, j)) cells_[at(i, j)] &= static_cast<std::uint8_t>(~bits);
  }
  void mark_free_nodes(const Region& space);
  void open_edges_between_free_nodes();
  void close_edges_at_walls(const Region& space);
  void open_squares();
  void close_diagonals_at(const Edge& wall);
  void close_squares_at(const Edge& wall);
  template <class F>
  void for_each_wall(const Region& space, F f) const;

  double side_;
  Point origin_, across_, up_;
  std::vector<std::uint8_t> cells_;
};

/// Half the width of the robot: its radius, or half its tool if it has no radius. Metres.
inline double robot_size(const Robot& robot) { return robot.radius > 0 ? robot.radius : robot.tool_width / 2; }
/// The connected components of the free nodes.
ConnectedComponents components_of(const GridGraph& graph);

/// Where a lattice over a problem's configuration space lies.
struct LatticePlacement {
  double side;        // of a cell, metres
  double angle = 0;   // radians, counter-clockwise
  Point shift{0, 0};  // in cells
  int block = 1;      // columns and rows are whole numbers of blocks of so many cells
  int margin = 0;     // further cells on every side
};
/// Unshifted, the first cell centres lie on the lower and left edges of the configuration space's bounding box: the
/// closest that the robot gets to a wall. (With cells as wide as the robot this is the grid aligned to the map's
/// bounding box.) Cells shrink by up to 1/1000 of their side where a whole number of them then spans the box.
/// Throws std::invalid_argument if there would be more than 10^8 cells.
GridGraph make_grid_graph(const Problem& problem, const LatticePlacement& placement);

/// A lattice over `space`, turned by `angle`, that has a node at `node`, an even number of cells from the lower left.
/// Throws as make_grid_graph does.
GridGraph make_grid_graph_at(const Region& space, const std::string& map_name, const Point& node, double side,
                             double angle = 0);

/// A region as cells of the lattice, each divided into `parts` x `parts` cells, with a margin of so many of the
/// lattice's cells on every side.
BitGrid rasterise(const Region& region, const GridGraph& lattice, int parts, int margin, CellRule rule);

/// The grid's cell that contains the point.
inline Cell cell_at(const BitGrid& grid, const Point& p) {
  const Point at = (p - grid.origin) / grid.cell;
  return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
}
/// The cell and all that steps of at most `reach` columns and rows over set cells connect to it; clears them.
std::vector<Cell> take_component(BitGrid& grid, const Cell& cell, int reach);

/// Direction (radians, in [0, pi/2)) of most of the boundary's length, modulo a quarter turn.
double dominant_direction(const Region& region);

}  // namespace oxturn

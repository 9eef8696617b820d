/// The order of boustrophedon cells as a Chinese postman drives them: a closed tour of the Reeb graph.
///
///   const std::vector<BoustrophedonCell> parts = cell_circuit(cells, start);
///   for (const BoustrophedonCell& part : parts) drive(part);             // each cell, or half of it
///
///        .------.---------.------.        Vertices of the graph are events of the plane sweep (ends of cells that
///        |      |  b      |      |        meet), edges are cells. A cell that the tour drives twice is divided into a
///        |  a   o#########o  d   |        lower and an upper half, so that the robot drives through the one and comes
///        |      |  c      |      |        back through the other instead of crossing the cell without work. Here a
///        '------'---------'------'        and d are divided: a1 b d1 d2 c a2.
///
/// Source      Mannadiar and Rekleitis, ICRA 2010; Xu, Viriyasuthee and Rekleitis, Autonomous Robots 36(4), 2014
/// Complexity  O(v log v) for v vertices of cells, and polygon/postman.hpp
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/mesh/partition.hpp"

namespace oxturn {

/// The parts of cells in the order of the tour, without neighbours: first those connected with the cell end nearest to
/// `start`, which is given in the cells' frame; then the others, always those nearest to where the last tour ends.
/// Dividing a cell costs as much as it is wide: that much longer are the links between its lanes.
std::vector<BoustrophedonCell> cell_circuit(const std::vector<BoustrophedonCell>& cells, const Point& start);

/// The lower and the upper half of a cell. They meet in a curve between floor and ceiling, at a share of the height
/// that changes linearly from `left` to `right`, both in [0, 1].
std::pair<BoustrophedonCell, BoustrophedonCell> halves(const BoustrophedonCell& cell, double left, double right);

/// The Reeb graph: for each cell the vertices at its left and right end, and where these are.
struct ReebGraph {
  std::vector<std::size_t> left, right;  // by cell
  std::vector<Point> at;                 // by vertex
};
ReebGraph reeb_graph(const std::vector<BoustrophedonCell>& cells);

}  // namespace oxturn

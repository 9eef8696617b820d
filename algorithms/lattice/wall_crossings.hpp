/// Where the walls of a space cross the lines of a lattice, and the pieces of wall in between.
///
///   for (const WallCrossing& x : wall_crossings(graph, ring, LatticeLines::through_centres)) ...
///   Polyline piece = wall_between(ring, from, to);      // along the ring, both ends included
///
/// O(n + crossings log crossings) for n vertices of the ring.
#pragma once

#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

enum class LatticeLines {
  through_centres,  // those along which the lattice's edges run
  beside_cells,     // the sides of its cells
};

struct WallCrossing {
  std::size_t edge;  // of the ring, from vertex `edge` to the next
  double t;          // position on that edge, 0 to 1
  Point at;
  bool vertical;  // the line has constant column, else constant row
  int line;       // its column or row
  double along;   // row or column coordinate of the crossing on it
};

/// In the order of the ring from its first vertex on. A ring's vertex on a line may be a crossing twice; of an edge
/// along a line, both ends are crossings of that line.
std::vector<WallCrossing> wall_crossings(const GridGraph& graph, const Ring& ring, LatticeLines lines);
/// The ring from one crossing to another one, or once around to itself. The ends are `from.at` and `to.at`.
Polyline wall_between(const Ring& ring, const WallCrossing& from, const WallCrossing& to);

/// The walls of `space`, divided at the sides of the lattice's cells: by node, the pieces inside that cell.
std::vector<std::vector<Polyline>> walls_in_cells(const GridGraph& graph, const Region& space);

}  // namespace oxturn

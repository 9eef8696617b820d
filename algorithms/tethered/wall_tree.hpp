/// A tree over the free cells and the walls of a simply connected space, and the path there and back over it.
///
///   WallTree tree(component.problem, side, longest, is_wall);
///   path.drive(tree.path(), true);
///
///   ##################      o  free cells, joined by free edges of the lattice
///   #+---+---+---+--+       +  where an edge of the lattice ends at a wall: the graph's vertices on walls
///   #|   |   |   |  |
///   #+-- o - o - o  |       The graph has the edges between free cells, those to walls as far as they are free, and
///   #|   |   |   |  |       the walls between their vertices. Its shortest-path tree is driven there and back, and so
///                           are the walls that it leaves out, from both ends to where they meet.
///
/// Guarantee   Let d be the distance from the start along the graph. The path visits every free cell with d <= longest,
///             and drives the walls as far as d allows. Its length is exactly twice that of what it drives: at most
///             2 (n D + P + k D) for n cells of side D, walls P metres long, and k edges of the lattice that end at
///             walls. It is never farther than `longest` from the start along itself.
///             The graph is connected: its faces lie inside squares of the lattice, and one with a boundary of two
///             components would hold a hole. So with longest = infinity all free cells are visited, and all walls
///             driven. Then everything within w/2 of the space is covered, for a tool of width w >= sqrt 2 D: of a
///             point q in the cell with centre c, either the segment qc is free, and q no farther than w/2 from c; or
///             it meets a wall on the way, no farther than that. Likewise a point beyond a wall and its nearest point
///             of the space.
///             Of the boundary, only what is_wall(a, b) says is wall need be driven; the rest (a cut, over which the
///             tool reaches) only in cells whose centres are not free, because the proof needs the centre.
/// Complexity  O((n + v) log (n + v)) for n cells and v vertices of the space
/// Decisions   1. Of equally short paths to a cell the tree has the one that arrives with the least turn.
///             2. A vertex on a wall from which nothing leads on is left out, and the walls beside it are driven from
///                its neighbours, if that is not farther than `longest`: one lap there and back, not a comb.
///             3. What need not be driven of the boundary counts double in d: less than that, and paths would prefer it
///                to the lattice as a diagonal.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

class WallTree {
 public:
  /// `problem`: its configuration space has no holes; the lattice has a node at its start. `longest`: metres from the
  /// start along the graph. is_wall(a, b): an edge of the space's boundary is wall.
  WallTree(const Problem& problem, double side, double longest,
           const std::function<bool(const Point&, const Point&)>& is_wall);
  ~WallTree();

  /// From the start and back to it, depth-first. Empty: nothing but the start is within reach.
  Polyline path() const;
  /// A polyline for every branch, for pictures.
  std::vector<Polyline> branches() const;
  const GridGraph& lattice() const;
  /// The cells visited.
  std::vector<Cell> cells() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace oxturn

/// Parameters that several tethered grid planners share, described once. A planner's own Params derive from the struct.
///
///   struct Params : VisitParameters { bool alternate = false; };
///   ...
///   .parameters = with_visit_parameters<Params>({{"alternate", &Params::alternate, "..."}})
#pragma once

#include <vector>

#include "algorithms/lattice/grid_options.hpp"
#include "algorithms/tethered/tether_cells.hpp"
#include "geometry/tether/tethered_path.hpp"

namespace oxturn {

/// Of planners that visit cells one by one.
struct VisitParameters : CellSize {
  CellKind cells = CellKind::any;
  Retraction retraction = Retraction::automatic;
  int budget = 2000;
  bool return_home = true;
};

template <class P>
std::vector<Parameter<P>> with_visit_parameters(std::vector<Parameter<P>> own) {
  own.push_back({"cells", &P::cells, Choices{"any", "joined", "partial"},
                 "any: at walls, a cell's free point nearest to its centre counts for it; joined: wholly free cells; "
                 "partial: every cell of which a part is free, and the walls inside it are driven"});
  own.push_back(cell_size_line<P>("metres; side of a cell; 0: tool width / sqrt 2"));
  own.push_back({"retraction", &P::retraction, Choices{"automatic", "untangle"},
                 "untangle: back along the path driven until the next cell can be reached straight"});
  own.push_back({"budget", &P::budget, Range{0, 1e9}, "expansions per path, of the search in other homotopy classes"});
  own.push_back({"return_home", &P::return_home, "drive back to the start at the end, the tether taken in"});
  return own;
}

/// How the tether length limit bounds a tree of cells: by the depth in the tree, or by the geodesic distance.
enum class TreeReach { depth, geodesic };

/// Of planners that follow a shortest-path tree of cells.
struct TreeParameters : CellSize {
  TreeReach reach = TreeReach::depth;
};

template <class P>
std::vector<Parameter<P>> with_tree_parameters(std::vector<Parameter<P>> own) {
  own.push_back(cell_size_line<P>("metres; side of a cell, or of a sub-cell; 0: tool width / sqrt 2"));
  own.push_back({"reach", &P::reach, Choices{"depth", "geodesic"},
                 "depth: tether length is measured along the tree; geodesic: along the geodesic, in the cut space"});
  return own;
}

}  // namespace oxturn

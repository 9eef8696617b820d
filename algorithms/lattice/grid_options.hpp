/// The parameters that planners on square cells share: described once, used by every such planner.
///
///   struct Params : GridOptions { bool partial = false; };
///   ... .parameters = with_grid_options<Params>({{"partial", &Params::partial, "also enter ..."}})
///   const GridGraph graph = p_.lattice(problem, 2);
///
/// `CellSize` alone is for planners that position their lattice themselves, `GridOptions` for those that lay one over
/// the map, `CellOptions` for those whose robot steps from cell to cell, on the map or by lidar.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"
#include "base/parameters.hpp"

namespace oxturn {

enum class Align { axes, edges };
enum class Sensing { map, lidar };
/// Which connected components of the free cells a planner covers.
enum class Components { all, start };

/// Radians by which a lattice is turned: 0, or the direction in which most of the region's boundary runs.
inline double lattice_angle(Align align, const Region& free) {
  return align == Align::edges ? dominant_direction(free) : 0;
}

struct CellSize {
  double cell_size = 0;
  /// Metres: `cell_size`, or if that is 0 tool width / sqrt 2, so that a disc tool on the centre lines covers cells.
  double side(const Robot& robot) const { return cell_size > 0 ? cell_size : robot.tool_width / std::sqrt(2.0); }
};

struct GridOptions : CellSize {
  Align align = Align::axes;
  double shift_x = 0, shift_y = 0;
  /// The lattice over the problem's map, in whole blocks of `block` x `block` cells.
  GridGraph lattice(const Problem& problem, int block) const {
    return make_grid_graph(problem, {.side = side(problem.robot()),
                                     .angle = lattice_angle(align, problem.map().free),
                                     .shift = {shift_x, shift_y},
                                     .block = block});
  }
};

struct CellOptions : CellSize {
  Align align = Align::axes;
  Sensing sensing = Sensing::map;
  /// Throws std::invalid_argument for options that exclude each other.
  void check() const {
    if (sensing == Sensing::lidar && align == Align::edges)
      throw std::invalid_argument("align = edges needs the map; sensing = lidar goes with align = axes");
  }
};

/// One line each, for planners that need only some of them or another help text.
template <class P>
Parameter<P> cell_size_line(std::string help = "side of a cell, metres; 0: tool width / sqrt 2") {
  return {"cell_size", &P::cell_size, Range{0, 1000}, std::move(help)};
}
template <class P>
Parameter<P> align_line(std::string help = "edges: turn the grid to the direction in which most walls run") {
  return {"align", &P::align, Choices{"axes", "edges"}, std::move(help)};
}
template <class P>
Parameter<P> sensing_line(std::string help = "map: the robot feels the cells around it; lidar: it sees them by lidar") {
  return {"sensing", &P::sensing, Choices{"map", "lidar"}, std::move(help)};
}
template <class P>
Parameter<P> components_line() {
  return {"components", &P::components, Choices{"all", "start"},
          "start: only the cells connected to the first one; all: then the other connected components"};
}

/// A planner's own lines between those of the shared parameters.
template <class P>
std::vector<Parameter<P>> with_cell_size(std::vector<Parameter<P>> own) {
  own.insert(own.begin(), cell_size_line<P>());
  return own;
}
template <class P>
std::vector<Parameter<P>> with_grid_options(std::vector<Parameter<P>> own) {
  own = with_cell_size<P>(std::move(own));
  own.push_back(align_line<P>());
  own.push_back({"shift_x", &P::shift_x, Range{-1, 1}, "shift of the grid, in cells"});
  own.push_back({"shift_y", &P::shift_y, Range{-1, 1}, "shift of the grid, in cells"});
  return own;
}
template <class P>
std::vector<Parameter<P>> with_cell_options(std::vector<Parameter<P>> own) {
  own = with_cell_size<P>(std::move(own));
  own.push_back(align_line<P>("edges: turn the grid to the direction in which most walls run (needs sensing = map)"));
  own.push_back(sensing_line<P>());
  return own;
}

}  // namespace oxturn

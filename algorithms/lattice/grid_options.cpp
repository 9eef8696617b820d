#include "algorithms/lattice/grid_options.hpp"

namespace oxturn {

double lattice_angle(Align align, const Region& free) { return align == Align::edges ? dominant_direction(free) : 0; }

GridGraph GridOptions::lattice(const Problem& problem, int block) const {
  return make_grid_graph(problem, {.side = side(problem.robot()),
                                   .angle = lattice_angle(align, problem.map().free),
                                   .shift = {shift_x, shift_y},
                                   .block = block});
}

}  // namespace oxturn

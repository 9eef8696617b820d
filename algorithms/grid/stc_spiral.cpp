// Online spanning tree coverage: the tree grows counter-clockwise while the robot drives around it, which yields
// spirals.
//
// Source      Gabriely & Rimon, "Spanning-tree based coverage of continuous areas by a mobile robot", ICRA 2001
//             (Spiral-STC); partial cells after the 2002 technical report and Computational Geometry 24, 2003
// Model       grid of coarse cells 2D x 2D, online (cells felt 3 sub-cells far, or seen by lidar), disc footprint
// Guarantee   each sub-cell (side D) of the free coarse cells connected to the first exactly once, length = sub-cells x
//             D, closed. partial: every sub-cell that free lattice edges connect to the start, length <= (n + m) D for
//             n sub-cells of which m share a point with a blocked one; no online algorithm does better than (2 -
//             epsilon) times the optimum
// Complexity  n sub-cells: time and memory O(n)
// Decisions   1. visit(x, parent) is not a recursion here. The robot keeps to the right and looks across every side
//                that it passes; a free and new cell there becomes a child. Since it drives around the tree
//                counter-clockwise, that is the paper's order, counter-clockwise from the parent, and only the tree
//                needs to be stored (sub_cell_tree.hpp, also for partial cells).
//             2. A coarse cell is old once it is in the tree: it is entered at that moment.
//             3. The start may be any of the four sub-cells of its coarse cell: the first choice that is entirely free.
//             4. By lidar, what has not been seen when it is needed counts as blocked for that visit. The guarantees
//                hold for cells felt on the map (`sensing = map`, the paper's model).
#include "algorithms/grid/stc_online.hpp"

namespace oxturn {

PlannerInfo stc_spiral() {
  return describe_online_stc<ChildOrder::counter_clockwise>("stc-spiral", "spanning tree coverage, online, in spirals",
                                                            "Gabriely & Rimon 2001");
}

}  // namespace oxturn

// Spanning tree coverage, online: the tree grows counter-clockwise while the robot goes round it, which winds in spirals.
//
// Source      Gabriely & Rimon, "Spanning-tree based coverage of continuous areas by a mobile robot", ICRA 2001
//             (Spiral-STC); partial cells after the 2002 technical report and Computational Geometry 24, 2003
// Model       grid of coarse cells 2D x 2D, online (cells felt 3 sub-cells far, or by lidar), disc footprint
// Guarantee   each sub-cell (side D) of the wholly free coarse cells that hang together with the first exactly once, length
//             = sub-cells x D, closed. partial: every sub-cell that free steps join to the start, length <= (n + m) D for n
//             sub-cells of which m share a point with a blocked one; no online algorithm beats (2 - epsilon) x optimal
// Complexity  n sub-cells: time and memory O(n)
// Decisions   1. visit(x, parent) is not written as a recursion: the robot keeps to the right and looks out of every side
//                that it passes; what is free and new there becomes a child. As it goes round the tree counter-clockwise
//                that is the paper's order, counter-clockwise from the parent, and nothing has to be remembered but the
//                tree (sub_cell_tree.hpp, also for how partial cells are gone round).
//             2. A coarse cell is old once it is in the tree: it is entered that moment.
//             3. The start may be any of the four sub-cells of its coarse cell: the first choice that is wholly free.
//             4. By lidar, what is not yet seen when it is asked about counts as blocked for that visit: the guarantees
//                hold for cells felt on the map (`sensing = map`, the paper's model).
#include "algorithms/grid/stc_online.hpp"

namespace oxturn {
namespace {

class StcSpiral final : public CoveragePlanner {
 public:
  explicit StcSpiral(OnlineStcParams p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return grow_and_go_round(problem, context, p_, false);
  }

 private:
  OnlineStcParams p_;
};

}  // namespace

PlannerInfo stc_spiral() {
  return describe<StcSpiral, OnlineStcParams>(
      {.name = "stc-spiral",
       .family = "grid",
       .title = "spanning tree coverage, online, in spirals",
       .citation = "Gabriely & Rimon 2001",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "each sub-cell of the wholly free coarse cells about the start exactly once, in a closed round",
       .parameters = online_stc_parameters()});
}

}  // namespace oxturn

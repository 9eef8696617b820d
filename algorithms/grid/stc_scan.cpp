// Spanning tree coverage, online, in mostly straight vertical lanes: sideways children of the tree are postponed.
//
// Source      after Gabriely & Rimon, "Spiral-STC: an on-line coverage algorithm of grid environments by a mobile robot",
//             ICRA 2002 (Scan-STC)
// Model       as stc-spiral
// Guarantee   as stc-spiral
// Complexity  n sub-cells: time and memory O(n)
// Decisions   1. The order is stc-spiral's, counter-clockwise from the parent, but a sideways child y of x is postponed while
//                some vertical neighbour x' later in x's order and y's neighbour y' on that side are both free and new: x'
//                or one above it will come to y', and y' to y. (Any other order of children visits sub-cells twice.)
//             2. x' is later in the order if it is still new. The four cells must hang together both ways, which walls
//                between free cells might prevent, and be wholly free (partial = true).
//             3. The rest as stc-spiral.
#include "algorithms/grid/stc_online.hpp"

namespace oxturn {
namespace {

class StcScan final : public CoveragePlanner {
 public:
  explicit StcScan(OnlineStcParams p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return grow_and_go_round(problem, context, p_, true);
  }

 private:
  OnlineStcParams p_;
};

}  // namespace

PlannerInfo stc_scan() {
  return describe<StcScan, OnlineStcParams>(
      {.name = "stc-scan",
       .family = "grid",
       .title = "spanning tree coverage, online, in lanes",
       .citation = "Gabriely & Rimon 2002",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "each sub-cell of the wholly free coarse cells about the start exactly once, in a closed round",
       .parameters = online_stc_parameters()});
}

}  // namespace oxturn

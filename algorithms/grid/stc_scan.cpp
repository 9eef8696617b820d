// Online spanning tree coverage in mostly straight vertical lanes: sideways children of the tree are postponed.
//
// Source      after Gabriely & Rimon, "Spiral-STC: an on-line coverage algorithm of grid environments by a mobile
//             robot", ICRA 2002 (Scan-STC)
// Model       as stc-spiral
// Guarantee   as stc-spiral
// Complexity  n sub-cells: time and memory O(n)
// Decisions   1. The order is that of stc-spiral, counter-clockwise from the parent. But a sideways child y of x is
//                postponed while some vertical neighbour x' later in x's order, and y's neighbour y' on the same side,
//                are both free and new: x' or a cell beyond it will reach y', and y' will reach y. (Any other order of
//                children visits sub-cells twice.)
//             2. x' comes later in the order if it is still new. The four cells must be connected both ways, which
//                walls between free cells might prevent, and be entirely free (partial = true).
//             3. Otherwise as stc-spiral.
#include "algorithms/grid/stc_online.hpp"

namespace oxturn {

PlannerInfo stc_scan() {
  return describe_online_stc<ChildOrder::vertical_first>("stc-scan", "spanning tree coverage, online, in lanes",
                                                         "Gabriely & Rimon 2002");
}

}  // namespace oxturn

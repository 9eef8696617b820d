// The one list of built-in planners. A new one is its own file, one declaration here and one line below.
#include "algorithms/coverage_planner.hpp"
#include "algorithms/online/sensing.hpp"

namespace oxturn {

PlannerInfo boustrophedon();
PlannerInfo zigzag();
PlannerInfo stc();
PlannerInfo stc_spiral();
PlannerInfo stc_scan();
PlannerInfo stc_loops();
PlannerInfo rectangles();
PlannerInfo wavefront();
PlannerInfo bsa();
PlannerInfo linked_spiral();
PlannerInfo ba_star();
PlannerInfo smart_dfs();
PlannerInfo cell_explore();
PlannerInfo hyun();
PlannerInfo leashed();
PlannerInfo berg();
PlannerInfo berg_complete();
PlannerInfo shnaps_rimon();
PlannerInfo shnaps_rimon_banded();
PlannerInfo tether_tree();
PlannerInfo tethered_stc();
PlannerInfo random_walk();
PlannerInfo spiral_out();
PlannerInfo wall_follow();
PlannerInfo vacuum_mix();

const std::vector<PlannerInfo>& zoo() {
  static const std::vector<PlannerInfo> planners{
      boustrophedon(),
      zigzag(),
      stc(),
      stc_spiral(),
      stc_scan(),
      stc_loops(),
      rectangles(),
      wavefront(),
      bsa(),
      linked_spiral(),
      ba_star(),
      smart_dfs(),
      cell_explore(),
      hyun(),
      leashed(),
      with_sensing(berg()),
      with_sensing(berg_complete()),
      with_sensing(shnaps_rimon()),
      with_sensing(shnaps_rimon_banded()),
      with_sensing(tether_tree()),
      tethered_stc(),
      random_walk(),
      spiral_out(),
      wall_follow(),
      vacuum_mix(),
  };
  return planners;
}

}  // namespace oxturn

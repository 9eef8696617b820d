// The one list of built-in planners. A new one is its own file, one declaration here and one line below.
#include "algorithms/coverage_planner.hpp"
#include "algorithms/online/sensing.hpp"

namespace oxturn {

PlannerInfo boustrophedon();
PlannerInfo zigzag();
PlannerInfo stc();
PlannerInfo rectangles();
PlannerInfo hyun();
PlannerInfo leashed();
PlannerInfo berg();
PlannerInfo berg_complete();
PlannerInfo shnaps_rimon();
PlannerInfo shnaps_rimon_banded();
PlannerInfo tether_tree();
PlannerInfo tethered_stc();

const std::vector<PlannerInfo>& zoo() {
  static const std::vector<PlannerInfo> planners{
      boustrophedon(),
      zigzag(),
      stc(),
      rectangles(),
      hyun(),
      leashed(),
      with_sensing(berg()),
      with_sensing(berg_complete()),
      with_sensing(shnaps_rimon()),
      with_sensing(shnaps_rimon_banded()),
      with_sensing(tether_tree()),
      tethered_stc(),
  };
  return planners;
}

}  // namespace oxturn

// The list of built-in planners. A new one is a file of its own, a declaration and an entry here.
#include "algorithms/coverage_planner.hpp"
#include "algorithms/drivable_planner.hpp"
#include "algorithms/size_limited_planner.hpp"
#include "algorithms/target_area_planner.hpp"

namespace oxturn {

PlannerInfo boustrophedon();
PlannerInfo zigzag();
PlannerInfo contour();
PlannerInfo connected_fermat();
PlannerInfo field();
PlannerInfo field_predictive();
PlannerInfo oarp();
PlannerInfo smooth_spiral();
PlannerInfo skeleton_spiral();
PlannerInfo completed();
PlannerInfo shortest();
PlannerInfo polished();
PlannerInfo trapezoid();
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
PlannerInfo beachbot();

namespace {

/// Planners cover target areas, and the offline ones drive robots with a least turning radius, if not by themselves.
/// All refuse maps that are too large.
Planners with_what_all_share(const Planners& planners) {
  Planners all("planner", {});
  for (const PlannerInfo& planner : planners) {
    const bool offline = !planner.has(Capability::online) && !planner.has(Capability::tether);
    const bool wrapped = offline && !planner.has(Capability::curvature);
    const PlannerInfo able = target_area_planner(planner);
    all.add(size_limited_planner(wrapped ? drivable_planner(able) : able));
  }
  return all;
}

}  // namespace

Planners built_in_planners() {
  return with_what_all_share(Planners("planner", {
                                                     boustrophedon(),
                                                     zigzag(),
                                                     contour(),
                                                     connected_fermat(),
                                                     field(),
                                                     field_predictive(),
                                                     oarp(),
                                                     smooth_spiral(),
                                                     skeleton_spiral(),
                                                     completed(),
                                                     shortest(),
                                                     polished(),
                                                     trapezoid(),
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
                                                     berg(),
                                                     berg_complete(),
                                                     shnaps_rimon(),
                                                     shnaps_rimon_banded(),
                                                     tether_tree(),
                                                     tethered_stc(),
                                                     random_walk(),
                                                     spiral_out(),
                                                     wall_follow(),
                                                     vacuum_mix(),
                                                     beachbot(),
                                                 }));
}

}  // namespace oxturn

// The one list of built-in planners. A new one is its own file, one declaration here and one line below.
#include "algorithms/coverage_planner.hpp"

namespace oxturn {

PlannerInfo boustrophedon();
PlannerInfo zigzag();
PlannerInfo stc();
PlannerInfo rectangles();

const std::vector<PlannerInfo>& zoo() {
  static const std::vector<PlannerInfo> planners{
      boustrophedon(),
      zigzag(),
      stc(),
      rectangles(),
  };
  return planners;
}

}  // namespace oxturn

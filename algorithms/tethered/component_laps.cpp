#include "algorithms/tethered/component_laps.hpp"

#include <utility>

#include "algorithms/lanes/lap_tree.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {

Path laps_in_component(const CutPasses& cut, const Problem& component, Context& context) {
  const double width = component.robot().tool_width;
  PassSpace passes = cut.beside(component);
  const Laps laps = laps_of(passes.problem, width, context);
  const Connector connector(component);  // its paths may leave the space beside the cut
  Path path = drive_lap_tree(passes.problem, laps, connector, context);
  path = without_short_segments(std::move(path), component);
  Region missed = unite({laps.between, passes.pockets});
  if (component.map().target_area) missed = intersect(missed, component.target());
  return repaired(component, path, std::move(missed), connector, context);
}

}  // namespace oxturn

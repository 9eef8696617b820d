#include "algorithms/tethered/component_laps.hpp"

#include <utility>

#include "algorithms/lanes/lap_tree.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// In tool widths. Where the cut runs along a wall it leaves notches much smaller than this, and laps would turn about
// the corners of each: their number is that of the vertices, and all overlap.
constexpr double kNotch = 1e-5;

}  // namespace

Path laps_in_component(const CutPasses& cut, const Problem& component, Context& context) {
  const double width = component.robot().tool_width;
  PassSpace passes = cut.beside(component);
  const Problem beside = component.restricted(simplify_inward(passes.space, kNotch * width));
  const Laps laps = laps_of(beside, width, context);
  Path path = drive_lap_tree(beside, laps, Connector(beside), context);
  path = without_short_segments(std::move(path), component);
  Region missed = unite({laps.between, passes.pockets});
  if (component.map().target_area) missed = intersect(missed, component.target());
  return repaired(component, path, std::move(missed), Connector(component), context);
}

}  // namespace oxturn

#include "algorithms/tethered/component_laps.hpp"

#include <utility>

#include "algorithms/lanes/lap_tree.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/point_outside.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// In tool widths. Where the cut runs along a wall it leaves notches much smaller than this, and laps would turn about
// the corners of each: their number is that of the vertices, and all overlap.
constexpr double kNotch = 1e-5;

/// As it is if the start lies in a notch.
Region without_notches(const Region& space, const Problem& component) {
  Region smoother = simplify_inward(space, kNotch * component.robot().tool_width);
  const bool holds_start = nearly_contains(EdgeIndex(smoother), component.start(), component.tolerance());
  return holds_start ? std::move(smoother) : space;
}

}  // namespace

Path laps_in_component(const CutPasses& cut, const Problem& component, Context& context) {
  const double width = component.robot().tool_width;
  PassSpace passes = cut.beside(component);
  const Problem beside = component.restricted(without_notches(passes.space, component));
  const Laps laps = laps_of(beside, width, context);
  Path path = drive_lap_tree(beside, laps, Connector(beside), context);
  path = without_short_segments(std::move(path), component);
  Region missed = unite({laps.between, passes.pockets});
  if (component.map().target_area) missed = intersect(missed, component.target());
  return repaired(component, path, std::move(missed), Connector(component), context);
}

}  // namespace oxturn

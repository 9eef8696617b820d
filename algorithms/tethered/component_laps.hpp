/// Covers a component of the cut space by laps along its walls and along both sides of the cut, inwards.
///
///   const CutPasses cut(problem, tether.cut());
///   Path path = laps_in_component(cut, component, context);
///
/// Short along corridors, where level sets and lanes across turn at every wall. Covers what the component's target
/// allows, as CutPasses and lanes/repair.hpp do. O(m log m) for laps with m vertices in all, and CutPasses::beside.
#pragma once

#include "algorithms/context.hpp"
#include "algorithms/tethered/cut_passes.hpp"

namespace oxturn {

Path laps_in_component(const CutPasses& cut, const Problem& component, Context& context);

}  // namespace oxturn

/// What a tool leaves uncovered of an area, and where to drive for it.
///
///   const Region rest = not_surely_covered(area, legs, width);
///   for (const Polyline& part : parts_near(planned, rest, width)) strokes.push_back(part);
///
/// Rests thinner than a tenth of the tool are ignored: approximate circles leave such slivers along every boundary.
#pragma once

#include <vector>

#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// What no leg with the tool on covers, and slivers within a thousandth of its width: more than `uncovered` of lanes/,
/// which leaves out what might be covered. Legs of width 0 use `tool_width`. O(n log n) for what they sweep.
Region not_surely_covered(const Region& area, const std::vector<Leg>& legs, double tool_width);

/// The rest without slivers for a tool of that width, in its connected components.
Region worthwhile(const Region& rest, double width);

/// The parts of the lines from which a tool of that width reaches the rest; each is as long as the tool is wide at
/// least, where the line is.
std::vector<Polyline> parts_near(const std::vector<Polyline>& lines, const Region& rest, double width);

}  // namespace oxturn

/// Laps around a field before or after its lanes, as tractors drive them.
///
///   struct Params : Headland { ... };
///   return drive_with_headland(problem, params, strips_deeper_than, params.order, context);
///
/// Laps are a tool width apart (laps.hpp). Each is closed and begins at its vertex nearest to where the robot is. What
/// laps leave uncovered at their corners is added as detours (repair.hpp), so laps and lanes cover the whole target if
/// the lanes cover what is deeper than the laps reach.
#pragma once

#include <functional>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lanes/strips.hpp"

namespace oxturn {

/// last: from the inside out, after the lanes; first: from the outside in, before them.
enum class HeadlandOrder { last, first };
/// on: on laps and in turns between lanes; laps: on laps, lifted in turns; off: no laps, so that nothing is worked
/// there.
enum class HeadlandTool { on, laps, off };

/// Parameters of planners that can drive a headland.
struct Headland {
  int headland = 0;  // laps; 0: no headland
  HeadlandOrder headland_order = HeadlandOrder::last;
  HeadlandTool headland_tool = HeadlandTool::on;

  /// Whether the walls' surroundings are worked: by laps, or without a headland if the `outline` is driven.
  bool works_walls(bool outline) const { return headland > 0 ? headland_tool != HeadlandTool::off : outline; }
};
template <class P>
std::vector<Parameter<P>> with_headland(std::vector<Parameter<P>> own, double fewest = 0) {
  own.push_back({"headland", &P::headland, Range{fewest, 1000},
                 fewest > 0 ? "laps around the field" : "laps around the field, in place of the outline; 0: none"});
  own.push_back({"headland_order", &P::headland_order, Choices{"last", "first"},
                 "last: lanes, then laps from the inside out; first: laps from the outside in, then lanes"});
  own.push_back({"headland_tool", &P::headland_tool, Choices{"on", "laps", "off"},
                 "in the headland; laps: lifted in turns between lanes; off: room to turn, no laps"});
  return own;
}

/// `strips_deeper_than(depth)`: strips of lanes that cover all points of configuration space at least `depth` metres
/// from its boundary. Publishes the path before the detours. With the tool off lanes alone, and no repair.
Path drive_with_headland(const Problem& problem, const Headland& headland,
                         const std::function<std::vector<Strip>(double depth)>& strips_deeper_than, StripOrder order,
                         Context& context);

}  // namespace oxturn

// Along the wall on the right, then straight away to another wall.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014
// Model       online by bumpers and a feeler (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp)
// Complexity  O(length / tool width * edges near the robot)
// Decisions   1. The robot follows in steps of a sixteenth of the tool's width, corrected by the feeler after each.
//             2. After `laps` laps of one wall it leaves it in a random heading for the next contact; 0: never. If the
//                wall led to another one (an island nearer than two distances), a lap of that one counts as well.
//             3. `distance` 0 is contact: a thousandth of the tool's width. Where a passage is narrower than two
//                distances, the robot keeps to its middle; where it is stuck, it turns around and follows the opposite
//                wall back.
#include <limits>

#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {
  double distance = 0;
  int laps = 1;
};

void clean(const Params& p, Vacuum& vacuum, Rng&) {
  Point heading = vacuum.any_heading();
  while (const auto wall = vacuum.drive_on(heading)) {
    Point away = *wall;
    for (int lap = 0; !vacuum.done() && (lap < p.laps || p.laps == 0); lap += p.laps > 0)
      follow_wall(vacuum, p.distance, std::numeric_limits<double>::infinity(), away);
    heading = vacuum.heading_off(away);
  }
}

}  // namespace

PlannerInfo wall_follow() {
  return describe_habit<Params, clean>(
      "wall-follow", "along the wall, then to another one", "ends; covers a strip along the walls that it meets",
      {{"distance", &Params::distance, Range{0, 1000}, "from the wall to the robot's boundary, metres; 0: contact"},
       {"laps", &Params::laps, Range{0, 1000}, "laps of one wall before it is left; 0: it is never left"}});
}

}  // namespace oxturn

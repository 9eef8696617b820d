// A spiral until contact, straight away from the wall, the next spiral.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014
// Model       online by bumpers (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp)
// Complexity  O(motions * (edges near one + length / tool width))
// Decisions   1. Between two spirals a random share of `away` tool widths, in a random heading off the wall, or until
//                the next contact.
//             2. Turns overlap by a tenth by default.
#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {
  double pitch = 0.9, away = 16;
};

void clean(const Params& p, Vacuum& vacuum, Rng&) {
  const double w = vacuum.tool_width();
  Point heading = vacuum.any_heading();
  while (const auto wall = spiral(vacuum, p.pitch * w, heading)) {
    heading = vacuum.heading_off(*wall);
    vacuum.leave_wall(heading, p.away * w);
  }
}

}  // namespace

PlannerInfo spiral_out() {
  return describe_habit<Params, clean>(
      "spiral-out", "a spiral until contact, straight away, the next spiral", "ends; coverage only in the limit",
      {{"pitch", &Params::pitch, Range{0.05, 2}, "between two turns of a spiral, in tool widths"},
       {"away", &Params::away, Range{0.1, 1000}, "farthest from the wall to the next spiral, in tool widths"}});
}

}  // namespace oxturn

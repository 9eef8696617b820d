// Straight on until contact, then on in a random heading.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014
// Model       online by bumpers (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp); covers everything only in the limit
// Complexity  O(motions * (edges near one + length / tool width))
// Decisions   1. All headings that lead away from the wall touched are equally likely.
#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {};

void clean(const Params&, Vacuum& vacuum, Rng&) {
  Point heading = vacuum.any_heading();
  while (const auto away = vacuum.drive_on(heading)) heading = vacuum.heading_off(*away);
}

}  // namespace

PlannerInfo random_walk() {
  return describe_habit<Params, clean>("random-walk", "straight until contact, then a random heading",
                                       "ends; coverage only in the limit", {});
}

}  // namespace oxturn

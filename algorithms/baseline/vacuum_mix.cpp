// The habits in turn: a spiral, along the wall, lanes back and forth, some random bounces.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014 (random walk, spiral, S-shaped pathway, wall following: none wins, a combination
//             does)
// Model       online by bumpers and a feeler (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp)
// Complexity  O(motions * (edges near one + length / tool width))
// Decisions   1. The paper itself was not available: order and lengths of the habits are ours. Each ends at a contact,
//                so the next begins at a wall, the spiral at most `away` tool widths from it.
//             2. Along the wall for at most `follow` tool widths, so that a large room does not use up the run.
//             3. Lanes begin at a right angle to the wall, stepping aside to a random side.
#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {
  double pitch = 0.9, away = 16, follow = 60;
  int bounces = 10;
};

void clean(const Params& p, Vacuum& vacuum, Rng& rng) {
  const double w = vacuum.tool_width();
  Point heading = vacuum.any_heading();
  while (auto wall = spiral(vacuum, p.pitch * w, heading)) {
    follow_wall(vacuum, 0, p.follow * w, *wall);
    const Point side = rng.chance(0.5) ? perpendicular(*wall) : Point(-perpendicular(*wall));
    wall = snake(vacuum, p.pitch * w, *wall, side);
    for (int k = 0; wall && k < p.bounces; ++k) wall = vacuum.drive_on(vacuum.heading_off(*wall));
    if (!wall) return;
    heading = vacuum.heading_off(*wall);
    vacuum.leave_wall(heading, p.away * w);
  }
}

}  // namespace

PlannerInfo vacuum_mix() {
  return describe_habit<Params, clean>(
      "vacuum-mix", "spiral, wall, lanes and random bounces in turn", "ends; coverage only in the limit",
      {{"pitch", &Params::pitch, Range{0.05, 2}, "between turns of a spiral and between lanes, in tool widths"},
       {"away", &Params::away, Range{0.1, 1000}, "farthest from the wall to the next spiral, in tool widths"},
       {"follow", &Params::follow, Range{0, 1e6}, "longest drive along a wall, in tool widths"},
       {"bounces", &Params::bounces, Range{0, 1000}, "random bounces after the lanes"}});
}

}  // namespace oxturn

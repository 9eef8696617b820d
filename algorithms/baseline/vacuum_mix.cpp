// The habits by turns: a spiral, along the wall, lanes back and forth, some random bounces.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014 (random walk, spiral, S-shaped pathway, wall following: none wins, a combination does)
// Model       online by bumpers and a feeler (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp)
// Complexity  O(stretches * (edges near one + length / tool width))
// Decisions   1. The paper itself was not at hand: order and lengths of the turns are ours. Each ends at a contact, so
//                the next begins at a wall, the spiral `away` tool widths or less from it.
//             2. Along the wall for at most `follow` tool widths, so that a large room does not use up the run.
//             3. Lanes begin square off the wall, stepping aside to a random side.
#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {
  double pitch = 0.9, away = 16, follow = 60;
  int bounces = 10;
};

class VacuumMix final : public CoveragePlanner {
 public:
  explicit VacuumMix(Params p) : p_(p) {}
  Path plan(const Problem& problem, Context& context) const override {
    Vacuum vacuum(problem, context, p_);
    const double w = vacuum.tool_width();
    Point heading = vacuum.any_heading();
    while (auto wall = spiral(vacuum, p_.pitch * w, heading)) {
      follow(vacuum, 0, p_.follow * w, *wall);
      const Point side = context.rng().chance(0.5) ? perpendicular(*wall) : Point(-perpendicular(*wall));
      wall = snake(vacuum, p_.pitch * w, *wall, side);
      for (int k = 0; wall && k < p_.bounces; ++k) wall = vacuum.drive_on(vacuum.heading_off(*wall));
      if (!wall) break;
      heading = vacuum.heading_off(*wall);
      vacuum.drive(vacuum.at() + p_.away * w * context.rng().unit() * heading);
    }
    return vacuum.finish();
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo vacuum_mix() {
  return describe<VacuumMix, Params>(
      {.name = "vacuum-mix",
       .family = "baseline",
       .title = "spiral, wall, lanes and random bounces by turns",
       .citation = "after Hasan et al. 2014",
       .capabilities = {Capability::online, Capability::holes},
       .guarantee = "ends; coverage only in the limit",
       .parameters = with_stop_rule<Params>(
           {{"pitch", &Params::pitch, Range{0.05, 2}, "between laps and between lanes, in tool widths"},
            {"away", &Params::away, Range{0.1, 1000}, "farthest from the wall to the next spiral, in tool widths"},
            {"follow", &Params::follow, Range{0, 1e6}, "longest way along a wall, in tool widths"},
            {"bounces", &Params::bounces, Range{0, 1000}, "random stretches after the lanes"}})});
}

}  // namespace oxturn

// Along the wall at the right hand, then straight away to another wall.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014
// Model       online by bumpers and a feeler (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp)
// Complexity  O(length / tool width * edges near the robot)
// Decisions   1. It follows in steps of a sixteenth of the tool's width, corrected by the feeler after each.
//             2. After `laps` rounds of one wall it leaves it in a random heading for the next contact; 0: never. If
//                the wall led to another one (an island nearer than two distances), a round of that one counts as well.
//             3. `distance` 0 is contact: a thousandth of the tool's width. Where a passage is narrower than two
//                distances, the robot keeps to its middle; where it is stuck, it turns round and goes back along the
//                wall across.
#include <limits>

#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {
  double distance = 0;
  int laps = 1;
};

class WallFollow final : public CoveragePlanner {
 public:
  explicit WallFollow(Params p) : p_(p) {}
  Path plan(const Problem& problem, Context& context) const override {
    Vacuum vacuum(problem, context, p_);
    Point heading = vacuum.any_heading();
    while (const auto wall = vacuum.drive_on(heading)) {
      Point away = *wall;
      for (int lap = 0; !vacuum.done() && (lap < p_.laps || p_.laps == 0); lap += p_.laps > 0)
        follow(vacuum, p_.distance, std::numeric_limits<double>::infinity(), away);
      heading = vacuum.heading_off(away);
    }
    return vacuum.finish();
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo wall_follow() {
  return describe<WallFollow, Params>(
      {.name = "wall-follow",
       .family = "baseline",
       .title = "along the wall, then to another one",
       .citation = "after Hasan et al. 2014",
       .capabilities = {Capability::online, Capability::holes},
       .guarantee = "ends; sweeps along the walls it meets",
       .parameters = with_stop_rule<Params>(
           {{"distance", &Params::distance, Range{0, 1000}, "from the wall to the robot's rim, metres; 0: contact"},
            {"laps", &Params::laps, Range{0, 1000}, "rounds of one wall before it is left; 0: never left"}})});
}

}  // namespace oxturn

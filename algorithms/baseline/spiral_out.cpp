// A spiral until contact, straight away from the wall, the next spiral.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014
// Model       online by bumpers (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp)
// Complexity  O(stretches * (edges near one + length / tool width))
// Decisions   1. Between two spirals a random share of `away` tool widths, in a random heading off the wall, or until
//                the next contact.
//             2. Laps overlap by a tenth by default.
#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {
  double pitch = 0.9, away = 16;
};

class SpiralOut final : public CoveragePlanner {
 public:
  explicit SpiralOut(Params p) : p_(p) {}
  Path plan(const Problem& problem, Context& context) const override {
    Vacuum vacuum(problem, context, p_);
    Point heading = vacuum.any_heading();
    while (const auto wall = spiral(vacuum, p_.pitch * vacuum.tool_width(), heading)) {
      heading = vacuum.heading_off(*wall);
      vacuum.drive(vacuum.at() + p_.away * vacuum.tool_width() * context.rng().unit() * heading);
    }
    return vacuum.finish();
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo spiral_out() {
  return describe<SpiralOut, Params>(
      {.name = "spiral-out",
       .family = "baseline",
       .title = "a spiral until contact, straight away, the next spiral",
       .citation = "after Hasan et al. 2014",
       .capabilities = {Capability::online, Capability::holes},
       .guarantee = "ends; coverage only in the limit",
       .parameters = with_stop_rule<Params>(
           {{"pitch", &Params::pitch, Range{0.05, 2}, "between two laps, in tool widths"},
            {"away", &Params::away, Range{0.1, 1000}, "farthest from the wall to the next spiral, in tool widths"}})});
}

}  // namespace oxturn

// Straight on until contact, then on in a random heading.
//
// Source      after Hasan, Abdullah-Al-Nahid, Reza, "Path planning algorithm development for autonomous vacuum cleaner
//             robots", ICIEV 2014
// Model       online by bumpers (bumper.hpp), disc footprint
// Guarantee   ends (stop rule of habits.hpp); covers everything only in the limit
// Complexity  O(stretches * (edges near one + length / tool width))
// Decisions   1. All headings that lead away from the wall touched are equally likely.
#include "algorithms/baseline/habits.hpp"

namespace oxturn {
namespace {

struct Params : StopRule {};

class RandomWalk final : public CoveragePlanner {
 public:
  explicit RandomWalk(Params p) : p_(p) {}
  Path plan(const Problem& problem, Context& context) const override {
    Vacuum vacuum(problem, context, p_);
    Point heading = vacuum.any_heading();
    while (const auto away = vacuum.drive_on(heading)) heading = vacuum.heading_off(*away);
    return vacuum.finish();
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo random_walk() {
  return describe<RandomWalk, Params>({.name = "random-walk",
                                       .family = "baseline",
                                       .title = "straight until contact, then a random heading",
                                       .citation = "after Hasan et al. 2014",
                                       .capabilities = {Capability::online, Capability::holes},
                                       .guarantee = "ends; coverage only in the limit",
                                       .parameters = with_stop_rule<Params>({})});
}

}  // namespace oxturn

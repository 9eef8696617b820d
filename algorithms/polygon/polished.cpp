// Any planner, and then its path made shorter.
//
// Source      ours; see improve/improve.hpp
// Model       that of the planner, but offline
// Guarantee   covers the share `coverage` of the target, but for seams thinner than a 250th of the tool's width; never
//             longer than the planner's path, completed
// Complexity  that of the planner, and a few microseconds a move
// Decisions   1. Where the planner finds nothing to drive, as where no cell is free, all of the path is detours.
#include <utility>

#include "algorithms/improve/improve.hpp"
#include "algorithms/wrapper.hpp"

namespace oxturn {
namespace {

class Polished final : public CoveragePlanner {
 public:
  Polished(std::unique_ptr<CoveragePlanner> inner, const Improvement& how) : inner_(std::move(inner)), how_(how) {}

  Path plan(const Problem& problem, Context& context) const override {
    Path path;
    try {
      Context inner(context.seed(), context.seconds_left(), context.without_promise());
      if (context.cancelled()) inner.cancel();
      path = inner_->plan(problem, inner);
    } catch (const Infeasible&) {  // Decision 1
      if (context.cancelled()) throw;
    }
    return improved(problem, {{std::move(path)}}, how_, context);
  }

 private:
  std::unique_ptr<CoveragePlanner> inner_;
  Improvement how_;
};

}  // namespace

PlannerInfo polished() {
  PlannerInfo info = improving_planner(
      "polished", "any planner, and then its path made shorter by annealing",
      "covers the share `coverage` of the target; never longer than the path of `planner`, completed");
  return wrapper(std::move(info), "boustrophedon", [](Wrapped inner, Settings own) {
    own.erase("planner");
    return std::make_unique<Polished>(std::move(inner.planner),
                                      with_settings<Improvement>("planner 'polished'", improvement_parameters(), own));
  });
}

}  // namespace oxturn

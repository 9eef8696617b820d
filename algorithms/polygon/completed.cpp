// Any planner, and then whatever its path leaves uncovered.
//
// Source      ours; see lanes/repair.hpp
// Model       that of the planner, but offline: what is left is found on the true map
// Guarantee   covers the whole target, but for seams thinner than a 250th of the tool's width
// Complexity  that of the planner, plus O(m log m) for a path of m segments
// Decisions   1. What is left is added as detours, each from where the path passes next to it. A planner that leaves
//                little keeps its path; one that leaves much is better run with other parameters.
//             2. Where the planner finds nothing to drive, as where no cell is free, all of the path is detours.
#include <utility>

#include "algorithms/lanes/repair.hpp"
#include "algorithms/wrapper.hpp"

namespace oxturn {
namespace {

class Completed final : public CoveragePlanner {
 public:
  explicit Completed(std::unique_ptr<CoveragePlanner> inner) : inner_(std::move(inner)) {}

  Path plan(const Problem& problem, Context& context) const override {
    Path path;
    try {
      Context inner(context.seed(), context.seconds_left(), context.without_promise());
      path = inner_->plan(problem, inner);
    } catch (const Infeasible&) {}  // Decision 2
    context.publish(path);
    return context.cancelled() ? path : repaired(problem, path, Connector(problem), context);
  }

 private:
  std::unique_ptr<CoveragePlanner> inner_;
};

}  // namespace

PlannerInfo completed() {
  PlannerInfo info;
  info.name = "completed";
  info.family = "polygon";
  info.title = "any planner, and then whatever its path leaves uncovered";
  info.citation = "oxturn";
  info.capabilities = {Capability::holes, Capability::footprint};
  info.guarantee = "covers the whole target, whatever `planner` covers of it";
  info.promise = Promise::target;
  info.symmetries = {Symmetry::shift, Symmetry::scale};
  return wrapper(std::move(info), "stc",
                 [](Wrapped inner, const Settings&) { return std::make_unique<Completed>(std::move(inner.planner)); });
}

}  // namespace oxturn

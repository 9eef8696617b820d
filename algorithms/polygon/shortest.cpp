// The shortest path that a budget of moves finds: the zoo's short paths, annealed.
//
// Source      ours; see improve/improve.hpp
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the share `coverage` of the target, but for seams thinner than a 250th of the tool's width; never
//             longer than its start, completed
// Complexity  a few microseconds a move
// Decisions   1. The start is `boustrophedon` without outline.
#include "algorithms/coverage_planner.hpp"
#include "algorithms/improve/improve.hpp"

namespace oxturn {
namespace {

class Shortest final : public CoveragePlanner {
 public:
  Shortest(const Improvement& how, const Planners& planners)
      : how_(how), start_(planners.find("boustrophedon").make({{"outline", false}}, planners)) {}

  Path plan(const Problem& problem, Context& context) const override {
    return improved(problem, start_->plan(problem, context), how_, context);
  }

 private:
  Improvement how_;
  std::unique_ptr<CoveragePlanner> start_;
};

}  // namespace

PlannerInfo shortest() {
  PlannerInfo info;
  info.name = "shortest";
  info.family = "polygon";
  info.title = "the shortest path that a budget finds, by annealing";
  info.citation = "oxturn";
  info.capabilities = {Capability::holes, Capability::footprint};
  info.guarantee = "covers the share `coverage` of the target; never longer than its start";
  info.promise = Promise::target;
  info.parameters = infos_of(improvement_parameters());
  info.promises_with = covers_all;
  info.covers_target_areas = true;
  info.make = [](const Settings& settings, const Planners& planners) {
    return std::make_unique<Shortest>(
        with_settings<Improvement>("planner 'shortest'", improvement_parameters(), settings), planners);
  };
  return info;
}

}  // namespace oxturn

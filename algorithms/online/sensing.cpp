#include "algorithms/online/sensing.hpp"

#include "algorithms/online/survey_then_plan.hpp"

namespace oxturn {
namespace {

class Surveyed final : public CoveragePlanner {
 public:
  explicit Surveyed(std::unique_ptr<CoveragePlanner> planner) : planner_(std::move(planner)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return plan_online(problem, context,
                       [&](const Problem& believed, Context& inner) { return planner_->plan(believed, inner); });
  }

 private:
  std::unique_ptr<CoveragePlanner> planner_;
};

}  // namespace

PlannerInfo with_sensing(PlannerInfo planner) {
  const ParameterInfo sensing{"sensing",
                              std::string("map"),
                              {},
                              {"map", "lidar"},
                              "map: known beforehand; lidar: explored first by the robot's lidar"};
  planner.capabilities.push_back(Capability::online);
  planner.parameters.push_back(sensing);
  planner.make = [make = std::move(planner.make), owner = "planner '" + planner.name + "'", sensing](
                     Settings settings, const Planners& planners) -> std::unique_ptr<CoveragePlanner> {
    const auto given = settings.find("sensing");
    const bool lidar =
        given != settings.end() && std::get<std::string>(checked(owner, sensing, given->second)) == "lidar";
    settings.erase("sensing");
    auto offline = make(settings, planners);
    if (!lidar) return offline;
    return std::make_unique<Surveyed>(std::move(offline));
  };
  return planner;
}

}  // namespace oxturn

#include "algorithms/size_limited_planner.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace oxturn {
namespace {

constexpr double kMostSquares = 1e8;

void require_coverable(const Problem& problem) {
  if (problem.map().drawing) return;
  const double width = problem.robot().tool_width, free = area(problem.work_space()), squares = free / width / width;
  if (squares > kMostSquares)
    throw Infeasible(fmt::format(
        "the robot can be anywhere in {:.3g} m2 of '{}': {:.3g} squares as wide as the tool ({:g} m), more than 1e8; "
        "take a wider tool or a smaller map, or check the map's scale",
        free, problem.map().name, squares, width));
}

class SizeLimited final : public CoveragePlanner {
 public:
  explicit SizeLimited(std::unique_ptr<CoveragePlanner> inner) : inner_(std::move(inner)) {}
  Path plan(const Problem& problem, Context& context) const override {
    require_coverable(problem);
    return inner_->plan(problem, context);
  }

 private:
  std::unique_ptr<CoveragePlanner> inner_;
};

}  // namespace

PlannerInfo size_limited_planner(PlannerInfo info) {
  if (std::ranges::any_of(info.parameters, [](const ParameterInfo& p) { return p.name == "cell_size"; })) return info;
  info.make = [make = std::move(info.make)](const Settings& settings, const Planners& planners) {
    return std::make_unique<SizeLimited>(make(settings, planners));
  };
  return info;
}

}  // namespace oxturn

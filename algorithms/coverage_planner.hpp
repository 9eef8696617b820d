/// The interface that every planner implements.
///
///   const Planners planners = built_in_planners();
///   const auto planner = planners.find("stc").make({{"tree", "dfs"}}, planners);
///   Context context;
///   const Path path = planner->plan(problem, context);
#pragma once

#include "algorithms/context.hpp"
#include "algorithms/planner_info.hpp"
#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class CoveragePlanner {
 public:
  virtual ~CoveragePlanner() = default;
  /// Throws Infeasible, Unsupported or std::invalid_argument. Keeps no state between calls.
  virtual Path plan(const Problem& problem, Context& context) const = 0;
};

/// A planner that is one function of its parameters. If these have a member check(), which throws std::invalid_argument
/// for values that exclude each other, no planner is made of such.
template <class P, Path (*run)(const P&, const Problem&, Context&)>
class FunctionPlanner final : public CoveragePlanner {
 public:
  explicit FunctionPlanner(P params) : params_(std::move(params)) {
    if constexpr (requires { params_.check(); }) params_.check();
  }
  Path plan(const Problem& problem, Context& context) const override { return run(params_, problem, context); }

 private:
  P params_;
};
///   return describe<Params, plan_stc>({.name = "stc", ...});
template <class P, Path (*run)(const P&, const Problem&, Context&)>
PlannerInfo describe(Description<P> d) {
  return describe<FunctionPlanner<P, run>, P>(std::move(d));
}

}  // namespace oxturn

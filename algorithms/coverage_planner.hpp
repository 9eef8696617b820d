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

}  // namespace oxturn

/// Planners that run another planner, named by their parameter `planner`; its own parameters are given beside it.
///
///   PlannerInfo info;                        // name, family, own parameters, ...
///   return wrapper(std::move(info), "stc", [](Wrapped inner, const Settings& own) {
///     return std::make_unique<Completed>(std::move(inner.planner));
///   });
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

/// The planner within, and what it promises with its settings.
struct Wrapped {
  std::unique_ptr<CoveragePlanner> planner;
  Promise promise;
};

/// Makes the wrapper from the planner within and the wrapper's own settings, all of them.
using MakeWrapper = std::function<std::unique_ptr<CoveragePlanner>(Wrapped inner, const Settings& own)>;

/// `info` without `make` and without the parameter `planner`, which is added. The planner within may be any that does
/// not handle a tether itself and is no wrapper.
PlannerInfo wrapper(PlannerInfo info, const std::string& default_planner, MakeWrapper make);

}  // namespace oxturn

// The built-in planners with small budgets, for tests that run all of them.
#pragma once

#include <cstdint>

#include "tests/support/planners.hpp"

namespace oxturn {

inline constexpr std::int64_t kBriefMoves = 3000;

/// With few moves by default, if that is its budget.
inline PlannerInfo brief(PlannerInfo planner) {
  for (ParameterInfo& parameter : planner.parameters) {
    if (parameter.name != "moves") continue;
    parameter.fallback = kBriefMoves;
    planner.make = [make = planner.make](Settings settings, const Planners& planners) {
      settings.emplace("moves", kBriefMoves);
      return make(settings, planners);
    };
  }
  return planner;
}

inline const Planners& brief_built_in() {
  static const Planners all = [] {
    Planners planners("planner", {});
    for (const PlannerInfo& planner : built_in_planners()) planners.add(brief(planner));
    return planners;
  }();
  return all;
}

}  // namespace oxturn

// The built-in planners, made once for all tests.
#pragma once

#include <memory>
#include <string>

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

inline const Planners& built_in() {
  static const Planners all = built_in_planners();
  return all;
}

inline std::unique_ptr<CoveragePlanner> built_in_planner(const std::string& name, const Settings& settings = {}) {
  return built_in().find(name).make(settings, built_in());
}

}  // namespace oxturn

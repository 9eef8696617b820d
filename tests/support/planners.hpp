// The built-in planners, made once for all tests, and a run with all that it hands out.
#pragma once

#include <map>
#include <memory>
#include <set>
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

/// A path with the figures that the planner recorded and the names of the drawings that it made.
struct RecordedPlan {
  Path path;
  std::map<std::string, double> figures;
  std::set<std::string> traces;
};
inline RecordedPlan plan_recorded(const std::string& name, const Problem& problem, const Settings& settings = {},
                                  std::uint64_t seed = 1) {
  RecordedPlan result;
  Context::Sinks sinks;
  sinks.record = [&](const std::string& figure, double value) { result.figures[figure] = value; };
  sinks.trace = [&](const Trace& trace) { result.traces.insert(trace.name); };
  Context context(seed, 1e9, sinks);
  result.path = built_in_planner(name, settings)->plan(problem, context);
  return result;
}

}  // namespace oxturn

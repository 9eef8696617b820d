// Descriptions as data: what a planner can do, whether it fits a problem, and finding one by name.
#include <fmt/format.h>

#include <algorithm>

#include "algorithms/coverage_planner.hpp"
#include "base/text.hpp"

namespace oxturn {

std::string to_text(Capability capability) {
  switch (capability) {
    case Capability::tether:
      return "tether";
    case Capability::online:
      return "online";
    case Capability::holes:
      return "holes";
    case Capability::curvature:
      return "curvature";
    case Capability::footprint:
      return "footprint";
  }
  return "unknown";  // not reached: the switch names all
}

bool PlannerInfo::has(Capability capability) const {
  return std::find(capabilities.begin(), capabilities.end(), capability) != capabilities.end();
}

std::vector<ParameterInfo> parameters_of(const PlannerInfo& planner, const Settings& settings) {
  std::vector<ParameterInfo> all = planner.parameters;
  if (planner.more_parameters) {
    const std::vector<ParameterInfo> more = planner.more_parameters(settings);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::string missing_capability(const PlannerInfo& planner, const Problem& problem) {
  const auto lacks = [&](Capability capability, const char* why) {
    return fmt::format("planner '{}' has no capability '{}', which {}", planner.name, to_text(capability), why);
  };
  if (problem.robot().tether && !planner.has(Capability::tether))
    return lacks(Capability::tether, "a tethered robot asks for");
  if (problem.robot().min_turn_radius > 0 && !planner.has(Capability::curvature))
    return lacks(Capability::curvature, "a robot that cannot turn on the spot asks for");
  if (!problem.robot().footprint.empty() && !planner.has(Capability::footprint))
    return lacks(Capability::footprint, "a robot that is no disc asks for");
  if (hole_count(problem.configuration_space()) > 0 && !planner.has(Capability::holes))
    return lacks(Capability::holes, "a map with obstacles inside asks for");
  return {};
}

const PlannerInfo& find_planner(const std::vector<PlannerInfo>& planners, const std::string& name) {
  std::vector<std::string> names;
  for (const PlannerInfo& planner : planners) {
    if (planner.name == name) return planner;
    names.push_back(planner.name);
  }
  if (names.empty()) throw std::invalid_argument(fmt::format("no planner '{}': there are none", name));
  throw std::invalid_argument(fmt::format("no planner '{}'; did you mean '{}'? There are: {}", name,
                                          nearest_name(name, names), fmt::join(names, ", ")));
}

}  // namespace oxturn

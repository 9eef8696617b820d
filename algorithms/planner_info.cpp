#include "algorithms/planner_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace oxturn {

std::string to_text(Capability capability) {
  static const std::array kNames{"tether", "online", "holes", "curvature", "footprint"};  // in the enumerators' order
  return kNames.at(static_cast<std::size_t>(capability));
}

std::string to_text(Symmetry symmetry) {
  static const std::array kNames{"shift", "quarter-turn", "mirror", "scale"};  // in the enumerators' order
  return kNames.at(static_cast<std::size_t>(symmetry));
}

bool PlannerInfo::has(Capability capability) const {
  return std::find(capabilities.begin(), capabilities.end(), capability) != capabilities.end();
}

Promise PlannerInfo::promised(const Settings& settings, const Robot& robot) const {
  if (robot.min_turn_radius > 0) return Promise::nothing;
  return !promises_with || promises_with(settings) ? promise : Promise::nothing;
}

std::vector<ParameterInfo> parameters_of(const PlannerInfo& planner, const Settings& settings,
                                         const Planners& planners) {
  std::vector<ParameterInfo> all = planner.parameters;
  if (planner.more_parameters) {
    const std::vector<ParameterInfo> more = planner.more_parameters(settings, planners);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

ParameterInfo variant_parameter(const Settings& published) {
  return {"variant",
          std::string("improved"),
          {},
          {"improved", "published"},
          fmt::format("published: exactly what the source says ({})", to_text(published))};
}

Settings with_variant(const PlannerInfo& planner, Settings settings) {
  const auto variant = settings.find("variant");
  if (planner.published.empty() || variant == settings.end() || variant->second != Value(std::string("published")))
    return settings;
  settings.insert(planner.published.begin(), planner.published.end());
  return settings;
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

}  // namespace oxturn

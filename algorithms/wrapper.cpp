#include "algorithms/wrapper.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace oxturn {
namespace {

constexpr const char* kPlanner = "planner";

const PlannerInfo& inner_of(const PlannerInfo& info, const Settings& settings, const Planners& planners) {
  const auto given = settings.find(kPlanner);
  const std::string* name = given == settings.end() ? nullptr : std::get_if<std::string>(&given->second);
  const PlannerInfo& inner = planners.find(
      name != nullptr ? *name : std::get<std::string>(find_parameter("", info.parameters, kPlanner).fallback));
  if (inner.has(Capability::tether))
    throw std::invalid_argument(fmt::format(
        "planner '{}': planner '{}' handles the tether itself; expected one that does not", info.name, inner.name));
  if (inner.more_parameters)
    throw std::invalid_argument(fmt::format(
        "planner '{}': planner '{}' runs another planner itself; expected one that does not", info.name, inner.name));
  return inner;
}

}  // namespace

PlannerInfo wrapper(PlannerInfo info, const std::string& default_planner, MakeWrapper make) {
  info.parameters.insert(info.parameters.begin(),
                         {kPlanner, default_planner, {}, {}, "name of the planner; its own parameters go beside it"});
  info.more_parameters = [info](const Settings& settings, const Planners& planners) {
    return inner_of(info, settings, planners).parameters;
  };
  info.make = [info, make = std::move(make)](const Settings& settings, const Planners& planners) {
    const std::string owner = fmt::format("planner '{}'", info.name);
    const PlannerInfo& inner = inner_of(info, settings, planners);
    const std::vector<ParameterInfo> all = parameters_of(info, settings, planners);
    Settings own, of_inner;
    for (const ParameterInfo& parameter : info.parameters) own[parameter.name] = parameter.fallback;
    for (const auto& [name, value] : settings)
      (own.count(name) > 0 ? own : of_inner)[name] = checked(owner, find_parameter(owner, all, name), value);
    return make({inner.make(of_inner, planners), inner.promised(of_inner)}, own);
  };
  return info;
}

}  // namespace oxturn

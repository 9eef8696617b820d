#include "cli/programs.hpp"

#include <algorithm>

#include "bench/external_planner.hpp"

namespace oxturn::cli {

void add_programs(CLI::App& app, std::vector<std::string>& commands) {
  app.add_option("--exec", commands,
                 "a command that is a planner, in any language: docs/planners/README.md; it joins the planners under "
                 "the name that it describes (may be repeated)")
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("CMD");
}

Extended with_programs(const Registry& registry, const std::vector<std::string>& commands) {
  Extended extended{registry, {}};
  for (const std::string& command : commands)
    extended.names.push_back(add_external_planner(extended.registry.planners, {command}));
  return extended;
}

void add_unnamed(const std::vector<std::string>& planners, Suite& suite) {
  for (const std::string& name : planners) {
    const bool named = std::any_of(suite.planners.begin(), suite.planners.end(),
                                   [&](const PlannerSpec& spec) { return spec.name == name; });
    if (!named) suite.planners.push_back({.name = name, .settings = {}});
  }
}

}  // namespace oxturn::cli

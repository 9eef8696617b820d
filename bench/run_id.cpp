#include "bench/run_id.hpp"

#include <fmt/format.h>

#include "base/sha256.hpp"

namespace oxturn {

Settings full_settings(const PlannerInfo& planner, const Settings& settings, const Planners& planners) {
  Settings all = with_variant(planner, settings);
  for (const ParameterInfo& parameter : parameters_of(planner, settings, planners))
    all.emplace(parameter.name, parameter.fallback);
  return all;
}

std::vector<const PlannerInfo*> from_outside(const PlannerInfo& planner, const Settings& settings,
                                             const Planners& planners) {
  std::vector<const PlannerInfo*> all;
  if (!planner.identity.empty()) all.push_back(&planner);
  for (const ParameterInfo& parameter : parameters_of(planner, settings, planners)) {
    const auto setting = settings.find(parameter.name);
    if (setting == settings.end() || !parameter.choices.empty()) continue;  // a choice is no name of a planner
    const std::string* text = std::get_if<std::string>(&setting->second);
    const PlannerInfo* named = text != nullptr ? planners.get(*text) : nullptr;
    if (named != nullptr && !named->identity.empty()) all.push_back(named);
  }
  return all;
}

std::string identified(const PlannerInfo& planner, const Settings& settings, const Planners& planners) {
  std::string text = planner.name;
  for (const PlannerInfo* part : from_outside(planner, settings, planners)) text += " " + part->identity;
  return text;
}

std::string suite_identity(const Suite& suite, const Planners& planners) {
  const auto located = [](const std::optional<Location>& at) { return at ? to_text(*at) : std::string("-"); };
  const Limits& limits = suite.limits;
  std::string text =
      fmt::format("suite {}\nseed {}\nrepeats {}\nwarm-ups {}\ncoverage {}\nlimits {} {} {}\n", suite.name, suite.seed,
                  suite.repeats, suite.warm_ups, suite.target_coverage, limits.wall_s, limits.cpu_s, limits.memory_mb);
  for (const Robot& robot : suite.robots) text += fmt::format("robot {} {}\n", robot.name, canonical_text(robot));
  for (const MapSpec& map : suite.maps)
    text += fmt::format("map {} {} {} {} {} {} {} {}{}\n", map.name, map.generator, to_text(map.settings), map.seed,
                        to_text(map.read), located(map.start), located(map.anchor),
                        map.content ? content_hash(map.content->map) : "-",
                        map.target_area ? " " + sha256(canonical_bytes(*map.target_area)) : "");
  for (const PlannerSpec& spec : suite.planners)
    text +=
        fmt::format("planner {} {}\n", identified(planners.find(spec.name), spec.settings, planners), spec.variant());
  return sha256(text).substr(0, 16);
}

std::string run_id(const std::string& map, const std::string& robot, const std::string& problem,
                   const std::string& planner, const Settings& settings, std::uint64_t seed, int repeat,
                   const std::string& build) {
  return sha256(fmt::format(
                    "schema 1\nmap {}\nrobot {}\nproblem {}\nplanner {}\nsettings {}\nseed {}\nrepeat {}\nbuild {}\n",
                    map, robot, problem, planner, to_text(settings), seed, repeat, build))
      .substr(0, 16);
}

std::uint64_t run_seed(std::uint64_t suite_seed, const std::string& planner, const std::string& problem, int repeat) {
  return mix(suite_seed, fmt::format("{}\n{}\n{}", planner, problem, repeat)) >> 11;
}

}  // namespace oxturn

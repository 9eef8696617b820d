#include "bench/run_id.hpp"

#include <fmt/format.h>

#include "base/sha256.hpp"

namespace oxturn {

std::string settings_text(const Settings& settings) {
  std::string out;
  for (const auto& [name, value] : settings)
    out += fmt::format("{}{}={}", out.empty() ? "" : ";", name, to_text(value));
  return out;
}

Settings full_settings(const PlannerInfo& planner, const Settings& settings) {
  Settings all = settings;
  for (const ParameterInfo& parameter : parameters_of(planner, settings))
    all.emplace(parameter.name, parameter.fallback);
  return all;
}

std::string run_id(const std::string& map, const std::string& robot, const std::string& problem,
                   const PlannerInfo& planner, const Settings& settings, std::uint64_t seed, int repeat,
                   bool ignore_tether) {
  Settings all = full_settings(planner, settings);
  if (ignore_tether) all[kIgnoreTether] = true;
  return sha256(fmt::format("schema 1\nmap {}\nrobot {}\nproblem {}\nplanner {}\nsettings {}\nseed {}\nrepeat {}\n",
                            map, robot, problem, planner.name, settings_text(all), seed, repeat))
      .substr(0, 16);
}

std::uint64_t run_seed(std::uint64_t suite_seed, const std::string& planner, const std::string& problem, int repeat) {
  return mix(suite_seed, fmt::format("{}\n{}\n{}", planner, problem, repeat)) >> 11;
}

}  // namespace oxturn

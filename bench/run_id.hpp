/// The identity of a run: one combination of a suite, named by a hash of everything that determines it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/suite.hpp"

namespace oxturn {

/// The suite key that is no parameter of any planner.
inline constexpr const char* kIgnoreTether = "ignore_tether";

/// Every parameter of the planner: `settings` over the defaults (those of `variant = published`, if that is set).
Settings full_settings(const PlannerInfo& planner, const Settings& settings, const Planners& planners);

/// The planners from outside that take part in a run: the planner itself, and those that its settings name.
std::vector<const PlannerInfo*> from_outside(const PlannerInfo& planner, const Settings& settings,
                                             const Planners& planners);
/// The planner's name, and the identities of those from outside.
std::string identified(const PlannerInfo& planner, const Settings& settings, const Planners& planners);

/// A hash of everything that a suite runs, on what and how, the contents of its map files included. Its maps must have
/// names.
std::string suite_identity(const Suite& suite, const Planners& planners);

/// First 16 hex digits of a SHA-256. Limits do not count: they may end a run, they do not make it another one.
/// `problem` is Problem::content_hash(), or any text in place of a problem that cannot be built.
/// `planner`: identified(). `settings`: all that the planner takes (full_settings). `build`: build_identity().
std::string run_id(const std::string& map, const std::string& robot, const std::string& problem,
                   const std::string& planner, const Settings& settings, std::uint64_t seed, int repeat,
                   const std::string& build);

/// The planner's seed: equal for all variants of a planner, so that variants are compared on the same random numbers.
/// Below 2^53, so that every reader of the CSV keeps it exactly.
std::uint64_t run_seed(std::uint64_t suite_seed, const std::string& planner, const std::string& problem, int repeat);

}  // namespace oxturn

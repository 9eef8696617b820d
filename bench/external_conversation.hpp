/// The conversation with an external planner about one problem. Internal to bench/.
///
///   const auto planner = converse_with({"python3 lanes.py"}, settings);
///   const Path path = planner->plan(problem, context);      // starts the program, and waits for its end
#pragma once

#include <memory>
#include <string>

#include "algorithms/coverage_planner.hpp"
#include "bench/external_program.hpp"

namespace oxturn {

/// `settings`: of every parameter. plan() throws for an answer that is none: std::runtime_error with the number and
/// the beginning of the line, WorkEnded for a program that was killed or failed.
std::unique_ptr<CoveragePlanner> converse_with(const ShellCommand& command, Settings settings);

/// How a program ended that should not have: "exited with code 3; it printed last: ...".
std::string ending_of(const ExternalProgram& program, const ExternalProgram::End& end);

}  // namespace oxturn

/// Planners that are programs of their own, in any language. docs/planners/README.md describes what they say and hear.
///
///   registry.planners.add(external_planner({"python3 lanes.py"}));     // asks it for its description
///   oxturn run quick --exec 'python3 lanes.py' -o out                  // the same on the command line
///
/// `python3 lanes.py --describe` prints what the planner is. For a run the command is started in the process in which
/// built-in planners run, too, so that limits, outcomes and what is left running are the same for all.
#pragma once

#include <string>

#include "algorithms/planner_info.hpp"

namespace oxturn {

/// A command for /bin/sh.
struct ShellCommand {
  std::string text;
  std::string folder = {};  // in which it is started; empty: the current one
};

/// What the command says of itself, and how to run it. Its `identity` is a hash of the command's text, its description
/// and the program files that the command names. Takes as long as the program takes to describe itself, at most 20 s.
/// Throws std::invalid_argument with a sentence that names the command and what is wrong with its description. The
/// caller must be single-threaded.
PlannerInfo external_planner(const ShellCommand& command);

/// Adds the planner to the list unless it is there already, and returns its name. Throws std::invalid_argument as
/// external_planner() does, and for a name that another planner has.
std::string add_external_planner(Planners& planners, const ShellCommand& command);

}  // namespace oxturn

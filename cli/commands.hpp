/// The commands of the program, listed in cli/commands.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "bench/registry.hpp"

namespace oxturn::cli {

struct Command {
  std::string name, title;
  std::string examples;  // one a line, shown by --help
  /// Declares the command's options on `app`. The function returned runs it and returns the exit code: 0 done, 1 a
  /// check failed. Bad input is an exception, which main turns into one line and exit code 2. `registry` outlives both.
  std::function<int()> (*attach)(CLI::App& app, const Registry& registry);
};
const std::vector<Command>& commands();

// One a file.
Command list_command();
Command map_command();
Command plan_command();
Command draw_command();
Command score_command();
Command run_command();
Command check_command();
Command report_command();
Command rescore_command();
Command merge_command();
Command missing_command();
Command completion_command();
Command man_command();

/// What `oxturn list` lists: planners, maps, ...
std::vector<std::string> kinds_of_lists();

}  // namespace oxturn::cli

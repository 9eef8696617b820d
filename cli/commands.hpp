// The commands of the program; listed in cli/commands.cpp and nowhere else.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace oxturn::cli {

struct Command {
  std::string name, title;
  std::string examples;  // one a line, shown by --help
  /// Declares the command's options on `app`. The answer runs it and gives the exit code: 0 done, 1 a check
  /// failed. Bad input is an exception, which main makes one line and exit code 2.
  std::function<int()> (*attach)(CLI::App& app);
};
const std::vector<Command>& commands();

// One a file.
Command list_command();
Command map_command();
Command plan_command();
Command score_command();
Command run_command();
Command report_command();

}  // namespace oxturn::cli

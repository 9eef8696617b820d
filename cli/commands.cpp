// cli/commands.cpp: the one list of commands
#include "cli/commands.hpp"

namespace oxturn::cli {

const std::vector<Command>& commands() {
  static const std::vector<Command> all{list_command(),    map_command(),   plan_command(),    draw_command(),
                                        score_command(),   run_command(),   check_command(),   report_command(),
                                        rescore_command(), merge_command(), missing_command(), completion_command(),
                                        man_command()};
  return all;
}

}  // namespace oxturn::cli

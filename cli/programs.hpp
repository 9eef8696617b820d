/// External planners on the command line: `--exec 'python3 lanes.py'`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bench/registry.hpp"
#include "bench/suite.hpp"

namespace oxturn::cli {

/// `--exec CMD`, repeated.
void add_programs(CLI::App& app, std::vector<std::string>& commands);

struct Extended {
  Registry registry;
  std::vector<std::string> names;  // of the planners of the commands, in their order
};
/// The registry with the external planners that the commands start in the current folder. Asks each for its
/// description; throws std::invalid_argument for one that has no good answer.
Extended with_programs(const Registry& registry, const std::vector<std::string>& commands);

/// Planners given on the command line take part whether or not the suite names them.
void add_unnamed(const std::vector<std::string>& planners, Suite& suite);

}  // namespace oxturn::cli

/// Plug-ins on the command line: `--plugin ./wavy.so`, of every command.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/registry.hpp"

namespace oxturn::cli {

/// The registry with the plug-ins that the arguments name: before the commands are described, because these list what
/// the registry holds. Throws as load_plugin() does.
Registry with_plugins(Registry registry, int argc, const char* const* argv);
/// Declares the option on a command, for its help and so that it is accepted.
void add_plugin_option(CLI::App& command);

}  // namespace oxturn::cli

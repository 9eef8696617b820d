/// The oxturn program as a function: arguments in, one command, one exit code.
///
///   return run_program(argc, argv, built_in_registry());
#pragma once

#include "bench/registry.hpp"

namespace oxturn::cli {

/// 0: done; 1: a check failed; 2: bad input, told in one line on standard error. Never throws.
int run_program(int argc, const char* const* argv, const Registry& registry);

}  // namespace oxturn::cli

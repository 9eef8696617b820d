#include "base/heap.hpp"
#include "cli/program.hpp"
#include "reports/built_in_registry.hpp"

namespace {
constexpr double kReserved = 2e9;  // bytes, for maps and problems
}

int main(int argc, char** argv) {
  oxturn::keep_freed_memory();
  oxturn::reserve_heap(kReserved);
  return oxturn::cli::run_program(argc, argv, oxturn::built_in_registry());
}

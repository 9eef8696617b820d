#include "base/heap.hpp"
#include "cli/program.hpp"
#include "reports/built_in_registry.hpp"

int main(int argc, char** argv) {
  oxturn::keep_freed_memory();
  oxturn::reserve_heap(2e9);  // for maps and problems; forked processes have it too
  return oxturn::cli::run_program(argc, argv, oxturn::built_in_registry());
}

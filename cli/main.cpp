#include <cstdlib>  // defines __GLIBC__
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <limits>

#include "cli/program.hpp"
#include "reports/built_in_registry.hpp"

namespace {

/// Planners of large maps, and scoring, make and drop vectors of up to hundreds of megabytes. By default glibc gives
/// each back to the system at once, which clears the pages again for the next: a sixth of smooth-spiral's time at 10^6
/// tool squares, and of scoring its path. Kept instead, they take up to a sixth more memory.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMost = std::numeric_limits<int>::max();  // bytes
  mallopt(M_MMAP_THRESHOLD, kMost);
  mallopt(M_TRIM_THRESHOLD, kMost);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  return oxturn::cli::run_program(argc, argv, oxturn::built_in_registry());
}

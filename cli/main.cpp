#include <cstdlib>  // defines __GLIBC__
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "cli/program.hpp"
#include "reports/built_in_registry.hpp"

namespace {

/// Planners of large maps make and drop vectors of megabytes all the time. By default glibc gives each back to the
/// system at once, which clears the pages again for the next: a tenth of smooth-spiral's time at 10^6 tool squares.
/// Kept instead, they take up to a sixth more memory.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 128 * kMegabyte);
  mallopt(M_TRIM_THRESHOLD, 512 * kMegabyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  return oxturn::cli::run_program(argc, argv, oxturn::built_in_registry());
}

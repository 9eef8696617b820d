#include "base/heap.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>  // defines __GLIBC__
#include <fstream>
#include <limits>
#include <memory>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/sanitized.hpp"

namespace oxturn {

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, std::numeric_limits<int>::max());  // bytes
  mallopt(M_TRIM_THRESHOLD, -1);                               // never
#endif
}

#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;
constexpr std::size_t kBlock = std::size_t{1} << 30;  // less than what keep_freed_memory() takes out of the heap

void ask_for_huge_pages(void* block, std::size_t size) {
  std::size_t left = size;
  if (void* begin = block; std::align(kHugePage, kHugePage, begin, left) != nullptr)
    ::madvise(begin, left / kHugePage * kHugePage, MADV_HUGEPAGE);
}

/// vm.overcommit_memory = 2: address space counts as memory in use, and soon there is none left for other processes.
bool address_space_is_scarce() {
  char mode = '0';
  std::ifstream("/proc/sys/vm/overcommit_memory") >> mode;
  return mode == '2';
}

}  // namespace

void reserve_heap(double bytes) {
  if (kSanitized || address_space_is_scarce()) return;
  const double memory = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  if (!(bytes > 0)) return;
  auto left = static_cast<std::size_t>(std::min(bytes, memory));
  std::vector<void*> blocks;
  blocks.reserve(left / kBlock + 1);  // else they would lie behind a block
  while (left > 0) {
    const std::size_t size = std::min(kBlock, left);
    void* block = std::malloc(size);
    if (block == nullptr) break;
    ask_for_huge_pages(block, size);
    blocks.push_back(block);
    left -= size;
  }
  for (void* block : blocks) std::free(block);  // they join what is free at the end of the heap
}

void give_back_freed_memory() {
  const auto* end = static_cast<const char*>(::sbrk(0));
  ::malloc_trim(0);
  reserve_heap(static_cast<double>(end - static_cast<const char*>(::sbrk(0))));
}
#else
void reserve_heap(double) {}
void give_back_freed_memory() {}
#endif

}  // namespace oxturn

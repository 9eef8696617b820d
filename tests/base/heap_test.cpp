#include "base/heap.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace oxturn {
namespace {

/// Of this process, in kB; -1: the system does not tell.
long huge_pages() {
  std::ifstream file("/proc/self/smaps_rollup");
  for (std::string word; file >> word;)
    if (long size = 0; word == "AnonHugePages:" && file >> size) return size;
  return -1;
}
bool are_given() {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string modes;
  std::getline(file, modes);
  return !modes.empty() && modes.find("[never]") == std::string::npos;
}
constexpr bool kOwnHeap =
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    true;
#else
    false;
#endif

TEST(Heap, LargeVectorsLieInHugePagesAfterReserve) {
  if (!kOwnHeap || !are_given() || huge_pages() < 0) GTEST_SKIP() << "the system gives no huge pages";
  keep_freed_memory();
  reserve_heap(1.5e9);
  const long before = huge_pages();
  const std::vector<char> touched(64 << 20, 'x');
  EXPECT_GE(huge_pages() - before, 32 << 10) << touched.front();
  // Reserving again neither takes what is in use nor extends what is free.
  reserve_heap(1e9);
  EXPECT_EQ(touched.back(), 'x');
}

TEST(Heap, ReserveOfNothingOrOfMoreThanThereIsDoesNothing) {
  reserve_heap(0);
  reserve_heap(-1);
  reserve_heap(1e6);
  reserve_heap(1e15);
  EXPECT_EQ(std::vector<int>(1000, 7).back(), 7);
}

}  // namespace
}  // namespace oxturn

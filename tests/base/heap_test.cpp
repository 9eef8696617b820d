#include "base/heap.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "base/sanitized.hpp"

namespace oxturn {
namespace {

/// What a file of /proc says of this process, in kB; -1: nothing.
long kilobytes(const char* name, const char* key) {
  std::ifstream file(std::string("/proc/self/") + name);
  for (std::string word; file >> word;)
    if (long size = 0; word == key && file >> size) return size;
  return -1;
}
long huge_pages() { return kilobytes("smaps_rollup", "AnonHugePages:"); }
long resident() { return kilobytes("smaps_rollup", "Rss:"); }
long address_space() { return kilobytes("status", "VmSize:"); }

bool are_given() {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string modes;
  std::getline(file, modes);
  return !modes.empty() && modes.find("[never]") == std::string::npos;
}

TEST(Heap, LargeVectorsLieInHugePagesAfterReserve) {
  if (kSanitized || !are_given() || huge_pages() < 0) GTEST_SKIP() << "the system gives no huge pages";
  keep_freed_memory();
  reserve_heap(1.5e9);
  const long before = huge_pages();
  const std::vector<char> touched(64 << 20, 'x');
  EXPECT_GE(huge_pages() - before, 32 << 10) << touched.front();
}

TEST(Heap, WhatIsReservedAlreadyIsNotReservedAgain) {
  keep_freed_memory();
  reserve_heap(1.5e9);
  const long before = address_space();
  const std::vector<char> touched(64 << 20, 'x');
  if (kSanitized) GTEST_SKIP() << "nothing is reserved under sanitizers";
  reserve_heap(1e9);
  EXPECT_EQ(address_space(), before);
  EXPECT_EQ(touched.back(), 'x');
}

TEST(Heap, GivesBackWhatIsFreedAndKeepsTheReserve) {
  if (kSanitized || !are_given() || huge_pages() < 0) GTEST_SKIP() << "the system gives no huge pages";
  keep_freed_memory();
  reserve_heap(1.5e9);
  { const std::vector<char> freed(256 << 20, 'x'); }
  const long before = resident();
  give_back_freed_memory();
  EXPECT_LE(resident(), before - (200 << 10));
  const long huge_before = huge_pages();
  const std::vector<char> touched(64 << 20, 'x');
  EXPECT_GE(huge_pages() - huge_before, 32 << 10) << touched.front();
}

TEST(Heap, ReserveTakesAnySize) {
  for (const double bytes : {0.0, -1.0, 1e6, 1e15}) reserve_heap(bytes);
  EXPECT_EQ(std::vector<int>(1000, 7).back(), 7);
}

}  // namespace
}  // namespace oxturn

#include "base/parallel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace oxturn {
namespace {

TEST(InParallel, EachPieceIsDoneOnce) {
  for (const int threads : {1, 2, 7, 40})
    for (const std::size_t n : {0, 1, 3, 1000}) {
      std::vector<int> done(n);
      in_parallel(threads, n, [&](std::size_t k) { ++done[k]; });
      EXPECT_EQ(done, std::vector<int>(n, 1)) << threads << " " << n;
    }
}

// Two pieces that wait for each other end only if they are done at the same time.
TEST(InParallel, ThreadsWorkAtTheSameTime) {
  std::atomic<int> begun = 0;
  in_parallel(2, 2, [&](std::size_t) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
  });
  EXPECT_EQ(begun, 2);
}

TEST(InParallel, TheFirstExceptionIsThrownWhenAllIsDone) {
  for (const int threads : {1, 3}) {
    std::atomic<int> done = 0;
    const auto work = [&](std::size_t k) {
      ++done;
      if (k % 4 == 2) throw std::runtime_error("piece " + std::to_string(k));
    };
    EXPECT_THAT([&] { in_parallel(threads, 20, work); },
                testing::ThrowsMessage<std::runtime_error>(testing::StrEq("piece 2")));
    EXPECT_EQ(done, 20);
  }
}

}  // namespace
}  // namespace oxturn

#include "base/disjoint_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/random.hpp"

namespace oxturn {
namespace {

TEST(DisjointSets, BeginAsSetsOfOneMember) {
  DisjointSets sets(3);
  EXPECT_EQ(sets.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
  EXPECT_FALSE(sets.same(0, 1));
  EXPECT_EQ(DisjointSets(0).size(), 0u);
}

TEST(DisjointSets, GrowByOneMember) {
  DisjointSets sets(2);
  sets.unite(0, 1);
  sets.add();
  EXPECT_EQ(sets.size(), 3u);
  EXPECT_EQ(sets.find(2), 2u);
  EXPECT_TRUE(sets.unite(2, 0));
  EXPECT_TRUE(sets.same(1, 2));
}

// Oracle: a label for each member; uniting relabels one set.
TEST(DisjointSets, AgreeWithRelabelling) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const std::size_t n = 1 + rng.below(40);
    DisjointSets sets(n);
    std::vector<std::size_t> label(n);
    std::iota(label.begin(), label.end(), std::size_t{0});
    for (int step = 0; step < 60; ++step) {
      const std::size_t i = rng.below(n), j = rng.below(n), from = label[i], to = label[j];
      ASSERT_EQ(sets.unite(i, j), from != to);
      std::replace(label.begin(), label.end(), from, to);
      for (std::size_t a = 0; a < n; ++a) {
        ASSERT_EQ(label[sets.find(a)], label[a]);  // the representative is a member
        for (std::size_t b = 0; b < n; ++b) ASSERT_EQ(sets.same(a, b), label[a] == label[b]);
      }
    }
  }
}

}  // namespace
}  // namespace oxturn

// Cells in one block of memory behave as a map of strings does.
#include "bench/row_cells.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace oxturn {
namespace {

TEST(RowCells, AreThoseOfAMap) {
  Rng rng(5);
  for (int round = 0; round < 50; ++round) {
    RowCells cells;
    std::map<std::string, std::string> expected;
    for (int step = 0; step < 200; ++step) {
      const std::string column = "c" + std::to_string(rng.below(30));
      if (rng.below(4) == 0) {
        cells.erase(column);
        expected.erase(column);
      } else {
        const std::string value(rng.below(40), static_cast<char>(rng.below(256)));
        cells.set(column, value);
        expected[column] = value;
      }
      ASSERT_EQ(cells.get(column), expected.count(column) ? expected[column] : "");
    }
    ASSERT_EQ(cells.all(), expected);
  }
}

TEST(RowCells, AColumnThatNobodyHasIsEmpty) {
  EXPECT_EQ(RowCells({{"a", "1"}}).get("never named"), "");
  EXPECT_EQ(RowCells().get("a"), "");
}

}  // namespace
}  // namespace oxturn

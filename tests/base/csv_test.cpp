#include "base/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Csv, ErrorsCountTheLinesInsideQuotedCells) {
  EXPECT_THAT([] { parse_csv("\"a\nb\n\"\nx\"y\n", "f.csv"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("f.csv:4:")));
}

TEST(Csv, WhatIsWrittenIsReadBack) {
  const std::string letters = "ab,\"\n\r x";
  Rng rng(1);
  for (int round = 0; round < 1000; ++round) {
    std::vector<std::vector<std::string>> lines(rng.below(4) + 1);
    std::string text;
    for (auto& cells : lines) {
      cells.resize(rng.below(4) + 1);
      for (std::string& cell : cells)
        for (std::uint64_t left = rng.below(5); left > 0; --left) cell += letters[rng.below(letters.size())];
      if (cells.size() == 1 && cells[0].empty()) cells[0] = "a";  // a line without cells looks the same
      text += csv_line(cells);
    }
    EXPECT_EQ(parse_csv(text, "t"), lines) << text;
  }
}

}  // namespace
}  // namespace oxturn

#include "base/text.hpp"

#include <gtest/gtest.h>

namespace oxturn {
namespace {

TEST(Text, WholeNumbersAreDigitsAlone) {
  EXPECT_EQ(parse_whole("7"), 7u);
  EXPECT_EQ(parse_whole("18446744073709551615"), ~std::uint64_t{0});
  for (const char* text : {"", "+7", "-7", "7.0", "7 ", "18446744073709551616"})
    EXPECT_EQ(parse_whole(text), std::nullopt) << text;
}

TEST(Text, NumbersAreFinite) {
  EXPECT_EQ(parse_number("+1e-3"), 1e-3);
  for (const char* text : {"inf", "nan", "1e999", "+-1", "1,5"}) EXPECT_EQ(parse_number(text), std::nullopt) << text;
}

TEST(Text, LowerCaseChangesAsciiLettersOnly) {
  EXPECT_EQ(lower_case("AZaz@[`{09"), "azaz@[`{09");
  EXPECT_EQ(lower_case("\xC3\x84"), "\xC3\x84");
}

TEST(Text, PrintableReplacesWhatIsNotUtf8) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(printable("a\tb\x7f"), "a b ");
  for (const char* valid :
       {"\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(printable(valid), valid);
  // Overlong forms of two, three and four bytes, a surrogate, a code point above U+10FFFF.
  EXPECT_EQ(printable("\xC0\x80"), bad + bad);
  EXPECT_EQ(printable("\xC1\xBF"), bad + bad);
  EXPECT_EQ(printable("\xE0\x9F\xBF"), bad + bad + bad);
  EXPECT_EQ(printable("\xF0\x8F\xBF\xBF"), bad + bad + bad + bad);
  EXPECT_EQ(printable("\xED\xA0\x80"), bad + bad + bad);
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), bad + bad + bad + bad);
  EXPECT_EQ(printable("\xE2\x82"), bad + bad);  // ends too early
}

TEST(Text, NearestNameHasTheLeastEditDistance) {
  const std::vector<std::string> planners{"boustrophedon", "zigzag", "stc", "rectangles"};
  EXPECT_EQ(nearest_name("boustrofedon", planners), "boustrophedon");
  EXPECT_EQ(nearest_name("sct", planners), "stc");
  EXPECT_EQ(nearest_name("zig-zag", planners), "zigzag");
  EXPECT_EQ(nearest_name("", {"only"}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
}

// A suggestion that is like no mistake anybody makes is worse than none.
TEST(Text, SuggestsOnlyWhatIsAlike) {
  const std::vector<std::string> planners{"boustrophedon", "zigzag", "stc"};
  EXPECT_EQ(nearest_name("nothing", planners), "");
  EXPECT_EQ(unknown_name("planner", "nothing", planners),
            "no planner 'nothing'; there are: boustrophedon, zigzag, stc");
  EXPECT_EQ(unknown_name("planner", "stk", planners),
            "no planner 'stk'; did you mean 'stc'? There are: boustrophedon, zigzag, stc");
}

TEST(Text, SwappedNeighboursAreOneMistake) {
  EXPECT_EQ(nearest_name("abdc", {"abxx", "abcd"}), "abcd");  // two substitutions, one transposition
}

}  // namespace
}  // namespace oxturn

// Numbers and escaping.
#include "reports/text.hpp"

#include <gtest/gtest.h>

#include "maps/picture.hpp"

namespace oxturn {
namespace {

TEST(Text, MedianOfOddEvenAndNone) {
  EXPECT_EQ(median({}), std::nullopt);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({9, 1, 5, 100}), 7);
}

TEST(Text, HtmlKeepsNothingThatCouldBeATag) {
  EXPECT_EQ(escape_xml("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
}

TEST(Text, MarkdownCellsStayOneCell) {
  EXPECT_EQ(escape_markdown("a|b\nc"), "a\\|b c");
  EXPECT_EQ(escape_markdown("<script>"), "&lt;script>");
  EXPECT_EQ(escape_markdown("zigzag[inset=1]"), "zigzag\\[inset=1\\]");
}

TEST(Text, LinksAreBytesOfAnUrl) { EXPECT_EQ(escape_url("gallery/a b(1).svg"), "gallery/a%20b%281%29.svg"); }

TEST(Text, EmptyIsEmptyNotZero) {
  EXPECT_EQ(fixed(std::nullopt, 3), "");
  EXPECT_EQ(fixed(1.23456, 3), "1.235");
}

TEST(Text, SecondsOfEverySize) {
  EXPECT_EQ(seconds(std::nullopt), "");
  EXPECT_EQ(seconds(0.00042), "0.0004");
  EXPECT_EQ(seconds(0.7), "0.700");
  EXPECT_EQ(seconds(61.25), "61.2");
}

TEST(Text, TablesHaveTheSameCellsInEveryLine) {
  const std::string table = markdown_table("lr", {"a", "b"}, {{"xxxxx", "1"}, {"y", "22"}});
  EXPECT_EQ(table,
            "| a     |   b |\n"
            "| ----- | --: |\n"
            "| xxxxx |   1 |\n"
            "| y     |  22 |\n");
}

}  // namespace
}  // namespace oxturn

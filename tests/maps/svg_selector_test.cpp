// Rules of style sheets: for which elements they are, and which of them wins.
#include "maps/drawings/svg_selector.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace oxturn::svg {
namespace {

constexpr const char* kDocument = R"(<svg><g id="layer" class="a b" inkscape:label="Pens one">
  <!-- --><path class="st0  cls-1" fill="none"/><g><rect id="r" class="st0" stroke="#ff0000"/></g>
  <circle lang="en-GB"/></g><path id="top"/></svg>)";

class SvgSelector : public ::testing::Test {
 protected:
  SvgSelector() { xml_.load_string(kDocument); }
  pugi::xml_node svg() const { return xml_.child("svg"); }
  pugi::xml_node layer() const { return svg().child("g"); }
  pugi::xml_node rect() const { return layer().child("g").child("rect"); }
  static std::optional<bool> matches(const pugi::xml_node& node, const char* text) {
    const auto selector = parse_selector(text);
    std::size_t effort = 0;
    return selector ? std::optional(selector->matches(node, effort)) : std::nullopt;
  }
  pugi::xml_document xml_;
};

TEST_F(SvgSelector, CompoundsNameAllThatAnElementMustBe) {
  const pugi::xml_node path = layer().child("path");
  for (const char* text : {"path", "*", ".st0", ".cls-1.st0", "path.st0", "*.st0", "[fill]", "path[fill=\"none\"]",
                           "[fill=none]", "[class~=cls-1]", ".cls\\-1", ":first-child"})
    EXPECT_EQ(matches(path, text), true) << text;
  for (const char* text : {"rect", ".st", ".st0.b", "#top", "[stroke]", "[fill=non]", "[class~=cls]", ":root"})
    EXPECT_EQ(matches(path, text), false) << text;
  EXPECT_EQ(matches(layer(), "g#layer.a.b"), true);
  EXPECT_EQ(matches(svg(), ":root"), true);
  EXPECT_EQ(matches(rect(), "[stroke^='#ff']"), true);
  EXPECT_EQ(matches(rect(), "[stroke$=ff]"), false);
  EXPECT_EQ(matches(layer(), "[inkscape:label*=one]"), true);
  EXPECT_EQ(matches(layer().child("circle"), "[lang|=en]"), true);
}

TEST_F(SvgSelector, CombinatorsLookUpwardsAndBackwards) {
  for (const char* text : {"g rect", "svg rect", "g g rect", "svg > g > g > rect", "#layer .st0", ".a   rect", "g>rect",
                           "path + g > rect", "svg * rect", ".a\n>\tg rect", "path ~ g rect"})
    EXPECT_EQ(matches(rect(), text), true) << text;
  for (const char* text :
       {"svg > rect", "#layer > rect", "rect rect", "circle + g rect", "g g g rect", "circle ~ g rect"})
    EXPECT_EQ(matches(rect(), text), false) << text;
  // A near ancestor that does not fit, with one above that does.
  EXPECT_EQ(matches(rect(), "svg > g rect"), true);
  EXPECT_EQ(matches(svg().child("path"), "g path"), false);
  EXPECT_EQ(matches(svg().child("path"), "g + path"), true);
}

TEST_F(SvgSelector, WhatIsNotSupportedIsNoSelector) {
  for (const char* text : {"", " ", "a:hover", "a >", "> a", "a > > b", "a..b", "[", "[=x]", "a|b", "a/b", "a::before"})
    EXPECT_FALSE(parse_selector(text)) << text;
}

TEST_F(SvgSelector, SpecificityCountsIdsThenClassesThenTypes) {
  const auto of = [](const char* text) { return parse_selector(text)->specificity(); };
  EXPECT_EQ(of("*"), 0);
  EXPECT_LT(of("svg g path"), of(".a"));
  EXPECT_EQ(of(".a"), of("[fill]"));
  EXPECT_LT(of(".a"), of("g .a"));
  EXPECT_LT(of(".a.b.c g path"), of("#a"));
  EXPECT_EQ(parse_selector("g > path.a.b")->key(), ".a");
}

TEST_F(SvgSelector, TimeIsBounded) {
  std::string text, open, close;
  for (int k = 0; k < 29; ++k) text += "g ";
  for (int k = 0; k < 200; ++k) open += "<g>", close += "</g>";
  ASSERT_TRUE(xml_.load_string((open + "<path/>" + close).c_str()));
  pugi::xml_node at = xml_.first_child();
  while (at.first_child()) at = at.first_child();
  std::size_t effort = 0;
  EXPECT_FALSE(parse_selector("z " + text + "path")->matches(at, effort));
  EXPECT_LE(effort, 10'001u);
}

}  // namespace
}  // namespace oxturn::svg

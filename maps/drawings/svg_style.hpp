/// The style of SVG elements: presentation attributes, rules of style sheets, the style attribute. Private to maps.
///
///   StyleSheet sheet;
///   sheet.add(".st0 { stroke: #ff0000 }", line, remark);
///   const Style style = sheet.style_of(node, parent, viewport, remark);
///
/// Source: CSS 2.1, section 6 (cascade); SVG 1.1, section 6.
#pragma once

#include <functional>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "geometry/overlay/fill_rule.hpp"
#include "maps/drawings/svg_selector.hpp"
#include "maps/drawings/svg_values.hpp"

namespace oxturn::svg {

struct Style {
  Paint fill = Paint::other, stroke = Paint::none, color = Paint::other;
  double stroke_width = 1;  // user units
  FillRule rule = FillRule::nonzero;
  bool visible = true;                          // visibility
  double fill_opacity = 1, stroke_opacity = 1;  // not below 0
  bool shown = true;                            // false: display none, or a group's opacity 0; not inherited
};

/// Called for what is not supported.
using Remark = std::function<void(const std::string& sentence)>;

class StyleSheet {
 public:
  /// Adds the rules of a style sheet; `remark` hears of selectors and at-rules that are not supported. Throws
  /// std::length_error for more than 1000 rules in all.
  void add(std::string_view css, const Remark& remark);
  /// The computed style of an element. `diagonal` is what percentages of a stroke's width refer to, user units. Throws
  /// std::length_error if styles set more than 20 million properties in all.
  Style style_of(const pugi::xml_node& node, const Style& parent, double diagonal, const Remark& remark) const;

 private:
  struct Declaration {
    std::string name, value;
    bool important = false;
  };
  using Declarations = std::vector<Declaration>;
  struct Rule {
    Selector selector;
    std::size_t order = 0;
    std::size_t declarations = 0;  // index
  };
  static Declarations parse_declarations(std::string_view text, const Remark& remark);
  void add_selector(std::string_view text, std::size_t declarations, const Remark& remark);
  std::vector<const Rule*> rules_for(const pugi::xml_node& node) const;

  std::vector<Declarations> declarations_;
  std::multimap<std::string, Rule> rules_;  // by "#id", ".class", type, or "*"
  std::size_t count_ = 0;
  mutable std::size_t matched_ = 0;  // effort so far of selectors, and
  mutable std::size_t applied_ = 0;  // declarations: bounds the time that hostile style sheets take
};

/// The name without its namespace's prefix; empty if the prefix is that of another namespace than SVG.
std::string_view local_name(const pugi::xml_node& node);

}  // namespace oxturn::svg

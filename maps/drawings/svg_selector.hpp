/// Selectors of style sheets in SVG: which elements a rule is for. Private to maps.
///
///   const std::optional<Selector> selector = parse_selector("#layer > g.st0 path");
///   if (selector && selector->matches(node, effort)) ...
///
/// Types, `*`, classes, ids, attributes ([fill], [fill="none"], ~= |= ^= $= *=), :root and :first-child, combined by
/// descendant (blank), child (>), next sibling (+) and later sibling (~).
/// Source: CSS 2.1, section 5; Selectors Level 3. Others, as :hover, are nullopt.
/// Complexity  matches(): parts of the selector times the element's ancestors and siblings; 10,000 at most, then false
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace oxturn::svg {

class Selector {
 public:
  /// Adds to `effort` the elements that it looked at.
  bool matches(const pugi::xml_node& node, std::size_t& effort) const;
  /// 1,000,000 for each id, 1000 for each class, attribute or pseudo-class, 1 for each type.
  int specificity() const { return specificity_; }
  /// What an element must have for the selector to match it: "#id", ".class", its type, or "*".
  std::string key() const;

 private:
  friend std::optional<Selector> parse_selector(std::string_view text);
  struct Attribute {
    std::string name, value;
    char how = 0;  // 0: is there; '=': is equal; else the character before =
  };
  /// What one element must be; empty: any.
  struct Compound {
    std::string type;
    std::vector<std::string> ids, classes;
    std::vector<Attribute> attributes;
    bool root = false, first_child = false;
    char combinator = 0;  // to the compound before it; 0: there is none
  };
  static bool parse_compound(std::string_view& rest, Compound& compound, int& specificity);
  static bool parse_attribute(std::string_view& rest, Attribute& attribute);
  static bool is(const pugi::xml_node& node, const Compound& compound);
  static bool has(const pugi::xml_node& node, const Attribute& attribute);
  bool matches(const pugi::xml_node& node, std::size_t compound, std::size_t& steps) const;

  std::vector<Compound> compounds_;  // from left to right
  int specificity_ = 0;
};

/// Without lists: split at commas first. Nullopt: empty, or not supported.
std::optional<Selector> parse_selector(std::string_view text);

}  // namespace oxturn::svg

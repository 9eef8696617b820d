#include "maps/drawings/svg_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/text.hpp"

namespace oxturn::svg {
namespace {

constexpr std::size_t kMostRules = 1000;
constexpr std::size_t kMostMatched = 50'000'000;  // elements that selectors look at
constexpr std::size_t kMostApplied = 20'000'000;  // declarations, over all elements

/// A property that oxturn obeys. `set` returns false for a value that it does not understand.
struct Setting {
  Style& style;
  const Style& parent;
  double diagonal;
  std::string_view value;
  bool& server;  // a paint is url(...)
};
using Setter = bool (*)(Setting&);

bool set_paint(Setting& s, Paint Style::*member) {
  const auto paint = parse_paint(s.value, s.server);
  if (paint) s.style.*member = *paint;
  return paint.has_value();
}
bool set_opacity(Setting& s, double Style::*member) {
  const auto value = parse_length(s.value, 1);
  if (value) s.style.*member = std::max(0.0, *value);
  return value.has_value();
}
bool set_width(Setting& s) {
  const auto value = parse_length(s.value, s.diagonal);
  if (value && *value >= 0) s.style.stroke_width = *value;
  return value && *value >= 0;
}
bool set_rule(Setting& s) {
  if (s.value != "nonzero" && s.value != "evenodd") return false;
  s.style.rule = s.value == "nonzero" ? FillRule::nonzero : FillRule::evenodd;
  return true;
}
bool set_display(Setting& s) {
  s.style.shown = s.value != "none";
  return true;
}
bool set_visibility(Setting& s) {
  s.style.visible = s.value == "visible";
  return s.style.visible || s.value == "hidden" || s.value == "collapse";
}
bool set_group_opacity(Setting& s) {
  const auto value = parse_length(s.value, 1);
  if (value && *value <= 0) s.style.shown = false;
  return value.has_value();
}

struct Property {
  Setter set;
  void (*inherit)(Style& style, const Style& parent);
};
const std::map<std::string_view, Property>& properties() {
  static const std::map<std::string_view, Property> kAll{
      {"fill",
       {[](Setting& s) { return set_paint(s, &Style::fill); }, [](Style& s, const Style& p) { s.fill = p.fill; }}},
      {"stroke",
       {[](Setting& s) { return set_paint(s, &Style::stroke); },
        [](Style& s, const Style& p) { s.stroke = p.stroke; }}},
      {"color",
       {[](Setting& s) { return set_paint(s, &Style::color); }, [](Style& s, const Style& p) { s.color = p.color; }}},
      {"stroke-width", {set_width, [](Style& s, const Style& p) { s.stroke_width = p.stroke_width; }}},
      {"fill-rule", {set_rule, [](Style& s, const Style& p) { s.rule = p.rule; }}},
      {"visibility", {set_visibility, [](Style& s, const Style& p) { s.visible = p.visible; }}},
      {"fill-opacity",
       {[](Setting& s) { return set_opacity(s, &Style::fill_opacity); },
        [](Style& s, const Style& p) { s.fill_opacity = p.fill_opacity; }}},
      {"stroke-opacity",
       {[](Setting& s) { return set_opacity(s, &Style::stroke_opacity); },
        [](Style& s, const Style& p) { s.stroke_opacity = p.stroke_opacity; }}},
      {"display", {set_display, [](Style&, const Style&) {}}},
      {"opacity", {set_group_opacity, [](Style&, const Style&) {}}}};
  return kAll;
}

/// Properties that change what is drawn and are not supported, with the value at which they do nothing.
const std::map<std::string_view, std::string_view>& unsupported() {
  static const std::map<std::string_view, std::string_view> kAll{
      {"stroke-dasharray", "none"}, {"clip-path", "none"},  {"mask", "none"},         {"filter", "none"},
      {"marker", "none"},           {"marker-mid", "none"}, {"marker-start", "none"}, {"marker-end", "none"},
      {"vector-effect", "none"},    {"clip", "auto"}};
  return kAll;
}

/// Attributes that a style may set too, which is not obeyed. The size of an svg element does not matter: the drawing is
/// fitted to the canvas.
void remark_on_geometry(std::string_view element, std::string_view property, std::string_view value,
                        const Remark& remark) {
  static const std::set<std::string_view> kAll{
      "transform", "transform-origin", "translate", "rotate", "scale", "d",  "x", "y",
      "width",     "height",           "cx",        "cy",     "r",     "rx", "ry"};
  const bool size = property == "width" || property == "height";
  if (!kAll.contains(property) || (size && element != "rect")) return;
  if (value == "none" || value == "auto" || value == "0 0" || value == "0px 0px") return;
  remark(fmt::format("{} in a style is not supported: it is drawn without", property));
}

std::vector<std::string_view> split(std::string_view text, char by) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(by);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string without_comments(std::string_view css) {
  std::string out;
  for (std::size_t at = 0; at < css.size();) {
    const std::size_t begin = css.find("/*", at);
    out += css.substr(at, begin == css.npos ? begin : begin - at);
    if (begin == css.npos) break;
    const std::size_t end = css.find("*/", begin + 2);
    at = end == css.npos ? css.size() : end + 2;
    out += ' ';
  }
  for (const std::string_view mark : {"<!--", "-->"})  // allowed around a whole style sheet
    for (std::size_t at = 0; (at = out.find(mark, at)) != out.npos;) out.replace(at, mark.size(), mark.size(), ' ');
  return out;
}

/// The position after a block that begins with the { at `open`.
std::size_t block_end(std::string_view css, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < css.size(); ++at)
    if (css[at] == '{')
      ++depth;
    else if (css[at] == '}' && --depth == 0)
      return at + 1;
  return css.size();
}

std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 80;
  return printable(text.substr(0, kMost)) + (text.size() > kMost ? "..." : "");
}

/// Sets one property, if its value is understood.
void apply(Style& style, const Style& parent, double diagonal, std::string_view name, std::string_view value,
           const Remark& remark) {
  value = trimmed(value);
  if (const auto other = unsupported().find(name); other != unsupported().end()) {
    if (value != other->second && !value.empty()) remark(fmt::format("{} is not supported: it is drawn without", name));
    return;
  }
  const auto property = properties().find(name);
  if (property == properties().end()) return;
  if (value == "inherit") return property->second.inherit(style, parent);
  bool server = false;
  Setting setting{style, parent, diagonal, value, server};
  if (!property->second.set(setting)) remark(fmt::format("{} '{}' is not understood and ignored", name, shown(value)));
  if (server) remark(fmt::format("{} '{}' is not supported: it is drawn plainly", name, shown(value)));
}

}  // namespace

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  if (colon == name.npos) return name;
  const std::string_view prefix = name.substr(0, colon), local = name.substr(colon + 1);
  const std::string declaration = "xmlns:" + std::string(prefix);
  for (pugi::xml_node above = node; above; above = above.parent())
    if (const pugi::xml_attribute space = above.attribute(declaration.c_str()); space)
      return std::string_view(space.value()) == "http://www.w3.org/2000/svg" ? local : std::string_view();
  return prefix == "svg" ? local : std::string_view();
}

StyleSheet::Declarations StyleSheet::parse_declarations(std::string_view text, const Remark& remark) {
  constexpr std::string_view kImportant = "important";
  Declarations all;
  for (const std::string_view part : split(text, ';')) {
    const std::size_t colon = part.find(':');
    if (colon == part.npos) {
      if (!part.empty()) remark(fmt::format("'{}' in a style is not understood and ignored", shown(part)));
      continue;
    }
    std::string_view value = trimmed(part.substr(colon + 1));
    bool important = false;
    if (const std::size_t mark = value.rfind('!');
        mark != value.npos && lower_case(trimmed(value.substr(mark + 1))) == kImportant) {
      important = true;
      value = trimmed(value.substr(0, mark));
    }
    all.push_back({lower_case(trimmed(part.substr(0, colon))), std::string(value), important});
  }
  return all;
}

void StyleSheet::add(std::string_view text, const Remark& remark) {
  const std::string clean = without_comments(text);
  std::string_view css = clean;
  while (!(css = trimmed(css)).empty()) {
    if (css.front() == '@') {
      const std::size_t end = std::min(css.find_first_of("{;"), css.size() - 1);
      remark(fmt::format("the rule '{}' of a style sheet is not supported and ignored", shown(css.substr(0, end))));
      css.remove_prefix(css[end] == '{' ? block_end(css, end) : end + 1);
      continue;
    }
    const std::size_t open = css.find('{');
    if (open == css.npos) return remark(fmt::format("'{}' in a style sheet is not understood and ignored", shown(css)));
    const std::size_t end = block_end(css, open);
    declarations_.push_back(parse_declarations(css.substr(open + 1, end - open - 2), remark));
    for (const std::string_view selector : split(css.substr(0, open), ','))
      add_selector(selector, declarations_.size() - 1, remark);
    css.remove_prefix(end);
  }
}

void StyleSheet::add_selector(std::string_view text, std::size_t declarations, const Remark& remark) {
  if (++count_ > kMostRules) throw std::length_error("style sheets have more than 1000 rules");
  std::optional<Selector> selector = parse_selector(text);
  if (!selector)
    return remark(fmt::format("the selector '{}' of a style sheet is not supported and ignored", shown(text)));
  const std::string key = selector->key();
  rules_.emplace(key, Rule{std::move(*selector), count_, declarations});
}

std::vector<const StyleSheet::Rule*> StyleSheet::rules_for(const pugi::xml_node& node) const {
  std::vector<const Rule*> found;
  if (rules_.empty()) return found;
  std::set<std::string> keys{"*", std::string(local_name(node)), std::string("#") + node.attribute("id").value()};
  for (std::string_view rest = trimmed(node.attribute("class").value()); !rest.empty();) {
    const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    keys.insert("." + std::string(rest.substr(0, end)));
    rest = trimmed(rest.substr(end));
  }
  for (const std::string& key : keys) {
    const auto [first, last] = rules_.equal_range(key);
    for (auto at = first; at != last; ++at) {
      if (at->second.selector.matches(node, matched_)) found.push_back(&at->second);
      if (matched_ > kMostMatched) throw std::length_error("style sheets have too many rules for so many elements");
    }
  }
  std::ranges::sort(found, {}, [](const Rule* rule) { return std::pair(rule->selector.specificity(), rule->order); });
  return found;
}

Style StyleSheet::style_of(const pugi::xml_node& node, const Style& parent, double diagonal,
                           const Remark& remark) const {
  Style style = parent;
  style.shown = true;
  const auto set = [&](std::string_view name, std::string_view value) {
    if (++applied_ > kMostApplied) throw std::length_error("styles set more than 20 million properties");
    apply(style, parent, diagonal, name, value, remark);
  };
  for (const pugi::xml_attribute& attribute : node.attributes())
    if (properties().contains(attribute.name()) || unsupported().contains(attribute.name()))
      set(attribute.name(), attribute.value());
  const std::vector<const Rule*> rules = rules_for(node);
  const Declarations own = parse_declarations(node.attribute("style").value(), remark);
  const auto set_all = [&](const Declarations& all, bool important) {
    for (const Declaration& d : all) {
      if (d.important != important) continue;
      set(d.name, d.value);
      remark_on_geometry(local_name(node), d.name, d.value, remark);
    }
  };
  for (const bool important : {false, true}) {
    for (const Rule* rule : rules) set_all(declarations_[rule->declarations], important);
    set_all(own, important);
  }
  return style;
}

}  // namespace oxturn::svg

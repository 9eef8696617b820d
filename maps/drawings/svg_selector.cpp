#include "maps/drawings/svg_selector.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "maps/drawings/svg_style.hpp"

namespace oxturn::svg {
namespace {

constexpr std::size_t kMostCompounds = 32;
constexpr std::size_t kMostSteps = 10'000;  // of one match: `* * * ...` in deep documents would take exponential time
constexpr std::string_view kBlanks = " \t\r\n";

bool is_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

/// A name, with \ before a character that has no special meaning then.
std::string name(std::string_view& rest) {
  std::string found;
  while (!rest.empty()) {
    const char c = rest.front();
    const auto byte = static_cast<unsigned char>(c);
    const bool escaped = c == '\\' && rest.size() > 1;
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                       c == '_' || byte >= 0x80;
    if (!escaped && !plain) break;
    found += escaped ? rest[1] : c;
    rest.remove_prefix(escaped ? 2 : 1);
  }
  return found;
}

bool has_word(std::string_view words, std::string_view word) {
  if (word.empty()) return false;
  for (std::size_t at = 0; (at = words.find(word, at)) != words.npos; ++at) {
    const std::size_t end = at + word.size();
    if ((at == 0 || is_blank(words[at - 1])) && (end == words.size() || is_blank(words[end]))) return true;
  }
  return false;
}

pugi::xml_node element_before(const pugi::xml_node& node) {
  pugi::xml_node before = node.previous_sibling();
  while (before && before.type() != pugi::node_element) before = before.previous_sibling();
  return before;
}

pugi::xml_node element_above(const pugi::xml_node& node) {
  const pugi::xml_node above = node.parent();
  return above.type() == pugi::node_element ? above : pugi::xml_node();
}

}  // namespace

bool Selector::parse_attribute(std::string_view& rest, Attribute& attribute) {
  const std::size_t end = rest.find(']');
  if (end == rest.npos) return false;
  std::string_view text = trimmed(rest.substr(0, end));
  rest.remove_prefix(end + 1);
  attribute.name = name(text);
  if (!text.empty() && text.front() == ':') {  // as in xlink:href, which sheets escape
    text.remove_prefix(1);
    attribute.name += ":" + name(text);
  }
  text = trimmed(text);
  if (attribute.name.empty() || text.empty()) return !attribute.name.empty();
  attribute.how = text.front();
  text.remove_prefix(1);
  if (attribute.how != '=') {
    if (std::string_view("~|^$*").find(attribute.how) == std::string_view::npos || !text.starts_with('=')) return false;
    text.remove_prefix(1);
  }
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front())
    text = text.substr(1, text.size() - 2);
  attribute.value = std::string(text);
  return true;
}

bool Selector::parse_compound(std::string_view& rest, Compound& compound, int& specificity) {
  const std::size_t before = rest.size();
  if (rest.starts_with('*')) {
    rest.remove_prefix(1);
  } else if (compound.type = name(rest); !compound.type.empty()) {
    specificity += 1;
  }
  while (!rest.empty() && !is_blank(rest.front()) &&
         std::string_view(">+~").find(rest.front()) == std::string_view::npos) {
    const char mark = rest.front();
    rest.remove_prefix(1);
    specificity += mark == '#' ? 1'000'000 : 1000;
    if (mark == '[') {
      if (!parse_attribute(rest, compound.attributes.emplace_back())) return false;
      continue;
    }
    std::string word = name(rest);
    if (word.empty()) return false;
    if (mark == ':') {
      if (word != "root" && word != "first-child") return false;
      (word == "root" ? compound.root : compound.first_child) = true;
    } else if (mark == '.' || mark == '#') {
      (mark == '.' ? compound.classes : compound.ids).push_back(std::move(word));
    } else {
      return false;
    }
  }
  return rest.size() < before;
}

std::optional<Selector> parse_selector(std::string_view text) {
  Selector selector;
  std::string_view rest = trimmed(text);
  char combinator = 0;
  while (selector.compounds_.size() < kMostCompounds) {
    Selector::Compound& compound = selector.compounds_.emplace_back();
    compound.combinator = combinator;
    if (!Selector::parse_compound(rest, compound, selector.specificity_)) return std::nullopt;
    if (rest.empty()) return selector;
    rest = trimmed(rest);
    combinator = ' ';
    if (std::string_view(">+~").find(rest.front()) != std::string_view::npos) {
      combinator = rest.front();
      rest = trimmed(rest.substr(1));
    }
  }
  return std::nullopt;
}

std::string Selector::key() const {
  const Compound& last = compounds_.back();
  if (!last.ids.empty()) return "#" + last.ids.front();
  if (!last.classes.empty()) return "." + last.classes.front();
  return last.type.empty() ? "*" : last.type;
}

bool Selector::has(const pugi::xml_node& node, const Attribute& attribute) {
  const pugi::xml_attribute found = node.attribute(attribute.name.c_str());
  const std::string_view value = found.value(), wanted = attribute.value;
  if (!found || attribute.how == 0) return !found.empty();
  if (attribute.how == '=') return value == wanted;
  if (attribute.how == '~') return has_word(value, wanted);
  if (attribute.how == '|') return value == wanted || value.starts_with(attribute.value + "-");
  if (wanted.empty()) return false;
  if (attribute.how == '^') return value.starts_with(wanted);
  return attribute.how == '$' ? value.ends_with(wanted) : value.find(wanted) != value.npos;
}

bool Selector::is(const pugi::xml_node& node, const Compound& compound) {
  if (!compound.type.empty() && compound.type != local_name(node)) return false;
  if (compound.root && element_above(node)) return false;
  if (compound.first_child && element_before(node)) return false;
  const std::string_view classes = node.attribute("class").value(), id = node.attribute("id").value();
  return std::ranges::all_of(compound.ids, [&](const std::string& wanted) { return id == wanted; }) &&
         std::ranges::all_of(compound.classes, [&](const std::string& wanted) { return has_word(classes, wanted); }) &&
         std::ranges::all_of(compound.attributes, [&](const Attribute& a) { return has(node, a); });
}

/// Whether the compounds up to this one match, this one the node.
bool Selector::matches(const pugi::xml_node& node, std::size_t compound, std::size_t& steps) const {
  if (!is(node, compounds_[compound])) return false;
  if (compound == 0) return true;
  const char how = compounds_[compound].combinator;
  const bool above = how == ' ' || how == '>';
  const auto next = [&](const pugi::xml_node& from) { return above ? element_above(from) : element_before(from); };
  for (pugi::xml_node at = next(node); at && steps > 0; at = next(at)) {
    --steps;
    if (matches(at, compound - 1, steps)) return true;
    if (how == '>' || how == '+') break;
  }
  return false;
}

bool Selector::matches(const pugi::xml_node& node, std::size_t& effort) const {
  std::size_t steps = kMostSteps;
  const bool found = matches(node, compounds_.size() - 1, steps);
  effort += 1 + kMostSteps - steps;
  return found;
}

}  // namespace oxturn::svg

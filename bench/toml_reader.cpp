#include "bench/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/files.hpp"
#include "base/text.hpp"

namespace oxturn {

namespace {

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("the text \"{}\"", text->get());
  if (const auto* number = node.as_integer()) return std::to_string(number->get());
  if (const auto* number = node.as_floating_point()) return to_decimal(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_array()) return "a list";
  if (node.is_table()) return "a table";
  return "a date or time";
}

std::string join(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

std::string bounds(Range range) {
  if (std::isfinite(range.least) && std::isfinite(range.most)) {
    return fmt::format("from {} to {}", to_decimal(range.least), to_decimal(range.most));
  }
  return fmt::format("of at least {}", to_decimal(range.least));
}

}  // namespace

std::string position_of(const std::string& file, const toml::node& node) {
  return fmt::format("{}:{}", file, static_cast<unsigned>(node.source().begin.line));
}

void refuse(const std::string& file, const toml::node& node, const std::string& sentence) {
  throw std::invalid_argument(fmt::format("{}: {}", position_of(file, node), sentence));
}

void at_position(const std::string& file, const toml::node& node, const std::function<void()>& check) {
  try {
    check();
  } catch (const std::invalid_argument& e) { refuse(file, node, e.what()); }
}

toml::table parse_toml(const std::string& file) {
  const std::string text = read_file(file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& e) {
    throw std::invalid_argument(
        fmt::format("{}:{}: bad TOML: {}", file, static_cast<unsigned>(e.source().begin.line), e.description()));
  }
}

TomlTable::TomlTable(std::string file, const toml::table& table, std::string what)
    : file_(std::move(file)), table_(table), what_(std::move(what)) {}

const toml::node* TomlTable::find(const std::string& key) {
  asked_.push_back(key);
  return table_.get(key);
}

const toml::node& TomlTable::need(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) refuse(file_, table_, fmt::format("{} has no '{}'", what_, key));
  return *node;
}

double TomlTable::number(const std::string& key, double fallback, Range range) {
  const toml::node* node = find(key);
  if (node == nullptr) return fallback;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !(*value >= range.least && *value <= range.most)) {
    refuse(file_, *node, fmt::format("{} is {}, expected a number {}", key, describe(*node), bounds(range)));
  }
  return *value;
}

std::int64_t TomlTable::whole(const std::string& key, std::int64_t fallback, Range range) {
  const toml::node* node = find(key);
  if (node == nullptr) return fallback;
  const auto* value = node->as_integer();
  if (value == nullptr || static_cast<double>(value->get()) < range.least ||
      static_cast<double>(value->get()) > range.most) {
    refuse(file_, *node, fmt::format("{} is {}, expected a whole number {}", key, describe(*node), bounds(range)));
  }
  return value->get();
}

bool TomlTable::flag(const std::string& key, bool fallback) {
  const toml::node* node = find(key);
  if (node == nullptr) return fallback;
  if (!node->is_boolean()) refuse(file_, *node, fmt::format("{} is {}, expected true or false", key, describe(*node)));
  return node->as_boolean()->get();
}

std::string TomlTable::text(const std::string& key) {
  const toml::node& node = need(key);
  const auto* value = node.as_string();
  if (value == nullptr || value->get().empty()) {
    refuse(file_, node, fmt::format("{} is {}, expected a text in quotes", key, describe(node)));
  }
  return value->get();
}

std::vector<std::pair<std::string, const toml::node*>> TomlTable::rest() const {
  std::vector<std::pair<std::string, const toml::node*>> all;
  for (const auto& [key, node] : table_) {
    const std::string name(key.str());
    if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) all.emplace_back(name, &node);
  }
  // toml++ sorts by name; the file's order is what the user wrote.
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    const auto x = a.second->source().begin, y = b.second->source().begin;
    return x.line != y.line ? x.line < y.line : x.column < y.column;
  });
  return all;
}

void TomlTable::end() const {
  const auto left = rest();
  if (left.empty()) return;
  refuse(file_, *left[0].second,
         fmt::format("unknown key '{}' in {}; expected: {}", left[0].first, what_, join(asked_)));
}

Value value_of(const std::string& file, const toml::node& node, const std::string& key) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_integer()) return std::int64_t{number->get()};
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* flag = node.as_boolean()) return flag->get();
  refuse(file, node, fmt::format("{} is {}, expected a number, true, false or a text", key, describe(node)));
}

std::vector<const toml::node*> alternatives(const std::string& file, const toml::node& node, const std::string& key) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return {&node};
  if (list->empty()) refuse(file, node, fmt::format("{} is an empty list, expected at least one value", key));
  std::vector<const toml::node*> all;
  for (const toml::node& item : *list) all.push_back(&item);
  return all;
}

}  // namespace oxturn

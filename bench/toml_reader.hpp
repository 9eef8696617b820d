/// TOML with error messages that name file, line, key and what was expected. Internal to bench/.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/parameters.hpp"

namespace oxturn {

/// File and line of a node: "quick.toml:12".
std::string position_of(const std::string& file, const toml::node& node);

/// Throws std::invalid_argument "quick.toml:12: SENTENCE".
[[noreturn]] void refuse(const std::string& file, const toml::node& node, const std::string& sentence);

/// Runs `check` and puts the node's file and line in front of the message that it throws.
void at_position(const std::string& file, const toml::node& node, const std::function<void()>& check);

toml::table parse_toml(const std::string& file);

/// A table whose keys are taken one by one; keys not taken are unknown. Keeps the file's order.
class TomlTable {
 public:
  TomlTable(std::string file, const toml::table& table, std::string what);

  /// nullptr if the key is missing.
  const toml::node* find(const std::string& key);
  const toml::node& need(const std::string& key);
  double number(const std::string& key, double fallback, Range range);
  std::int64_t whole(const std::string& key, std::int64_t fallback, Range range);
  bool flag(const std::string& key, bool fallback);
  std::string text(const std::string& key);  // must be there
  /// Keys not taken so far, in file order.
  std::vector<std::pair<std::string, const toml::node*>> rest() const;
  /// Throws for the first of `rest()`: "unknown key 'planers'; expected: ...".
  void end() const;
  const toml::table& node() const { return table_; }
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  const toml::table& table_;
  std::string what_;
  std::vector<std::string> asked_;
};

/// A plain value; throws for tables, lists and dates.
Value value_of(const std::string& file, const toml::node& node, const std::string& key);
/// The values of a list, or the one value. Throws for an empty list.
std::vector<const toml::node*> alternatives(const std::string& file, const toml::node& node, const std::string& key);

}  // namespace oxturn

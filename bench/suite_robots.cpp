// [robots.NAME]: the parameters of a robot, those of a group in a table of the group's name.
#include <fmt/format.h>

#include <algorithm>

#include "bench/suite_parts.hpp"

namespace oxturn {
namespace {

/// tether = { length = 40 } becomes tether_length = 40.
std::vector<Choice> robot_keys(const std::string& file, const TomlTable& table) {
  std::vector<Choice> keys;
  for (const auto& [key, node] : table.rest()) {
    const toml::table* inner = node->as_table();
    const bool group = std::count(robot_groups().begin(), robot_groups().end(), key) > 0;
    if (!group || inner == nullptr) {
      keys.emplace_back(key, node);
      continue;
    }
    const TomlTable nested(file, *inner, key);
    if (nested.rest().empty()) refuse(file, *node, fmt::format("{} is an empty table", key));
    for (const auto& [part, value] : nested.rest()) keys.emplace_back(key + "_" + part, value);
  }
  return keys;
}

Robot robot_of(const std::string& file, const std::string& name, const std::vector<Choice>& chosen,
               const toml::node& table) {
  Robot robot;
  robot.name = name;
  const std::vector<ParameterInfo> parameters = infos_of(robot_parameters());
  const Settings settings = settings_of(file, fmt::format("robot '{}'", name), parameters, chosen, Defaults::keep);
  at_position(file, table, [&] {
    change(robot, settings);
    check(robot);
  });
  return robot;
}

}  // namespace

std::vector<Robot> read_robots(const std::string& file, const toml::node* node, const toml::table& root) {
  const char* const none = "no [robots.NAME] table; a suite needs at least one robot";
  if (node == nullptr) refuse(file, root, none);
  if (!node->is_table()) refuse(file, *node, none);
  std::vector<Robot> robots;
  const TomlTable named(file, *node->as_table(), "robots");
  if (named.rest().empty()) refuse(file, *node, none);
  for (const auto& [name, body] : named.rest()) {
    if (!body->is_table()) refuse(file, *body, fmt::format("robots.{} is no table; write [robots.{}]", name, name));
    const TomlTable table(file, *body->as_table(), fmt::format("robot '{}'", name));
    const auto keys = robot_keys(file, table);
    for (const auto& chosen : product(file, keys)) {
      Settings varied;  // goes into the name
      for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].second != chosen[i].second)
          varied[keys[i].first] = setting_of(file, *chosen[i].second, keys[i].first);
      const std::string full = varied.empty() ? name : fmt::format("{}[{}]", name, to_text(varied));
      robots.push_back(robot_of(file, full, chosen, *body));
    }
  }
  return robots;
}

}  // namespace oxturn

#include "maps/formats/robot_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

Value value_of(const JsonAt& at) {
  if (at.value.is_boolean()) return at.value.get<bool>();
  if (at.value.is_number_integer()) return at.value.get<std::int64_t>();
  if (at.value.is_number()) return at.number();
  if (at.value.is_string()) return at.text();
  if (!at.value.is_array()) at.refuse("a number, a string, true, false or a list of points");
  std::string text;
  for (const Point& p : at.points(at.where))
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", to_decimal(p.x()), to_decimal(p.y()));
  return text;
}

/// Members of robot groups become settings of one level.
Settings robot_settings(const JsonAt& at, const std::string& prefix) {
  if (!at.value.is_object() || (at.value.empty() && !prefix.empty())) at.refuse("an object with members");
  Settings settings;
  for (const auto& [key, value] : at.value.items()) {
    if (value.is_null()) continue;
    const JsonAt member{value, at.where + "." + key};
    if (prefix.empty() && std::count(robot_groups().begin(), robot_groups().end(), key) > 0)
      settings.merge(robot_settings(member, key + "_"));
    else
      settings[prefix + key] = value_of(member);
  }
  return settings;
}

std::string value_text(const Value& value) {
  return std::holds_alternative<std::string>(value) ? json_text(std::get<std::string>(value)) : to_text(value);
}

/// The members of one group of robot parameters; group "": those in no group.
std::string members_text(const Robot& robot, const Settings& settings, const std::string& group) {
  std::string text;
  for (const Parameter<Robot>& parameter : robot_parameters()) {
    const std::string& name = parameter.info.name;
    const auto value = settings.find(name);
    if (robot_group(name) != group || value == settings.end()) continue;
    const std::string key = group.empty() ? name : name.substr(group.size() + 1);
    text += fmt::format("{}\"{}\": {}", text.empty() ? "" : ", ", key,
                        name == "footprint" ? json_points(robot.footprint) : value_text(value->second));
  }
  return text;
}

}  // namespace

Settings read_settings(const JsonAt& at) {
  if (!at.value.is_object()) at.refuse("an object with members");
  Settings settings;
  for (const auto& [key, value] : at.value.items())
    if (!value.is_null()) settings[key] = value_of({value, at.where + "." + key});
  return settings;
}

std::string settings_text(const Settings& settings) {
  std::string text;
  for (const auto& [name, value] : settings)
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", json_text(name), value_text(value));
  return "{" + text + "}";
}

Robot read_robot(const JsonAt& at, const std::string& file) {
  Robot robot;
  const Settings settings = robot_settings(at, "");
  try {
    change(robot, settings);
    check(robot);
  } catch (const std::invalid_argument& e) { throw_invalid("{}: {}", file, e.what()); }
  return robot;
}

std::string robot_text(const Robot& robot) {
  const Settings settings = settings_of(robot);
  std::string text = members_text(robot, settings, "");
  for (const std::string& group : robot_groups())
    if (const std::string members = members_text(robot, settings, group); !members.empty())
      text += fmt::format(", \"{}\": {{{}}}", group, members);
  return "{" + text + "}";
}

}  // namespace oxturn

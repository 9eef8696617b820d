#include "bench/suite_parts.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace oxturn {
namespace {

bool is_point_list(const toml::node& node) {
  const toml::array* list = node.as_array();
  return list != nullptr && !list->empty() && (*list)[0].is_array();
}

}  // namespace

std::vector<std::vector<Choice>> product(const std::string& file, const std::vector<Choice>& keys) {
  std::vector<std::vector<Choice>> all{{}};
  for (const auto& [key, node] : keys) {
    const auto values = is_point_list(*node) ? std::vector{node} : alternatives(file, *node, key);
    std::vector<std::vector<Choice>> longer;
    for (const auto& chosen : all)
      for (const toml::node* value : values) {
        longer.push_back(chosen);
        longer.back().emplace_back(key, value);
      }
    all = std::move(longer);
  }
  return all;
}

Value setting_of(const std::string& file, const toml::node& node, const std::string& key) {
  if (!is_point_list(node)) return value_of(file, node, key);
  std::string text;
  for (const toml::node& item : *node.as_array()) {
    const toml::array* point = item.as_array();
    const bool pair = point != nullptr && point->size() == 2 && (*point)[0].is_number() && (*point)[1].is_number();
    if (!pair) refuse(file, item, fmt::format("{} holds something that is not a point [x, y]", key));
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", to_decimal(*(*point)[0].value<double>()),
                        to_decimal(*(*point)[1].value<double>()));
  }
  return text;
}

Settings settings_of(const std::string& file, const std::string& owner, const std::vector<ParameterInfo>& parameters,
                     const std::vector<Choice>& chosen, Defaults defaults) {
  Settings settings;
  for (const auto& [key, node] : chosen) {
    const ParameterInfo* parameter = nullptr;
    at_position(file, *node, [&, name = key] { parameter = &find_parameter(owner, parameters, name); });
    Value given = setting_of(file, *node, key);
    at_position(file, *node, [&] { given = checked(owner, *parameter, given); });
    if (defaults == Defaults::keep || given != parameter->fallback) settings[key] = given;
  }
  return settings;
}

bool truth(const std::string& file, const toml::node& node, const std::string& key) {
  const auto* value = node.as_boolean();
  if (value == nullptr) refuse(file, node, fmt::format("{} is not true or false", key));
  return value->get();
}

}  // namespace oxturn

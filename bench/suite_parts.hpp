/// The parts of reading a suite: each section of the TOML file has its source. Internal to bench/.
///
/// Lists multiply in the file's order: the key written first varies slowest.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/registry.hpp"
#include "bench/suite.hpp"
#include "bench/toml_reader.hpp"

namespace oxturn {

/// A key of a table, and one of its alternatives.
using Choice = std::pair<std::string, const toml::node*>;

/// Every combination of one alternative of each key. A list of lists is one list of points, not a list of alternatives.
std::vector<std::vector<Choice>> product(const std::string& file, const std::vector<Choice>& keys);

/// A list of points [x, y] as the text "x y; x y", any other value as it is.
Value setting_of(const std::string& file, const toml::node& node, const std::string& key);

enum class Defaults { keep, drop };  // settings that equal the parameter's default
/// The settings of one combination, checked against the parameters of `owner`.
Settings settings_of(const std::string& file, const std::string& owner, const std::vector<ParameterInfo>& parameters,
                     const std::vector<Choice>& chosen, Defaults defaults);

bool truth(const std::string& file, const toml::node& node, const std::string& key);

/// `node` is the section, `root` the whole file; nullptr if the section is missing.
std::vector<Robot> read_robots(const std::string& file, const toml::node* node, const toml::table& root);
std::vector<MapSpec> read_maps(const std::string& file, const toml::node* node, const toml::table& root,
                               const Registry& registry, const Limits& limits);
/// Adds external planners to `planners`.
std::vector<PlannerSpec> read_planners(const std::string& file, const toml::node* node, const toml::table& root,
                                       Planners& planners);

}  // namespace oxturn

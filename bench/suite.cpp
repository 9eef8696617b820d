#include "bench/suite.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "bench/run_id.hpp"
#include "bench/suite_parts.hpp"

namespace oxturn {
namespace {

constexpr double kMost = 1e15;  // of a seed: exact as a double

}  // namespace

Settings PlannerSpec::said() const {
  Settings all = settings;
  if (ignore_tether) all[kIgnoreTether] = true;
  return all;
}

std::string PlannerSpec::variant() const {
  const Settings all = said();
  return all.empty() ? name : fmt::format("{}[{}]", name, to_text(all));
}

std::size_t run_count(const Suite& suite) {
  return suite.maps.size() * suite.robots.size() * suite.planners.size() * static_cast<std::size_t>(suite.repeats);
}

Suite read_suite(const std::string& file, const Registry& registry) {
  const toml::table root = parse_toml(file);
  TomlTable table(file, root, "the suite");
  const toml::node& schema = table.need("schema");
  if (!schema.is_integer() || schema.as_integer()->get() != 1)
    refuse(file, schema, "schema is not 1, the only one there is");
  Suite suite;
  suite.file = file;
  suite.name = table.text("name");
  suite.seed = static_cast<std::uint64_t>(table.whole("seed", 1, {0, kMost}));
  suite.repeats = static_cast<int>(table.whole("repeats", 1, {1, 1e6}));
  suite.warm_ups = static_cast<int>(table.whole("warm_ups", 0, {0, 1000}));
  suite.target_coverage = table.number("target_coverage", 0.99, {0, 1});
  suite.scoring = table.flag("scoring", true);
  const toml::node* limits = table.find("limits");
  const toml::node* robots = table.find("robots");
  const toml::node* maps = table.find("maps");
  const toml::node* kinds = table.find("planners");
  table.end();
  if (limits != nullptr) {
    if (!limits->is_table()) refuse(file, *limits, "limits is no table; write [limits]");
    TomlTable inner(file, *limits->as_table(), "[limits]");
    suite.limits.wall_s = inner.number("wall_s", suite.limits.wall_s, {0.001, 1e7});
    suite.limits.cpu_s = inner.number("cpu_s", suite.limits.cpu_s, {0, 1e7});
    suite.limits.memory_mb = inner.number("memory_mb", suite.limits.memory_mb, {1, 1e9});
    inner.end();
  }
  suite.robots = read_robots(file, robots, root);
  suite.maps = read_maps(file, maps, root, registry, suite.limits);
  Planners planners = registry.planners;
  suite.planners = read_planners(file, kinds, root, planners);
  for (std::size_t i = registry.planners.size(); i < planners.size(); ++i) suite.programs.push_back(planners[i]);
  return suite;
}

}  // namespace oxturn

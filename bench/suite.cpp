// Reads a suite and multiplies its lists out.
//
// Decisions  1. Lists multiply in the file's order: the key written first varies slowest.
//            2. "*" means every planner that is not listed already with the same settings.
//            3. A setting equal to the default is no setting: `zigzag[margin=0]` and `zigzag` are one variant.
//            4. Map files are read here, so that a bad one stops the suite at the start.
//            5. ignore_tether is a key of the suite, not a parameter: it says what the planner is given, and how its path
//               is judged.
#include "bench/suite.hpp"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <stdexcept>

#include "bench/run_id.hpp"
#include "bench/toml_reader.hpp"
#include "maps/generators.hpp"
#include "base/text.hpp"

namespace oxturn {

namespace {

constexpr double kMost = 1e15;

using Choice = std::pair<std::string, const toml::node*>;

// A list of lists is one polygon, no list of alternatives.
bool is_ring(const toml::node& node) {
  const toml::array* list = node.as_array();
  return list != nullptr && !list->empty() && (*list)[0].is_array();
}

// Every combination of one alternative of each key.
std::vector<std::vector<Choice>> product(const std::string& file, const std::vector<Choice>& keys) {
  std::vector<std::vector<Choice>> all{{}};
  for (const auto& [key, node] : keys) {
    std::vector<std::vector<Choice>> longer;
    for (const auto& chosen : all) {
      for (const toml::node* value :
           key == "footprint" && is_ring(*node) ? std::vector{node} : alternatives(file, *node, key)) {
        longer.push_back(chosen);
        longer.back().emplace_back(key, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

// The settings of one combination, checked against the parameters of `owner`.
Settings settings_of(const std::string& file, const std::string& owner, const std::vector<ParameterInfo>& parameters,
                     const std::vector<Choice>& chosen, bool keep_defaults) {
  Settings settings;
  for (const auto& [key, node] : chosen) {
    at_place(file, *node, [&, name = key, value = node] {
      const ParameterInfo& parameter = find_parameter(owner, parameters, name);
      Value given;
      try {
        given = value_of(file, *value, name);
      } catch (const std::invalid_argument&) {
        throw std::invalid_argument(fmt::format("{} is a table, list or date, expected one value", name));
      }
      given = checked(owner, parameter, given);
      if (keep_defaults || given != parameter.fallback) settings[name] = given;
    });
  }
  return settings;
}

bool truth(const std::string& file, const toml::node& node, const std::string& key) {
  const auto* value = node.as_boolean();
  if (value == nullptr) refuse(file, node, fmt::format("{} is not true or false", key));
  return value->get();
}

double real(const std::string& file, const toml::node& node, const std::string& key) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) refuse(file, node, fmt::format("{} is not a number", key));
  return *value;
}

// ---------------------------------------------------------------------------------------------------- robots

std::vector<Choice> robot_keys(const std::string& file, TomlTable& table) {
  std::vector<Choice> keys;
  for (const auto& [key, node] : table.rest()) {
    const toml::table* inner = node->as_table();
    if ((key != "tether" && key != "lidar") || inner == nullptr) {
      keys.emplace_back(key, node);
      continue;
    }
    const TomlTable nested(file, *inner, key);
    if (nested.rest().empty()) refuse(file, *node, fmt::format("{} is an empty table", key));
    for (const auto& [part, value] : nested.rest()) keys.emplace_back(key + "." + part, value);
  }
  return keys;
}

/// [[0.5, 0], [0, 0.5], [-0.5, 0], [0, -0.5]] or "octagon:1".
Ring footprint_of(const std::string& file, const toml::node& node) {
  Ring ring;
  if (const auto* name = node.as_string()) {
    at_place(file, node, [&] { ring = named_footprint(name->get()); });
    return ring;
  }
  const char* const expected = "footprint is neither \"square:WIDTH\", \"octagon:WIDTH\" nor a list of corners [x, y]";
  const toml::array* corners = node.as_array();
  if (corners == nullptr || corners->empty()) refuse(file, node, expected);
  for (const toml::node& corner : *corners) {
    const toml::array* xy = corner.as_array();
    if (xy == nullptr || xy->size() != 2) refuse(file, corner, expected);
    ring.emplace_back(real(file, (*xy)[0], "footprint"), real(file, (*xy)[1], "footprint"));
  }
  return ring;
}

Robot robot_of(const std::string& file, const std::string& name, const std::vector<Choice>& chosen,
               const toml::node& place) {
  Robot robot;
  robot.name = name;
  const auto tether = [&]() -> Tether& { return robot.tether ? *robot.tether : robot.tether.emplace(); };
  const auto lidar = [&]() -> Lidar& { return robot.lidar ? *robot.lidar : robot.lidar.emplace(); };
  for (const auto& [key, node] : chosen) {
    const auto number = [&, k = key, n = node] { return real(file, *n, k); };
    if (key == "radius")
      robot.radius = number();
    else if (key == "footprint")
      robot.footprint = footprint_of(file, *node);
    else if (key == "tool_width")
      robot.tool_width = number();
    else if (key == "speed")
      robot.speed = number();
    else if (key == "acceleration")
      robot.acceleration = number();
    else if (key == "turn_rate")
      robot.turn_rate = number();
    else if (key == "min_turn_radius")
      robot.min_turn_radius = number();
    else if (key == "tether.length")
      tether().length = number();
    else if (key == "tether.reach")
      tether().reach = number();
    else if (key == "tether.sharp_angle")
      tether().sharp_angle = number();
    else if (key == "lidar.range")
      lidar().range = number();
    else if (key == "lidar.rays") {
      const auto* rays = node->as_integer();
      if (rays == nullptr || rays->get() < 1 || rays->get() > 1000000)
        refuse(file, *node, "lidar.rays is no whole number from 1 to 1000000");
      lidar().rays = static_cast<int>(rays->get());
    } else if (key == "lidar.noise") {
      lidar().noise = number();
    } else {
      refuse(
          file, *node,
          fmt::format("unknown key '{}' in robot '{}'; expected: radius, footprint, tool_width, speed, acceleration, "
                      "turn_rate, min_turn_radius, tether.length, tether.reach, tether.sharp_angle, lidar.range, "
                      "lidar.rays, lidar.noise",
                      key, name));
    }
  }
  const auto given = [&](const char* key) {
    return std::any_of(chosen.begin(), chosen.end(), [&](const Choice& c) { return c.first == key; });
  };
  if (given("radius") && given("footprint"))
    refuse(file, place, fmt::format("robot '{}' has a radius and a footprint, expected one of the two", name));
  at_place(file, place, [&] { check(robot); });
  return robot;
}

std::vector<Robot> read_robots(const std::string& file, const toml::node* node, const toml::table& root) {
  const char* const none = "no [robots.NAME] table; a suite needs at least one robot";
  if (node == nullptr) refuse(file, root, none);
  if (!node->is_table()) refuse(file, *node, none);
  std::vector<Robot> robots;
  const TomlTable named(file, *node->as_table(), "robots");
  if (named.rest().empty()) refuse(file, *node, none);
  for (const auto& [name, body] : named.rest()) {
    if (!body->is_table()) refuse(file, *body, fmt::format("robots.{} is no table; write [robots.{}]", name, name));
    TomlTable table(file, *body->as_table(), fmt::format("robot '{}'", name));
    const auto keys = robot_keys(file, table);
    for (const auto& chosen : product(file, keys)) {
      // What varies goes into the name.
      Settings varied;
      for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].second != chosen[i].second)
          varied[keys[i].first] = value_of(file, *chosen[i].second, keys[i].first);
      }
      const std::string full = varied.empty() ? name : fmt::format("{}[{}]", name, settings_text(varied));
      robots.push_back(robot_of(file, full, chosen, *body));
    }
  }
  return robots;
}

// ------------------------------------------------------------------------------------------------------ maps

std::vector<std::string> matching(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> files;
  if (::glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) files.emplace_back(found.gl_pathv[i]);
  }
  ::globfree(&found);
  std::sort(files.begin(), files.end());  // by bytes, not by the user's locale
  return files;
}

bool is_point(const toml::node& node) {
  const toml::array* pair = node.as_array();
  return pair != nullptr && pair->size() == 2 && (*pair)[0].is_number() && (*pair)[1].is_number();
}

/// [x, y], a name, or a list of such; one empty place if the key is missing.
std::vector<std::optional<Location>> read_locations(const std::string& file, TomlTable& table, const char* key, LocationKind of) {
  const toml::node* node = table.find(key);
  if (node == nullptr) return {std::nullopt};
  const auto place = [&](const toml::node& n) {
    Location found;
    if (is_point(n)) {
      const toml::array& pair = *n.as_array();
      found.point = {*pair[0].value<double>(), *pair[1].value<double>()};
    } else if (const auto* name = n.as_string()) {
      at_place(file, n, [&] { found = named_location(of, name->get()); });
    } else {
      std::string names;
      for (const std::string& known : location_names(of)) names += fmt::format(", \"{}\"", known);
      refuse(file, n,
             fmt::format("{} is neither [x, y] in metres nor one of{}, nor a list of such", key, names.substr(1)));
    }
    return found;
  };
  if (is_point(*node)) return {place(*node)};
  std::vector<std::optional<Location>> places;
  for (const toml::node* item : alternatives(file, *node, key)) places.emplace_back(place(*item));
  return places;
}

/// `spec` once for each start and anchor.
void add_placed(MapSpec spec, const std::vector<std::optional<Location>>& starts,
                const std::vector<std::optional<Location>>& anchors, std::vector<MapSpec>& maps) {
  for (const auto& start : starts) {
    spec.start = start;
    for (const auto& anchor : anchors) {
      spec.anchor = anchor;
      maps.push_back(spec);
    }
  }
}

void read_generated(const std::string& file, TomlTable& table, std::vector<MapSpec>& maps) {
  const auto starts = read_locations(file, table, "start", LocationKind::start);
  const auto anchors = read_locations(file, table, "anchor", LocationKind::anchor);
  std::vector<std::uint64_t> seeds{1};
  if (const toml::node* node = table.find("seeds")) {
    seeds.clear();
    for (const toml::node* item : alternatives(file, *node, "seeds")) {
      const auto* value = item->as_integer();
      if (value == nullptr || value->get() < 0)
        refuse(file, *item, "seeds holds something that is not a whole number of at least 0");
      seeds.push_back(static_cast<std::uint64_t>(value->get()));
    }
  }
  const toml::node& names = table.need("generator");
  for (const toml::node* name_node : alternatives(file, names, "generator")) {
    const auto* name = name_node->as_string();
    if (name == nullptr) refuse(file, *name_node, "generator is not a text in quotes");
    const GeneratorInfo* generator = nullptr;
    at_place(file, *name_node, [&] { generator = &find_generator(name->get()); });
    for (const auto& chosen : product(file, table.rest())) {
      MapSpec spec;
      spec.generator = generator->name;
      spec.settings =
          settings_of(file, fmt::format("generator '{}'", generator->name), generator->parameters, chosen, true);
      for (const std::uint64_t seed : seeds) {
        spec.seed = seed;
        add_placed(spec, starts, anchors, maps);
      }
    }
  }
}

void read_files(const std::string& file, TomlTable& table, std::vector<MapSpec>& maps) {
  const auto starts = read_locations(file, table, "start", LocationKind::start);
  const auto anchors = read_locations(file, table, "anchor", LocationKind::anchor);
  const toml::node& patterns = table.need("file");
  std::vector<Choice> keys;
  for (const char* key : {"drop_speckle", "simplify", "metres_per_pixel", "unknown_is_free"}) {
    if (const toml::node* node = table.find(key)) keys.emplace_back(key, node);
  }
  table.end();
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (const toml::node* node : alternatives(file, patterns, "file")) {
    const auto* pattern = node->as_string();
    if (pattern == nullptr || pattern->get().empty()) refuse(file, *node, "file is not a text in quotes");
    const auto files = matching((folder / pattern->get()).string());
    if (files.empty()) {
      refuse(file, *node,
             fmt::format("no file matches '{}' in the folder '{}'", pattern->get(),
                         folder.empty() ? "." : folder.string()));
    }
    for (const auto& chosen : product(file, keys)) {
      ReadOptions options;
      for (const auto& [key, value] : chosen) {
        if (key == "unknown_is_free") {
          options.unknown_is_free = truth(file, *value, key);
          continue;
        }
        const double number = real(file, *value, key);
        if (!(number >= 0 && number < kMost))
          refuse(file, *value, fmt::format("{} is {}, expected a number of at least 0", key, to_decimal(number)));
        (key == "drop_speckle" ? options.drop_speckle_m2
         : key == "simplify"   ? options.simplify_m
                               : options.metres_per_pixel) = number;
      }
      for (const std::string& found : files) {
        MapSpec spec;
        spec.file = found;
        spec.read = options;
        at_place(file, *node, [&] { spec.content = std::make_shared<const MapFile>(read_map(found, options)); });
        add_placed(spec, starts, anchors, maps);
      }
    }
  }
}

std::vector<MapSpec> read_maps(const std::string& file, const toml::node* node, const toml::table& root) {
  if (node == nullptr) refuse(file, root, "no [[maps]]; a suite needs at least one");
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) refuse(file, *node, "maps is no list of tables; write [[maps]]");
  std::vector<MapSpec> maps;
  for (const toml::node& item : *list) {
    if (!item.is_table()) refuse(file, item, "maps is no list of tables; write [[maps]]");
    TomlTable table(file, *item.as_table(), "[[maps]]");
    const bool generated = item.as_table()->contains("generator"), read = item.as_table()->contains("file");
    if (generated == read) refuse(file, item, "[[maps]] needs either 'generator' or 'file'");
    if (generated)
      read_generated(file, table, maps);
    else
      read_files(file, table, maps);
  }
  at_place(file, *node, [&] { name_maps(maps); });
  return maps;
}

// -------------------------------------------------------------------------------------------------- planners

// A planner that runs another one has more parameters, which its own settings tell.
std::vector<ParameterInfo> parameters_for(const std::string& file, const PlannerInfo& planner,
                                          const std::vector<Choice>& chosen) {
  if (!planner.more_parameters) return planner.parameters;
  std::vector<Choice> own;
  for (const Choice& choice : chosen)
    for (const ParameterInfo& parameter : planner.parameters)
      if (choice.first == parameter.name) own.push_back(choice);
  const Settings settings = settings_of(file, fmt::format("planner '{}'", planner.name), planner.parameters, own, true);
  std::vector<ParameterInfo> all;
  const auto ask = [&] { all = parameters_of(planner, settings); };
  if (own.empty())
    ask();
  else
    at_place(file, *own.front().second, ask);
  return all;
}

/// The values of ignore_tether; one `false` if the key is missing.
std::vector<bool> read_ignored(const std::string& file, TomlTable& table) {
  const toml::node* node = table.find(kIgnoreTether);
  if (node == nullptr) return {false};
  std::vector<bool> all;
  for (const toml::node* item : alternatives(file, *node, kIgnoreTether))
    all.push_back(truth(file, *item, kIgnoreTether));
  return all;
}

std::vector<PlannerSpec> read_planners(const std::string& file, const toml::node* node, const toml::table& root,
                                       const std::vector<PlannerInfo>& planners) {
  if (node == nullptr) refuse(file, root, "no [[planners]]; a suite needs at least one, for instance name = \"*\"");
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) refuse(file, *node, "planners is no list of tables; write [[planners]]");
  std::vector<PlannerSpec> specs;
  std::set<std::string> variants;
  for (const toml::node& item : *list) {
    if (!item.is_table()) refuse(file, item, "planners is no list of tables; write [[planners]]");
    TomlTable table(file, *item.as_table(), "[[planners]]");
    const std::vector<bool> ignored = read_ignored(file, table);
    for (const toml::node* name_node : alternatives(file, table.need("name"), "name")) {
      const auto* name = name_node->as_string();
      if (name == nullptr) refuse(file, *name_node, "name is not a text in quotes");
      const bool all = name->get() == "*";
      std::vector<const PlannerInfo*> meant;
      if (all) {
        for (const PlannerInfo& planner : planners) meant.push_back(&planner);
      } else {
        at_place(file, *name_node, [&] { meant.push_back(&find_planner(planners, name->get())); });
      }
      const auto combinations = product(file, table.rest());
      const auto add = [&](PlannerSpec spec) {
        if (variants.insert(spec.variant()).second)
          specs.push_back(std::move(spec));
        else if (!all)
          refuse(file, item, fmt::format("planner variant '{}' is listed twice", spec.variant()));
      };
      for (const PlannerInfo* planner : meant) {
        const bool tethered = planner->has(Capability::tether);
        for (const auto& chosen : combinations) {
          PlannerSpec spec{planner->name, settings_of(file, fmt::format("planner '{}'", planner->name),
                                                      parameters_for(file, *planner, chosen), chosen, false)};
          for (const bool ignore : ignored) {
            if (ignore && tethered && !all)
              refuse(file, *name_node,
                     fmt::format("planner '{}' minds the tether, so ignore_tether = true is not for it; leave it out",
                                 planner->name));
            spec.ignore_tether = ignore && !tethered;
            add(spec);
          }
        }
      }
    }
  }
  return specs;
}

std::string plain_name(const MapSpec& spec) {
  return spec.generator.empty() ? std::filesystem::path(spec.file).stem().string()
                                : fmt::format("{}-{}", spec.generator, spec.seed);
}

// Everything that may tell two maps of one plain name apart.
Settings differences(const MapSpec& spec) {
  Settings all = spec.settings;
  if (spec.generator.empty()) {
    all["file"] = spec.file;
    all["drop_speckle"] = spec.read.drop_speckle_m2;
    all["simplify"] = spec.read.simplify_m;
    all["metres_per_pixel"] = spec.read.metres_per_pixel;
    all["unknown_is_free"] = spec.read.unknown_is_free;
  }
  if (spec.start) all["start"] = to_text(*spec.start);
  if (spec.anchor) all["anchor"] = to_text(*spec.anchor);
  return all;
}

}  // namespace

void name_maps(std::vector<MapSpec>& maps) {
  std::map<std::string, std::vector<MapSpec*>> namesakes;
  for (MapSpec& spec : maps) {
    if (spec.name.empty()) namesakes[plain_name(spec)].push_back(&spec);
  }
  for (auto& [name, specs] : namesakes) {
    std::map<std::string, std::set<std::string>> values;  // of each key; "" where a map does not have it
    for (const MapSpec* spec : specs) {
      for (const auto& [key, value] : differences(*spec)) values[key].insert(to_text(value));
    }
    for (const MapSpec* spec : specs) {
      const Settings own = differences(*spec);
      for (auto& [key, seen] : values) {
        if (!own.contains(key)) seen.insert("");
      }
    }
    for (MapSpec* spec : specs) {
      Settings telling;
      for (const auto& [key, value] : differences(*spec)) {
        if (values[key].size() > 1) telling[key] = value;
      }
      spec->name = telling.empty() ? name : fmt::format("{}[{}]", name, settings_text(telling));
    }
  }
  std::set<std::string> seen;
  for (const MapSpec& spec : maps) {
    if (!seen.insert(spec.name).second) throw std::invalid_argument(fmt::format("map '{}' is listed twice", spec.name));
  }
}

Suite read_suite(const std::string& file, const std::vector<PlannerInfo>& planners) {
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
  suite.target_coverage = table.number("target_coverage", 0.99, {0, 1});
  const toml::node* limits = table.find("limits");
  const toml::node* robots = table.find("robots");
  const toml::node* maps = table.find("maps");
  const toml::node* kinds = table.find("planners");
  table.end();
  if (limits != nullptr) {
    if (!limits->is_table()) refuse(file, *limits, "limits is no table; write [limits]");
    TomlTable inner(file, *limits->as_table(), "[limits]");
    suite.limits.wall_s = inner.number("wall_s", suite.limits.wall_s, {0.001, 1e7});
    suite.limits.memory_mb = inner.number("memory_mb", suite.limits.memory_mb, {1, 1e9});
    inner.end();
  }
  suite.robots = read_robots(file, robots, root);
  suite.maps = read_maps(file, maps, root);
  suite.planners = read_planners(file, kinds, root, planners);
  return suite;
}

}  // namespace oxturn

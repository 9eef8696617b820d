// [[maps]]: generators with their parameters and seeds, or files, each with its starts, anchors and target areas.
//
// Map files are read here, in processes of their own, so that a bad one stops the suite at the start.
#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "bench/isolate.hpp"
#include "bench/suite_parts.hpp"

namespace oxturn {
namespace {

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

/// [x, y], a name, or a list of them; one empty location if the key is missing.
std::vector<std::optional<Location>> read_locations(const std::string& file, TomlTable& table, const char* key,
                                                    LocationKind of) {
  const toml::node* node = table.find(key);
  if (node == nullptr) return {std::nullopt};
  const auto location = [&](const toml::node& n) {
    Location found;
    if (is_point(n)) {
      const toml::array& pair = *n.as_array();
      found.point = {*pair[0].value<double>(), *pair[1].value<double>()};
    } else if (const auto* name = n.as_string()) {
      at_position(file, n, [&] { found = named_location(of, name->get()); });
    } else {
      std::string names;
      for (const std::string& known : location_names(of)) names += fmt::format(", \"{}\"", known);
      refuse(file, n,
             fmt::format("{} is neither [x, y] in metres nor one of{}, nor a list of them", key, names.substr(1)));
    }
    return found;
  };
  if (is_point(*node)) return {location(*node)};
  std::vector<std::optional<Location>> all;
  for (const toml::node* item : alternatives(file, *node, key)) all.emplace_back(location(*item));
  return all;
}

/// Under the suite's limits: bad content is refused at once, a file that breaks a limit becomes rows.
std::shared_ptr<const MapFile> read_under_limits(const MapSpec& spec, const MapFormats& formats, const Limits& limits) {
  ReadResult result = read_map_isolated(spec.file, spec.read, formats, limits);
  if (result.file) return std::make_shared<const MapFile>(std::move(*result.file));
  const Outcome outcome = result.report.outcome;
  if (outcome == Outcome::timeout || outcome == Outcome::out_of_memory) return nullptr;
  throw std::invalid_argument(result.report.reason);
}

/// What varies a map: its starts, anchors and target areas.
struct Placements {
  std::vector<std::optional<Location>> starts, anchors;
  struct Target {
    std::string file;  // empty: the map's own
    std::optional<Region> area;
  };
  std::vector<Target> targets;
};

std::vector<Placements::Target> read_targets(const std::string& file, TomlTable& table, const MapFormats& formats,
                                             const Limits& limits) {
  const toml::node* node = table.find("target");
  if (node == nullptr) return {{}};
  std::vector<Placements::Target> targets;
  for (const toml::node* item : alternatives(file, *node, "target")) {
    const auto* name = item->as_string();
    if (name == nullptr || name->get().empty()) refuse(file, *item, "target is not the name of a map file in quotes");
    const std::string path = (std::filesystem::path(file).parent_path() / name->get()).string();
    MapSpec map;
    map.file = path;
    std::shared_ptr<const MapFile> content;
    at_position(file, *item, [&] { content = read_under_limits(map, formats, limits); });
    if (!content) refuse(file, *item, fmt::format("reading the target area '{}' breaks the suite's limits", path));
    targets.push_back({path, content->map.free});
  }
  return targets;
}

Placements read_placements(const std::string& file, TomlTable& table, const MapFormats& formats, const Limits& limits) {
  return {read_locations(file, table, "start", LocationKind::start),
          read_locations(file, table, "anchor", LocationKind::anchor), read_targets(file, table, formats, limits)};
}

/// `spec` once for each target area, start and anchor.
void add_placed(MapSpec spec, const Placements& placements, std::vector<MapSpec>& maps) {
  for (const auto& target : placements.targets) {
    spec.target = target.file;
    spec.target_area = target.area;
    for (const auto& start : placements.starts) {
      spec.start = start;
      for (const auto& anchor : placements.anchors) {
        spec.anchor = anchor;
        maps.push_back(spec);
      }
    }
  }
}

void read_generated(const std::string& file, TomlTable& table, const Registry& registry, const Limits& limits,
                    std::vector<MapSpec>& maps) {
  const Placements placements = read_placements(file, table, registry.formats, limits);
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
    at_position(file, *name_node, [&] { generator = &registry.generators.find(name->get()); });
    for (const auto& chosen : product(file, table.rest())) {
      MapSpec spec;
      spec.generator = generator->name;
      spec.settings = settings_of(file, fmt::format("generator '{}'", generator->name), generator->parameters, chosen,
                                  Defaults::keep);
      for (const std::uint64_t seed : seeds) {
        spec.seed = seed;
        add_placed(spec, placements, maps);
      }
    }
  }
}

void read_files(const std::string& file, TomlTable& table, const MapFormats& formats, const Limits& limits,
                std::vector<MapSpec>& maps) {
  const Placements placements = read_placements(file, table, formats, limits);
  const toml::node& patterns = table.need("file");
  const std::vector<ParameterInfo> parameters = reader_parameters(formats);
  const auto combinations = product(file, table.rest());
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
    for (const auto& chosen : combinations) {
      MapSpec spec;
      spec.read = settings_of(file, "a map reader", parameters, chosen, Defaults::drop);
      for (const std::string& found : files) {
        spec.file = found;
        at_position(file, *node, [&] { spec.content = read_under_limits(spec, formats, limits); });
        add_placed(spec, placements, maps);
      }
    }
  }
}

}  // namespace

std::vector<MapSpec> read_maps(const std::string& file, const toml::node* node, const toml::table& root,
                               const Registry& registry, const Limits& limits) {
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
      read_generated(file, table, registry, limits, maps);
    else
      read_files(file, table, registry.formats, limits, maps);
  }
  at_position(file, *node, [&] { name_maps(maps); });
  return maps;
}

namespace {

std::string plain_name(const MapSpec& spec) {
  return spec.generator.empty() ? std::filesystem::path(spec.file).stem().string()
                                : fmt::format("{}-{}", spec.generator, spec.seed);
}

// Everything that may tell two maps of one plain name apart.
Settings differences(const MapSpec& spec) {
  Settings all = spec.settings;
  if (spec.generator.empty()) {
    all = spec.read;
    all["file"] = spec.file;
  }
  if (!spec.target.empty()) all["target"] = spec.target;
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
      spec->name = telling.empty() ? name : fmt::format("{}[{}]", name, to_text(telling));
    }
  }
  std::set<std::string> seen;
  for (const MapSpec& spec : maps) {
    if (!seen.insert(spec.name).second) throw std::invalid_argument(fmt::format("map '{}' is listed twice", spec.name));
  }
}

}  // namespace oxturn

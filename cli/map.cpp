// oxturn map: makes a map, or converts one.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "maps/generators.hpp"
#include "base/files.hpp"
#include "maps/path_file.hpp"
#include "maps/picture.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string source, output;
  std::vector<std::string> settings;
  std::optional<std::uint64_t> seed;
  ReadOptions read;
};

bool is_generator(const std::string& name) {
  const auto& all = generators();
  return std::any_of(all.begin(), all.end(), [&](const GeneratorInfo& g) { return g.name == name; });
}

MapFile make(const Options& options) {
  const bool file = file_exists(options.source) || options.source.find_first_of("./\\") != std::string::npos;
  if (file && !is_generator(options.source)) {
    if (!options.settings.empty() || options.seed)
      throw std::invalid_argument(
          fmt::format("--set and --seed are for generators, and '{}' is a file", options.source));
    return read_map(options.source, options.read);
  }
  const GeneratorInfo& generator = find_generator(options.source);
  const Settings settings =
      parse_settings("generator '" + generator.name + "'", generator.parameters, options.settings);
  return MapFile{generate(generator.name, settings, options.seed.value_or(1)), {}, {}, {}, {}};
}

int map(const Options& options) {
  require_suffix(options.output, {".geojson", ".json", ".svg"});
  require_writable(options.output);
  const MapFile file = make(options);
  say_remarks(file);
  write_file(options.output, has_suffix(options.output, ".svg") ? to_svg(file.map) : to_geojson(file));
  fmt::print("{}: '{}', {:.6g} m2 free, {} corners, {} holes\n", options.output, file.map.name, area(file.map.free),
             vertex_count(file.map.free), hole_count(file.map.free));
  return 0;
}

std::function<int()> attach(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("SOURCE", options->source, "a generator (`oxturn list maps`) or a map's file (`oxturn list formats`)")
      ->required();
  add_settings(app, options->settings, "generator");
  app.add_option("--seed", options->seed, "of the generator; 1 if not given")->check(whole_number())->type_name("N");
  app.add_option("-o,--output", options->output, "FILE.geojson or FILE.svg")->required()->type_name("FILE");
  add_reader_options(app, options->read);
  return [options] { return map(*options); };
}

}  // namespace

Command map_command() {
  return {"map", "make a map, or convert one to GeoJSON or SVG",
          "  oxturn map rooms --set rooms=9 --seed 7 -o rooms.geojson\n"
          "  oxturn map kitchen.yaml --drop-speckle 0.02 -o kitchen.svg\n"
          "  oxturn map plan.png --scale 0.05 -o plan.geojson\n",
          attach};
}

}  // namespace oxturn::cli

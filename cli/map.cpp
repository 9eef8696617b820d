// oxturn map: makes a map, or converts one.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/problem_options.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string source, output;
  std::string from, to;  // names of formats; empty: by the suffixes
  std::vector<std::string> settings;
  std::optional<std::uint64_t> seed;
  std::string target;
  ReaderOptions read;
};

MapSource source_of(const Options& options, const Registry& registry) {
  if (!options.from.empty())
    return {.file = options.source, .settings = reader_settings(options.read, registry.formats)};
  ProblemOptions map;
  map.map = options.source;
  map.read = options.read;
  return map_source(map, registry);
}

MapFile make(const Options& options, const Registry& registry) {
  MapSource source = source_of(options, registry);
  if (!source.file.empty()) {
    if (!options.settings.empty() || options.seed)
      throw std::invalid_argument(
          fmt::format("--set and --seed are for generators, and '{}' is a file", options.source));
    return read_map(source.file, source.settings, registry.formats, options.from);
  }
  const GeneratorInfo& generator = registry.generators.find(source.generator);
  for (const auto& [name, value] :
       parse_settings("generator '" + generator.name + "'", generator.parameters, options.settings))
    if (!source.settings.emplace(name, value).second)
      throw std::invalid_argument(fmt::format("{} is given twice: by '{}' and by --set", name, options.source));
  if (options.seed && options.source.substr(0, options.source.find(',')) != source.generator)
    throw std::invalid_argument(
        fmt::format("the seed is given twice: by '{}' and by --seed {}", options.source, *options.seed));
  if (options.seed) source.seed = *options.seed;
  return load_map(source, registry.generators, registry.formats);
}

int map(const Options& options, const Registry& registry) {
  format_to_write(options.output, registry.formats, options.to);
  require_writable(options.output);
  MapFile file = make(options, registry);
  if (!options.target.empty()) file.map.target_area = load_target_area(options.target, registry.formats);
  say_remarks(file);
  write_map(options.output, file, registry.formats, options.to);
  fmt::print(print_to({options.output}), "{}: '{}', {:.6g} m2 free, {} vertices, {} holes\n", options.output,
             file.map.name, area(file.map.free), vertex_count(file.map.free), hole_count(file.map.free));
  return 0;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("SOURCE", options->source, kMapHelp)->required()->type_name("");
  add_settings(app, options->settings, "generator", "maps");
  app.add_option("--seed", options->seed, "seed of the generator, in place of GENERATOR:SEED; 1 if not given")
      ->check(whole_number())
      ->type_name("N");
  app.add_option("-o,--output", options->output, "file to write; its suffix names the format; - is standard output")
      ->required()
      ->type_name("FILE");
  app.add_option(
         "--from", options->from,
         "format of SOURCE (`oxturn list formats`); as its suffix says, geojson for standard input, if not given")
      ->type_name("FORMAT");
  app.add_option("--to", options->to, "format to write; as the suffix says, geojson for standard output, if not given")
      ->type_name("FORMAT");
  add_target_option(app, options->target);
  add_reader_options(app, registry.formats, options->read);
  return [options, &registry] { return map(*options, registry); };
}

}  // namespace

Command map_command() {
  return {"map", "make a map, or convert one to another format",
          "  oxturn map rooms --set rooms=9 --seed 7 -o rooms.geojson\n"
          "  oxturn map kitchen.yaml --drop-speckle 0.02 -o kitchen.svg\n"
          "  oxturn map plan.png --scale 0.05 -o plan.geojson\n"
          "  oxturn map rooms:9 -o - | oxturn plan stc - -o - | oxturn score - rooms:9\n"
          "  oxturn map - --from image --scale 0.05 -o - --to svg < plan.png > plan.svg\n",
          attach};
}

}  // namespace oxturn::cli

#include "cli/problem_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"
#include "cli/arguments.hpp"
#include "maps/locations.hpp"

namespace oxturn::cli {
namespace {

constexpr const char* kReaderGroup = "Options for map files";

/// `tether=25` is short for the first parameter of the group of that name, tether_length=25.
std::string full_name(const std::string& name, const std::vector<ParameterInfo>& parameters) {
  if (std::count(robot_groups().begin(), robot_groups().end(), name) == 0) return name;
  for (const ParameterInfo& parameter : parameters)
    if (robot_group(parameter.name) == name) return parameter.name;
  return name;
}

void change_robot(Robot& robot, const std::string& text) {
  const std::vector<ParameterInfo> parameters = infos_of(robot_parameters());
  Settings settings;
  for (const std::string& part : split(text, ',')) {
    const auto [name, value] = assignment("--robot", part);
    const std::string full = full_name(name, parameters);
    settings[full] = parse_value("a robot", find_parameter("a robot", parameters, full), value);
  }
  change(robot, settings);
}

/// What an option says, else what the map's file does.
std::optional<Location> location_of(LocationKind of, const std::string& text, const std::optional<Point>& in_file) {
  if (text.empty()) return in_file ? std::optional<Location>({"", *in_file}) : std::nullopt;
  try {
    return parse_location(of, text);
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(fmt::format("--{}", e.what()));  // which begins with the option's name
  }
}

std::string option_name(std::string parameter) {
  std::replace(parameter.begin(), parameter.end(), '_', '-');
  return "--" + parameter;
}

std::string robot_help() {
  std::string text =
      "parameters of the robot; those not given are as in the map file, or the defaults (`oxturn list robot`):";
  for (const ParameterInfo& parameter : infos_of(robot_parameters()))
    text += fmt::format("\n  {}: {}", parameter.name, parameter.help);
  return text + "\n(tether=25 is short for tether_length=25)";
}

}  // namespace

void add_reader_options(CLI::App& app, const MapFormats& formats, ReaderOptions& options) {
  for (const ParameterInfo& parameter : reader_parameters(formats)) {
    const std::string name = parameter.name;
    if (std::holds_alternative<bool>(parameter.fallback))
      app.add_flag_callback(
             option_name(name), [&options, name] { options[name] = "true"; }, parameter.help)
          ->group(kReaderGroup);
    else
      app.add_option_function<std::string>(
             option_name(name), [&options, name](const std::string& text) { options[name] = text; }, parameter.help)
          ->type_name(std::holds_alternative<std::string>(parameter.fallback) ? "FILE" : "N")
          ->group(kReaderGroup);
  }
}

Settings reader_settings(const ReaderOptions& options, const MapFormats& formats) {
  const std::vector<ParameterInfo> parameters = reader_parameters(formats);
  Settings settings;
  for (const auto& [name, text] : options)
    settings[name] = parse_value("a map reader", find_parameter("a map reader", parameters, name), text);
  return settings;
}

void say_remarks(const MapFile& file) {
  for (const std::string& remark : file.remarks) say(remark);
}

void add_target_option(CLI::App& app, std::string& file) {
  app.add_option("--target", file,
                 "cover only this area: a map file (`oxturn list formats`) whose free space it is; the robot may drive "
                 "anywhere. As the map says, or all of it, if not given")
      ->type_name("FILE");
}

void add_problem_options(CLI::App& app, const Registry& registry, ProblemOptions& options) {
  app.add_option("--robot", options.robot, robot_help())->type_name("K=V,...");
  app.add_option("--radius", options.radius, "radius of the robot, metres")
      ->check(number_from(0, true, "metres"))
      ->type_name("M");
  app.add_option("--tool-width", options.tool_width, "width of the swath that the robot covers, metres")
      ->check(number_from(0, false, "metres"))
      ->type_name("M");
  app.add_option("--start", options.start,
                 "where the robot starts: X,Y, middle (well inside, or inside the target area) or corner (lower left); "
                 "as the map file says, or middle, if not given")
      ->type_name("POINT");
  app.add_option("--anchor", options.anchor,
                 "where the tether is fastened: X,Y, start, wall (the nearest point of one) or corner (the nearest in "
                 "sight of the start); as the map file says, or start, if not given")
      ->type_name("POINT");
  add_target_option(app, options.target);
  add_reader_options(app, registry.formats, options.read);
}

MapSource map_source(const ProblemOptions& options, const Registry& registry) {
  const std::string& name = options.map;
  const std::size_t comma = std::min(name.find(','), name.size()), colon = name.substr(0, comma).rfind(':');
  const std::string generator = name.substr(0, std::min(colon, comma));
  const GeneratorInfo* const known = registry.generators.get(generator);
  // A name that looks like a file is taken for one, so that a mistyped file is reported as missing.
  if (is_standard_stream(name) || file_exists(name) || (!known && name.find_first_of("./\\") != std::string::npos))
    return {.file = name, .settings = reader_settings(options.read, registry.formats), .target = options.target};
  if (!known)
    throw std::invalid_argument(unknown_name("file and no generator", generator, registry.generators.names()));
  MapSource source{.generator = generator, .target = options.target};
  if (colon != std::string::npos) {
    const std::string text = name.substr(colon + 1, comma - colon - 1);
    const auto seed = parse_whole(text);
    if (!seed)
      throw std::invalid_argument(fmt::format("map '{}': seed is '{}', expected a whole number from 0", name, text));
    source.seed = *seed;
  }
  if (comma < name.size())
    source.settings = parse_settings(fmt::format("generator '{}'", generator), known->parameters,
                                     split(name.substr(comma + 1), ','), "map '" + name + "': setting");
  return source;
}

// Remarks come only when all is well: bad input gets its one sentence and nothing else.
Robot robot_with(const ProblemOptions& options, Robot robot) {
  if (!options.robot.empty()) change_robot(robot, options.robot);
  if (options.radius) change(robot, {{"radius", *options.radius}});
  if (options.tool_width) change(robot, {{"tool_width", *options.tool_width}});
  return robot;
}

Problem make_problem(const ProblemOptions& options, MapFile file) {
  const Robot robot = robot_with(options, file.robot.value_or(Robot{}));
  const bool robot_given = file.robot || !options.robot.empty() || (options.radius && options.tool_width);
  check(robot);
  const auto start = location_of(LocationKind::start, options.start, file.start);
  const auto anchor = location_of(LocationKind::anchor, options.anchor, file.anchor);
  const StartAndAnchor located = resolve(file.map, robot, start, anchor);
  Problem problem(std::move(file.map), robot, located.start, located.anchor);
  say_remarks(file);
  if (!robot_given)
    say(fmt::format("robot: radius {:g} m, tool width {:g} m (set with --radius and --tool-width)", robot.radius,
                    robot.tool_width));
  if (!start) say(fmt::format("start: {:.6g},{:.6g} (set with --start X,Y)", problem.start().x(), problem.start().y()));
  return problem;
}

}  // namespace oxturn::cli

// cli/options.cpp
#include "cli/options.hpp"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "maps/generators.hpp"
#include "maps/locations.hpp"
#include "metrics/tether_trace.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace oxturn::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= text.size(); ++i)
    if (i == text.size() || text[i] == at) {
      parts.push_back(text.substr(from, i - from));
      from = i + 1;
    }
  return parts;
}

std::optional<double> to_number(std::string text) {
  if (!text.empty() && text.front() == '+') text.erase(0, 1);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc{} || at != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> to_seed(const std::string& digits) {
  std::uint64_t seed = 0;
  const char* end = digits.data() + digits.size();
  const auto [at, error] = std::from_chars(digits.data(), end, seed);
  if (digits.empty() || error != std::errc{} || at != end) return std::nullopt;
  return seed;
}

std::pair<std::string, std::string> assignment(const std::string& option, const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0)
    throw std::invalid_argument(fmt::format("{} {}: expected name=value", option, text));
  return {text.substr(0, at), text.substr(at + 1)};
}

Tether& tether_of(Robot& robot) { return robot.tether ? *robot.tether : robot.tether.emplace(); }
Lidar& lidar_of(Robot& robot) { return robot.lidar ? *robot.lidar : robot.lidar.emplace(); }

int whole_rays(double value) {
  if (value != std::floor(value) || value < 1 || value > 1e6)
    throw std::invalid_argument(
        fmt::format("--robot: lidar_rays is {}, expected a whole number from 1 to 1000000", value));
  return static_cast<int>(value);
}

struct RobotKey {
  const char* name;
  void (*set)(Robot&, double);
};
constexpr RobotKey kRobotKeys[] = {
    {"radius", [](Robot& r, double v) { r.radius = v; }},
    {"tool_width", [](Robot& r, double v) { r.tool_width = v; }},
    {"speed", [](Robot& r, double v) { r.speed = v; }},
    {"acceleration", [](Robot& r, double v) { r.acceleration = v; }},
    {"turn_rate", [](Robot& r, double v) { r.turn_rate = v; }},
    {"min_turn_radius", [](Robot& r, double v) { r.min_turn_radius = v; }},
    {"tether", [](Robot& r, double v) { tether_of(r).length = v; }},
    {"tether_reach", [](Robot& r, double v) { tether_of(r).reach = v; }},
    {"sharp_angle", [](Robot& r, double v) { tether_of(r).sharp_angle = v; }},
    {"lidar_range", [](Robot& r, double v) { lidar_of(r).range = v; }},
    {"lidar_rays", [](Robot& r, double v) { lidar_of(r).rays = whole_rays(v); }},
    {"lidar_noise", [](Robot& r, double v) { lidar_of(r).noise = v; }},
};

void change_robot(Robot& robot, const std::string& text) {
  std::vector<std::string> names{"name", "footprint"};
  for (const RobotKey& key : kRobotKeys) names.emplace_back(key.name);
  bool lengthened = false;
  for (const std::string& part : split(text, ',')) {
    const auto [name, value] = assignment("--robot", part);
    // Either way of saying how long takes the place of what the map's file says; both here are too many (check()).
    if (!lengthened && (name == "tether" || name == "tether_reach")) {
      lengthened = true;
      tether_of(robot).length = tether_of(robot).reach = 0;
    }
    if (name == "name") {
      robot.name = value;
      continue;
    }
    if (name == "footprint") {
      try {
        robot.footprint = value == "disc" ? Ring{} : named_footprint(value);
      } catch (const std::invalid_argument& e) {
        throw std::invalid_argument(fmt::format("--robot: {}, or disc", e.what()));
      }
      continue;
    }
    if (name == "radius") robot.footprint.clear();
    const RobotKey* found = nullptr;
    for (const RobotKey& key : kRobotKeys)
      if (name == key.name) found = &key;
    if (found == nullptr)
      throw std::invalid_argument(
          fmt::format("--robot: a robot has no '{}'; it has: {}", name, fmt::join(names, ", ")));
    const auto number = to_number(value);
    if (!number) throw std::invalid_argument(fmt::format("--robot: {} is '{}', expected a finite number", name, value));
    found->set(robot, *number);
  }
}

/// What an option says, else what the map's file does.
std::optional<Location> place_of(LocationKind of, const std::string& text, const std::optional<Point>& in_file) {
  if (text.empty()) return in_file ? std::optional<Location>({"", *in_file}) : std::nullopt;
  try {
    return parse_location(of, text);
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(fmt::format("--{}", e.what()));  // which begins with the option's name
  }
}

/// A file, or GENERATOR[:SEED].
MapFile load_map(const std::string& name, const ReadOptions& read) {
  if (file_exists(name)) return read_map(name, read);
  const std::size_t colon = name.rfind(':');
  const std::string generator = name.substr(0, colon);
  bool known = false;
  for (const GeneratorInfo& g : generators()) known = known || g.name == generator;
  // What looks like a file is taken for one, so that a mistyped file is reported as missing.
  if (!known && name.find_first_of("./\\") != std::string::npos) return read_map(name, read);
  std::uint64_t seed = 1;
  if (colon != std::string::npos) {
    const std::string digits = name.substr(colon + 1);
    const auto given = to_seed(digits);
    if (!given)
      throw std::invalid_argument(fmt::format("map '{}': seed is '{}', expected a whole number from 0", name, digits));
    seed = *given;
  }
  if (!known) {
    std::vector<std::string> names;
    for (const GeneratorInfo& g : generators()) names.push_back(g.name);
    throw std::invalid_argument(fmt::format("no file and no generator '{}'; did you mean '{}'? Generators: {}",
                                            generator, nearest_name(generator, names), fmt::join(names, ", ")));
  }
  return MapFile{generate(generator, {}, seed), {}, {}, {}, {}};
}

}  // namespace

void say(const std::string& sentence) { fmt::print(stderr, "oxturn: {}\n", sentence); }

bool file_exists(const std::string& name) {
  std::error_code error;
  return fs::exists(name, error);
}

bool has_suffix(const std::string& file, const std::string& suffix) {
  if (file.size() < suffix.size()) return false;
  for (std::size_t i = 0; i < suffix.size(); ++i) {
    const char c = file[file.size() - suffix.size() + i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != suffix[i]) return false;
  }
  return true;
}

void require_suffix(const std::string& file, const std::vector<std::string>& suffixes) {
  for (const std::string& s : suffixes)
    if (has_suffix(file, s)) return;
  throw std::invalid_argument(
      fmt::format("cannot write '{}': its name must end in {}", file, fmt::join(suffixes, " or ")));
}

void require_writable(const std::string& file) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("cannot write '{}': {}", file, why));
  };
  std::error_code error;
  if (file.empty() || fs::is_directory(file, error)) refuse("that is a folder, expected a file's name");
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {  // a device or pipe: written straight
    if (access(file.c_str(), W_OK) != 0) refuse(std::strerror(errno));
    return;
  }
  const fs::path parent = fs::path(file).has_parent_path() ? fs::path(file).parent_path() : fs::path(".");
  if (!fs::is_directory(parent, error)) refuse(fmt::format("there is no folder '{}'", parent.string()));
  std::string probe = (parent / ".oxturn-XXXXXX").string();
  const int handle = mkstemp(probe.data());
  if (handle < 0) refuse(std::strerror(errno));
  close(handle);
  unlink(probe.c_str());
}

CLI::Validator number_from(double least, bool included, const std::string& unit) {
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const auto value = to_number(text);
        if (value && (included ? *value >= least : *value > least)) return {};
        return fmt::format("is '{}', expected {}{} {:g}", text, unit, included ? " from" : " above", least);
      },
      "");
}

CLI::Validator whole_number() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        if (to_seed(text)) return {};
        return fmt::format("is '{}', expected a whole number from 0 to 18446744073709551615", text);
      },
      "");
}

void add_settings(CLI::App& app, std::vector<std::string>& assignments, const std::string& of_what) {
  app.add_option("--set", assignments, "parameter of the " + of_what + ", name=value (may be repeated)")
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("K=V");
}

Settings parse_settings(const std::string& owner, const std::vector<ParameterInfo>& parameters,
                        const std::vector<std::string>& assignments) {
  Settings settings;
  for (const std::string& text : assignments) {
    const auto [name, value] = assignment("--set", text);
    settings[name] = parse_value(owner, find_parameter(owner, parameters, name), value);
  }
  return settings;
}

void add_reader_options(CLI::App& app, ReadOptions& options) {
  app.add_option("--scale", options.metres_per_pixel, "metres per pixel of a plain image")
      ->check(number_from(0, false, "metres per pixel"))
      ->type_name("M");
  app.add_flag("--unknown-free", options.unknown_is_free, "images: unknown counts as free (otherwise as wall)");
  app.add_option("--drop-speckle", options.drop_speckle_m2, "images: drop obstacles up to this area")
      ->check(number_from(0, true, "square metres"))
      ->type_name("M2");
  app.add_option("--simplify", options.simplify_m, "images: fewer corners, walls may grow by this, never shrink")
      ->check(number_from(0, true, "metres"))
      ->type_name("M");
}

void say_remarks(const MapFile& file) {
  for (const std::string& remark : file.remarks) say(remark);
}

void add_problem_options(CLI::App& app, ProblemOptions& options) {
  app.add_option("--robot", options.robot,
                 "name, radius or footprint (square:WIDTH, octagon:WIDTH; disc: as its radius says), tool_width, "
                 "speed, acceleration, turn_rate, min_turn_radius, tether (metres) "
                 "or tether_reach (times the distance of the farthest place), sharp_angle (of the tether, radians), "
                 "lidar_range, lidar_rays, lidar_noise; those not given "
                 "stay as the map's file or the default has them")
      ->type_name("K=V,K=V...");
  app.add_option("--radius", options.radius, "robot's radius")->check(number_from(0, true, "metres"))->type_name("M");
  app.add_option("--tool-width", options.tool_width, "width that the robot covers")
      ->check(number_from(0, false, "metres"))
      ->type_name("M");
  app.add_option(
         "--start", options.start,
         "where the robot starts: X,Y, middle or corner (lower left); otherwise as the file says, or well inside")
      ->type_name("PLACE");
  app.add_option(
         "--anchor", options.anchor,
         "where the tether is fastened: X,Y, start, wall (the nearest place on one) or corner (the nearest in sight of "
         "the start); otherwise as the file says, or the start")
      ->type_name("PLACE");
  add_reader_options(app, options.read);
}

// Remarks come only when all is well: bad input gets its one sentence and nothing else.
Problem load_problem(const ProblemOptions& options) {
  MapFile file = load_map(options.map, options.read);
  Robot robot = file.robot.value_or(Robot{});
  if (!options.robot.empty()) change_robot(robot, options.robot);
  if (options.radius) {
    robot.radius = *options.radius;
    robot.footprint.clear();
  }
  if (options.tool_width) robot.tool_width = *options.tool_width;
  const bool robot_given = file.robot || !options.robot.empty() || (options.radius && options.tool_width);
  check(robot);
  const auto start = place_of(LocationKind::start, options.start, file.start);
  const auto anchor = place_of(LocationKind::anchor, options.anchor, file.anchor);
  const StartAndAnchor places = resolve(file.map, robot, start, anchor);
  Problem problem(std::move(file.map), robot, places.start, places.anchor);
  say_remarks(file);
  if (!robot_given)
    say(fmt::format("robot: radius {:g} m, tool width {:g} m (set with --radius and --tool-width)", robot.radius,
                    robot.tool_width));
  if (!start) say(fmt::format("start: {:.6g},{:.6g} (set with --start X,Y)", problem.start().x(), problem.start().y()));
  return problem;
}

void add_tethers_drawn(CLI::App& app, int& count) {
  app.add_option("--tethers", count, "how often a tether is drawn along the way, besides where it is longest; 0: never")
      ->check(CLI::Range(0, 1000))
      ->type_name("N");
}

void add_tether_trace(CLI::App& app, std::string& file) {
  app.add_option("--tether-trace", file, "write the tether's length, bends and angle along the path, FILE.csv")
      ->type_name("FILE");
}

void check_tether_trace(const std::string& file) {
  if (file.empty()) return;
  require_suffix(file, {".csv"});
  require_writable(file);
}

void check_tether_trace(const std::string& file, const Robot& robot) {
  if (!file.empty() && !robot.tether)
    throw std::invalid_argument(
        fmt::format("--tether-trace: robot '{}' has no tether; give it one with --robot tether=METRES", robot.name));
}

void write_tether_trace(const std::string& file, const Problem& problem, const Path& path) {
  if (!file.empty()) write_file(file, to_csv(tether_trace(problem, path, problem.robot().tool_width)));
}

}  // namespace oxturn::cli

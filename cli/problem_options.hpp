/// Which problem a command is about: map, robot, start and anchor.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>

#include "bench/registry.hpp"
#include "maps/map_source.hpp"

namespace oxturn::cli {

/// Options of a reader, by parameter: `--drop-speckle 0.02` for drop_speckle, flags for those that are true or false.
using ReaderOptions = std::map<std::string, std::string>;
/// One option for each parameter of any format's reader.
void add_reader_options(CLI::App& app, const MapFormats& formats, ReaderOptions& options);
Settings reader_settings(const ReaderOptions& options, const MapFormats& formats);

/// Prints each of the reader's remarks on standard error.
void say_remarks(const MapFile& file);

inline constexpr const char* kMapHelp =
    "a map file (`oxturn list formats`; - is standard input, GeoJSON) or GENERATOR[:SEED][,K=V...], such as "
    "rooms:7,width=20 (`oxturn list maps`)";

/// --target FILE.
void add_target_option(CLI::App& app, std::string& file);

struct ProblemOptions {
  std::string map;     // a file, or GENERATOR[:SEED][,K=V...]; empty: not given
  std::string target;  // a map file whose free space is the target area; empty: as the map says
  ReaderOptions read;
  std::string robot;  // "radius=0.2,speed=1"
  std::optional<double> radius, tool_width;
  std::string start, anchor;  // "X,Y" or a name (maps/locations.hpp)
};
/// MAP itself is declared by the command, since its position among the arguments differs.
void add_problem_options(CLI::App& app, const Registry& registry, ProblemOptions& options);
/// MAP and the options of its reader. Throws for a name that is neither a file nor a generator.
MapSource map_source(const ProblemOptions& options, const Registry& registry);
/// The robot as the options change it; not checked.
Robot robot_with(const ProblemOptions& options, Robot robot);
/// Options take precedence over what the file says. What neither gives (robot, start) is chosen and said on standard
/// error.
Problem make_problem(const ProblemOptions& options, MapFile file);

}  // namespace oxturn::cli

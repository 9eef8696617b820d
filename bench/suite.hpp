/// A suite: planners x parameters x maps x robots x seeds x repeats, read from TOML.
///
///   const Suite suite = read_suite("bench/suites/quick.toml", built_in_registry());
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/child_process.hpp"
#include "bench/registry.hpp"
#include "maps/formats.hpp"
#include "maps/locations.hpp"
#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// One map of a suite: a generator with settings and seed, not yet made, or a file, read once when the suite is
/// (so that a bad file is a sentence at the start and not a row in the night). A robot that the file names is
/// not used: the suite's robots are.
struct MapSpec {
  std::string name;       // unique within the suite: "rooms-7", "rooms-7[rooms=9]" where several would be called so
  std::string generator;  // empty: a file
  Settings settings;
  std::uint64_t seed = 1;
  std::string file;
  Settings read;                           // of the file's reader
  std::string target;                      // file of the target area; empty: the map's own
  std::optional<Region> target_area;       // what that file describes
  std::optional<Location> start, anchor;   // empty: the file's, or the problem's default
  std::shared_ptr<const MapFile> content;  // of `file`; nullptr: reading it broke a limit, and will again
};
struct PlannerSpec {
  std::string name;
  Settings settings;  // only what differs from the defaults
  /// On a tethered robot the planner is given the problem as if there were no tether, and its path is scored as driven:
  /// the tether is measured and does not make it invalid. For planners without the capability `tether` only.
  bool ignore_tether = false;
  Settings said() const;        // the settings and, if it is true, ignore_tether: what tells variants apart
  std::string variant() const;  // "zigzag" or "zigzag[partition=monotone]"
};
struct Suite {
  std::string file;  // as given; empty for one made in a program
  std::string name;
  std::uint64_t seed = 1;
  int repeats = 1;
  int warm_ups = 0;  // calls of plan() before the one that is measured, in the same process
  double target_coverage = 0.99;
  bool scoring = true;  // false: paths are neither scored nor stored, for the time and memory of planning alone
  Limits limits;
  std::vector<Robot> robots;
  std::vector<MapSpec> maps;
  std::vector<PlannerSpec> planners;
  std::vector<PlannerInfo> programs;  // external planners that the suite names by `exec`
};

/// Any value may be a list, and lists multiply; "*" names every planner (with ignore_tether: those that have the
/// capability `tether` run as always). Everything is checked here: names
/// against `planners` and the generators, parameters, types, files. Throws std::invalid_argument
/// "quick.toml:12: ..." for each kind of mistake. File patterns are relative to the suite's folder, and in it commands
/// of external planners are started, here for their descriptions.
Suite read_suite(const std::string& file, const Registry& registry);

/// How many runs the suite has.
std::size_t run_count(const Suite& suite);

/// Gives a name to every map that has none. Throws std::invalid_argument if a map is listed twice.
void name_maps(std::vector<MapSpec>& maps);

}  // namespace oxturn

/// Paths as files: GeoJSON FeatureCollections of LineStrings with the property `tool`, in driving order; or CSV with
/// the columns x, y and (if given) tool.
///
///   const PathFile file = read_path_file("plan.geojson");
///   write_file("copy.geojson", to_geojson(file.path));
#pragma once

#include <optional>
#include <string>

#include "geometry/path.hpp"
#include "maps/map_source.hpp"

namespace oxturn {

/// The problem that a path was made for, so that it can be scored by its file alone.
struct PathProblem {
  MapSource source;  // names of files are relative to the folder of the path's file
  std::string map_sha256;
  Robot robot;
  Point start{0, 0}, anchor{0, 0};
};
PathProblem path_problem(const Problem& problem, MapSource source);

struct PathFile {
  Path path;
  std::optional<PathProblem> problem;  // if the file names it
};

/// Coordinates in metres, shortest round-trip numbers. `problem` becomes a member of that name (RFC 7946, section 6.1).
std::string to_geojson(const Path& path, const PathProblem* problem = nullptr);
/// The same from what that gives without a problem.
std::string with_problem(std::string path, const PathProblem& problem);

/// The format is told by the suffix (.csv, .geojson, .json), otherwise by the first byte that is not blank. A million
/// points a second or so. Throws std::invalid_argument that names the file and the feature, or line and column.
PathFile read_path_file(const std::string& file);
inline Path read_path(const std::string& file) { return read_path_file(file).path; }
/// `source` is named in messages.
PathFile path_from_geojson(const std::string& text, const std::string& source);
Path path_from_csv(const std::string& text, const std::string& source);

/// The map, robot, start and anchor that `problem` names, read or made again. `path_file`: in which it was found.
/// Throws std::invalid_argument if the map is not there or is another one.
MapFile load_map(const PathProblem& problem, const std::string& path_file, const Generators& generators,
                 const MapFormats& formats);

}  // namespace oxturn

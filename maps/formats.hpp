// Files in and out. Readers and writers are listed in maps/formats/formats.cpp and nowhere else.
//
// All readers throw std::invalid_argument with "FILE[:LINE]: what is wrong, what was expected". Writers write to
// a temporary file beside the target and rename it, so nothing half-written is ever left; they throw
// std::runtime_error("cannot write 'out/x.svg': Permission denied").
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "maps/map.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct ReadOptions {
  double metres_per_pixel = 0;   // plain images; 0: not given
  bool unknown_is_free = false;  // rasters: unknown counts as wall unless told otherwise
  double drop_speckle_m2 = 0;    // rasters: obstacles up to this area are dropped (and said); 0: none
  double simplify_m = 0;         // rasters: simplify_inward with this tolerance; 0: exact cell boundaries
};

/// What a file holds: the map, and whatever else of a problem it says.
struct MapFile {
  Map map;
  std::optional<Point> start, anchor;
  std::optional<Robot> robot;
  std::vector<std::string> remarks;  // what the reader did that the user should know, one sentence each
};

struct MapFormat {
  std::string name;  // "ros", "geojson"
  std::string title;
  std::vector<std::string> suffixes;  // ".yaml", ...
  std::function<MapFile(const std::string& file, const ReadOptions&)> read;
};
const std::vector<MapFormat>& map_formats();

/// By the file's suffix. Throws for a missing file, an unknown suffix (with the list), or bad content.
MapFile read_map(const std::string& file, const ReadOptions& options = {});

/// GeoJSON Feature with name, start, anchor, robot, source (design.md section 5).
std::string to_geojson(const Problem& problem);
std::string to_geojson(const MapFile& map);
/// FeatureCollection of LineStrings with `tool`, in driving order. Shortest round-trip numbers.
std::string to_geojson(const Path& path);
/// Reads what the line above writes; throws std::invalid_argument naming `source` (a file's name) and feature.
Path path_from_geojson(const std::string& text, const std::string& source);
Path read_path(const std::string& file);

/// Shortest decimal that reads back as the same double.
std::string to_decimal(double value);
void write_file(const std::string& file, const std::string& content);
/// Whole file; throws std::invalid_argument "no such file: 'x'" or why it cannot be read.
std::string read_file(const std::string& file);

// --- pictures --------------------------------------------------------------------------------------------

/// A named picture of a planner's inside (cells, tree, partition).
struct Trace {
  std::string name;
  std::vector<Polyline> lines;  // closed ones repeat their first point
};

struct PictureOptions {
  double width_px = 1000;
  bool swath = true;                           // draws the tool's swath under the path
  const std::vector<Trace>* traces = nullptr;  // each in a colour of its own, by their order
  // Robots with a tether: it is drawn so often, equally spaced along the way, and where it is longest; 0: not at all.
  int tethers = 8;
};
/// SVG of a problem and (if given) a path: walls, target, path coloured by time from blue to red, transit
/// dashed, start and a tether's anchor marked. Long paths are drawn in at most a few thousand coloured pieces.
std::string to_svg(const Problem& problem, const Path* path, const PictureOptions& options = {});

}  // namespace oxturn

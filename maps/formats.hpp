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

}  // namespace oxturn

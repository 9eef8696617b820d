// What the readers of maps/formats/ share among themselves. Not installed.
#pragma once

#include <string>
#include <vector>

#include "geometry/raster.hpp"
#include "maps/formats.hpp"

namespace oxturn {

/// A picture as map_server sees it: the mean of red, green and blue, 0 (black) to 255. Row 0 is the top.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<float> grey;
  std::vector<std::uint8_t> alpha;  // 255: opaque; empty: all opaque
};
/// PNG (1 to 16 bit, grey, palette, colour, alpha; gamma is not applied) or PGM (P2, P5), told by the first bytes.
/// Throws std::invalid_argument "FILE: what is wrong".
GreyImage read_image(const std::string& file);

/// Where pixel corners lie: origin + rotated(pixel * resolution, yaw), the origin being the lower left corner.
struct Placement {
  Point origin{0, 0};
  double yaw = 0;
  double resolution = 1;  // metres per pixel
};
enum class Occupancy : std::uint8_t { free, occupied, unknown };
/// Cells (row 0 at the bottom) to a map: unknown by option, speckle dropped, traced, simplified. O(cells).
MapFile map_from_cells(const std::string& file, int columns, int rows, std::vector<Occupancy> cells,
                       const Placement& placement, const ReadOptions& options);

MapFile read_ros(const std::string& file, const ReadOptions& options);
MapFile read_plain_image(const std::string& file, const ReadOptions& options);
MapFile read_geojson(const std::string& file, const ReadOptions& options);

/// "dir/kitchen.yaml" -> "kitchen".
std::string stem_of(const std::string& file);

}  // namespace oxturn

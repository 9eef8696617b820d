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
/// What readers of rasters have in common.
struct RasterOptions {
  bool unknown_free = false;  // unknown counts as wall unless told otherwise
  double drop_speckle = 0;    // square metres
  double simplify = 0;        // metres
};
/// Their description, for a reader's own options P that derive from them.
template <class P>
std::vector<Parameter<P>> with_raster_options(std::vector<Parameter<P>> own) {
  own.push_back({"unknown_free", &P::unknown_free, "unknown counts as free (otherwise as wall)"});
  own.push_back({"drop_speckle", &P::drop_speckle, Range{0, 1e9},
                 "square metres: obstacles up to this area are dropped; 0: none"});
  own.push_back({"simplify", &P::simplify, Range{0, 1e9},
                 "metres: fewer vertices; walls may grow by this, never shrink; 0: exact cell boundaries"});
  return own;
}
/// Cells (row 0 at the bottom) to a map: unknown by option, speckle dropped, traced, simplified. O(cells).
MapFile map_from_cells(const std::string& file, int columns, int rows, std::vector<Occupancy> cells,
                       const Placement& placement, const RasterOptions& options);

/// "dir/kitchen.yaml" -> "kitchen".
std::string stem_of(const std::string& file);

}  // namespace oxturn

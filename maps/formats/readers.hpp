/// Common parts of the map readers. Private to maps/formats.
///
///   const GreyImage image = read_image("kitchen.png");
///   OccupancyGrid grid(image.width, image.height);
///   grid.at(column, row_from_the_top) = Occupancy::free;
///   return map_from_grid(file, grid, placement, options);
#pragma once

#include <cstdint>

#include "base/throw_invalid.hpp"
#include "geometry/raster.hpp"
#include "maps/formats.hpp"

namespace oxturn {

/// An image as map_server sees it: the mean of red, green and blue, from 0 (black) to 255. Row 0 is the top.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<float> grey;
  std::vector<std::uint8_t> alpha;  // 255: opaque; empty: all opaque
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};
/// PNG (1 to 16 bit, grey, palette, colour, alpha; gamma is ignored) or PGM (P2, P5), told apart by the first bytes.
/// Throws std::invalid_argument "FILE: what is wrong".
GreyImage read_image(const std::string& file);

// The parts of read_image, with the file's content. `file` is named in messages.
bool is_png(const std::string& bytes);
GreyImage read_png(const std::string& file, const std::string& bytes);
GreyImage read_pgm(const std::string& file, const std::string& bytes);
/// Throws for images that are empty or have more than 10^8 pixels.
void check_image_size(const std::string& file, double width, double height);

enum class Occupancy : std::uint8_t { free, occupied, unknown };
struct OccupancyGrid {
  int columns, rows;
  std::vector<Occupancy> cells;  // row 0 at the bottom
  OccupancyGrid(int c, int r)
      : columns(c), rows(r), cells(static_cast<std::size_t>(c) * static_cast<std::size_t>(r), Occupancy::unknown) {}
  /// `row` is counted from the top, as in images.
  Occupancy& at(int column, int row) {
    return cells[static_cast<std::size_t>(rows - 1 - row) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(column)];
  }
};

/// Positions of pixel corners: origin + rotated(pixel * resolution, yaw). The origin is the lower left corner.
struct Placement {
  Point origin{0, 0};
  double yaw = 0;         // radians
  double resolution = 1;  // metres per pixel
};

/// The options of all raster readers.
struct RasterOptions {
  bool unknown_free = false;  // else unknown cells count as wall
  double drop_speckle = 0;    // square metres
  double simplify = 0;        // metres
};
/// Their description, after a reader's own options; P derives from RasterOptions.
template <class P>
std::vector<Parameter<P>> with_raster_options(std::vector<Parameter<P>> own) {
  own.push_back({"unknown_free", &P::unknown_free, "unknown counts as free (otherwise as wall)"});
  own.push_back({"drop_speckle", &P::drop_speckle, Range{0, 1e9},
                 "square metres: obstacles up to this area are dropped; 0: none"});
  own.push_back({"simplify", &P::simplify, Range{0, 1e9},
                 "metres: fewer vertices; walls may grow by this, never shrink; 0: exact cell boundaries"});
  return own;
}
/// A map from cells: unknown cells by option, speckle dropped, traced, simplified. O(cells). Throws
/// std::invalid_argument if nothing is free.
MapFile map_from_grid(const std::string& file, const OccupancyGrid& cells, const Placement& placement,
                      const RasterOptions& options);

/// The region in canonical form; what changed becomes a remark. Throws std::invalid_argument "FILE: what is wrong" if
/// it cannot be repaired or has no area.
Region repaired_region(const Region& written, const std::string& file, std::vector<std::string>& remarks);

/// "dir/kitchen.yaml" -> "kitchen".
std::string stem_of(const std::string& file);

}  // namespace oxturn

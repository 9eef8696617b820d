// Cells of a raster to a map: the part that ROS maps and plain pictures share.
//
// Decisions  1. Free space is 4-connected, walls 8-connected (trace). The picture's outside is wall.
//            2. A speck is an 8-connected set of cells that are not free and does not reach the picture's border.
//            3. Tracing and simplifying happen in whole pixels; each corner is then placed by one multiplication and
//               one addition, so equal corners stay equal and nothing adds up along a row.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {
namespace {

struct Dropped {
  std::size_t specks = 0, cells = 0;
};

/// Frees every speck of at most `most` cells.
Dropped drop_specks(BitGrid& free, double most) {
  Dropped dropped;
  std::vector<std::uint8_t> seen(free.bits.size(), 0);
  std::vector<std::pair<int, int>> speck;
  for (int j = 0; j < free.rows; ++j)
    for (int i = 0; i < free.columns; ++i) {
      if (free.get(i, j) || seen[free.at(i, j)]) continue;
      bool border = false;
      speck.assign(1, {i, j});
      seen[free.at(i, j)] = 1;
      for (std::size_t k = 0; k < speck.size(); ++k) {
        const auto [x, y] = speck[k];
        border = border || x == 0 || y == 0 || x == free.columns - 1 || y == free.rows - 1;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const int u = x + dx, v = y + dy;
            if (!free.inside(u, v) || free.get(u, v) || seen[free.at(u, v)]) continue;
            seen[free.at(u, v)] = 1;
            speck.emplace_back(u, v);
          }
      }
      if (border || static_cast<double>(speck.size()) > most) continue;
      for (const auto& [x, y] : speck) free.set(x, y, true);
      ++dropped.specks;
      dropped.cells += speck.size();
    }
  return dropped;
}

}  // namespace

MapFile map_from_cells(const std::string& file, int columns, int rows, std::vector<Occupancy> cells,
                       const Placement& placement, const RasterOptions& options) {
  MapFile result;
  BitGrid free({0, 0}, 1, columns, rows);
  std::size_t occupied = 0, unknown = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    occupied += cells[k] == Occupancy::occupied ? 1 : 0;
    unknown += cells[k] == Occupancy::unknown ? 1 : 0;
    free.bits[k] = cells[k] == Occupancy::free || (options.unknown_free && cells[k] == Occupancy::unknown) ? 1 : 0;
  }
  if (free.count() == 0)
    throw std::invalid_argument(
        fmt::format("{}: no cell is free ({} occupied, {} unknown); are negate and the thresholds right?", file,
                    occupied, unknown));
  if (unknown > 0)
    result.remarks.push_back(
        fmt::format("{} cells are unknown and count as {}", unknown, options.unknown_free ? "free" : "wall"));
  const double cell_area = placement.resolution * placement.resolution;
  if (options.drop_speckle > 0) {
    // The allowance keeps an area given as exactly n cells at n cells.
    const Dropped dropped = drop_specks(free, options.drop_speckle / cell_area * (1 + 1e-9));
    result.remarks.push_back(fmt::format("{} specks of at most {} m2 dropped ({} cells)", dropped.specks,
                                         to_decimal(options.drop_speckle), dropped.cells));
  }
  Region region = trace(free);
  if (options.simplify > 0) {
    const std::size_t corners = vertex_count(region);
    region = simplify_inward(region, options.simplify / placement.resolution);
    result.remarks.push_back(fmt::format("{} corners simplified to {}", corners, vertex_count(region)));
    if (region.empty())
      throw std::invalid_argument(
          fmt::format("{}: nothing is left when simplified by {} m, give less", file, to_decimal(options.simplify)));
  }
  const auto place = [&](Ring& ring) {
    for (Point& p : ring) {
      const Point metres = p * placement.resolution;
      p = placement.origin + (placement.yaw == 0 ? metres : rotated(metres, placement.yaw));
    }
  };
  for (Polygon& polygon : region.polygons) {
    place(polygon.outer);
    for (Ring& hole : polygon.holes) place(hole);
  }
  result.map = {stem_of(file), std::move(region), "file", file};
  return result;
}

}  // namespace oxturn

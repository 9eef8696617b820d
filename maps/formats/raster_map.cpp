// From the cells of a raster to a map: the common part of ROS maps and plain images.
//
// Decisions  1. Free space is 4-connected, walls are 8-connected (see trace). Outside of the image is wall.
//            2. A speck is an 8-connected set of cells that are not free and do not touch the border of the image.
//            3. Tracing and simplifying use whole pixels. Each vertex is then placed by one multiplication and one
//               addition, so equal vertices stay equal and no error accumulates along a row.
#include <fmt/format.h>

#include <algorithm>

#include "base/graph_search.hpp"
#include "base/text.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {
namespace {

constexpr double kRounding = 1 + 1e-9;  // keeps an area given as exactly n cells at n cells

struct Dropped {
  std::size_t specks = 0, cells = 0;
};

struct CellIndex {
  int i, j;
};

/// Makes every speck of at most `most` cells free.
Dropped drop_specks(BitGrid& free, double most) {
  Dropped dropped;
  std::vector<bool> seen(free.bits.size(), false);
  std::vector<CellIndex> speck;
  const auto touches_border = [&](const CellIndex& c) {
    return c.i == 0 || c.j == 0 || c.i == free.columns - 1 || c.j == free.rows - 1;
  };
  const auto expand = [&](const CellIndex& c, auto reach) {
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) {
        const CellIndex n{c.i + di, c.j + dj};
        if (!free.inside(n.i, n.j) || free.get(n.i, n.j) || seen[free.at(n.i, n.j)]) continue;
        seen[free.at(n.i, n.j)] = true;
        reach(n);
      }
  };
  for (int j = 0; j < free.rows; ++j)
    for (int i = 0; i < free.columns; ++i) {
      if (free.get(i, j) || seen[free.at(i, j)]) continue;
      speck.assign(1, {i, j});
      seen[free.at(i, j)] = true;
      breadth_first(speck, expand);
      if (static_cast<double>(speck.size()) > most || std::any_of(speck.begin(), speck.end(), touches_border)) continue;
      for (const CellIndex& c : speck) free.set(c.i, c.j, true);
      ++dropped.specks;
      dropped.cells += speck.size();
    }
  return dropped;
}

/// The free cells; unknown ones by option, with a remark.
BitGrid free_cells(const std::string& file, const OccupancyGrid& grid, bool unknown_free,
                   std::vector<std::string>& remarks) {
  BitGrid free({0, 0}, 1, grid.columns, grid.rows);
  std::size_t occupied = 0, unknown = 0;
  for (std::size_t k = 0; k < grid.cells.size(); ++k) {
    const Occupancy cell = grid.cells[k];
    occupied += cell == Occupancy::occupied ? 1 : 0;
    unknown += cell == Occupancy::unknown ? 1 : 0;
    free.bits[k] = cell == Occupancy::free || (unknown_free && cell == Occupancy::unknown) ? 1 : 0;
  }
  if (free.count() == 0)
    throw_invalid("{}: no cell is free ({} occupied, {} unknown); are negate and the thresholds right?", file, occupied,
                  unknown);
  if (unknown > 0)
    remarks.push_back(fmt::format("{} cells are unknown and count as {}", unknown, unknown_free ? "free" : "wall"));
  return free;
}

Region simplified(const std::string& file, const Region& region, double metres, double resolution,
                  std::vector<std::string>& remarks) {
  Region simple = simplify_inward(region, metres / resolution);
  remarks.push_back(fmt::format("{} vertices simplified to {}", vertex_count(region), vertex_count(simple)));
  if (simple.empty()) throw_invalid("{}: nothing is left when simplified by {} m, give less", file, to_decimal(metres));
  return simple;
}

/// From pixels to metres.
void to_metres(Region& region, const Placement& placement) {
  for_each_ring(region, [&](Ring& ring) {
    for (Point& p : ring) {
      const Point metres = p * placement.resolution;
      p = placement.origin + (placement.yaw == 0 ? metres : rotated(metres, placement.yaw));
    }
  });
}

}  // namespace

MapFile map_from_grid(const std::string& file, const OccupancyGrid& cells, const Placement& placement,
                      const RasterOptions& options) {
  MapFile result;
  BitGrid free = free_cells(file, cells, options.unknown_free, result.remarks);
  if (options.drop_speckle > 0) {
    const double cell_area = placement.resolution * placement.resolution;
    const Dropped dropped = drop_specks(free, options.drop_speckle / cell_area * kRounding);
    result.remarks.push_back(fmt::format("{} specks of at most {} m2 dropped ({} cells)", dropped.specks,
                                         to_decimal(options.drop_speckle), dropped.cells));
  }
  Region region = trace(free);
  if (options.simplify > 0) region = simplified(file, region, options.simplify, placement.resolution, result.remarks);
  to_metres(region, placement);
  result.map = {stem_of(file), std::move(region), "file", file};
  return result;
}

}  // namespace oxturn

// A floor of square cells, some of them blocked at random: very many small obstacles, most of them a cell apart. What a
// traced occupancy grid looks like at its worst, and the hardest map for anything that triangulates. O(cells).
//
// Decisions   1. Cells that no row of free cells connects by their sides to most of the floor are blocked as well.
#include <algorithm>
#include <cmath>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  double cell = 0;
  double blocked = 0.1;
};

constexpr double kMostCells = 2e7;

Region make(const Params& p, Rng& rng) {
  const double cell = passage_width("cell", p.cell, p.passage, p);
  const double columns = std::floor(p.width / cell), rows = std::floor(p.height / cell);
  if (columns < 1 || rows < 1)
    throw_invalid("cell is {:.4g} m, expected no more than the size, {:.4g} x {:.4g} m", cell, p.width, p.height);
  if (columns * rows > kMostCells)
    throw_invalid(
        "{:.4g} x {:.4g} m have {:.4g} cells, expected no more than 2 * 10^7; take larger cells or a smaller size",
        p.width, p.height, columns * rows);
  BitGrid grid({0, 0}, 1, static_cast<int>(columns), static_cast<int>(rows));
  for (auto& bit : grid.bits) bit = rng.chance(p.blocked) ? 0 : 1;
  if (grid.count() == 0) grid.bits[0] = 1;
  Region floor = traced(grid, p);
  const auto largest = std::max_element(floor.polygons.begin(), floor.polygons.end(),
                                        [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  return {{std::move(*largest)}};
}

}  // namespace

GeneratorInfo speckle() {
  return describe_site<Params>(
      "speckle", "a floor speckled with small obstacles",
      "square obstacles; free cells at least `passage` robot diameters wide, connected by their sides",
      {{"cell", &Params::cell, Range{0, 10000}, "metres, side of a cell, at least; 0: the narrowest passage"},
       {"blocked", &Params::blocked, Range{0, 0.35}, "share of cells that are blocked"}},
      make);
}

}  // namespace oxturn::generator

// A rectangular maze by the growing-tree method: one spanning tree of corridors, then random loops.
//
// Source      growing tree: Buck, Mazes for Programmers, 2015 (newest cell: depth-first; random cell: Prim)
// Complexity  O(cells)
// Decisions   1. Corridors are widened a little so that a whole number of them fills the size exactly.
//             2. Drawn on a lattice of corridor and wall bands and traced, so walls are exact.
#include <array>
#include <cmath>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  double corridor = 0;
  double wall = 0.2;
  double loops = 0.05;
  double branching = 0.1;
};

constexpr double kMostCells = 4e6;

/// Coordinates of the lattice lines: corridor, wall, corridor, ..., corridor.
std::vector<double> bands(int cells, double size, double wall) {
  const double corridor = (size - (cells - 1) * wall) / cells;
  std::vector<double> lines;
  for (int i = 0; i < cells; ++i) {
    lines.push_back(i * (corridor + wall));
    lines.push_back(i + 1 == cells ? size : i * (corridor + wall) + corridor);
  }
  return lines;
}

/// Cell (i, j) is bit (2i, 2j); the bit between two cells is the wall between them.
BitGrid grown(int columns, int rows, const Params& p, Rng& rng) {
  BitGrid grid({0, 0}, 1, 2 * columns - 1, 2 * rows - 1);
  struct Cell {
    int i, j;
  };
  constexpr std::array<Cell, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::vector<Cell> active{{rng.between(0, columns - 1), rng.between(0, rows - 1)}};
  grid.set(2 * active[0].i, 2 * active[0].j, true);
  while (!active.empty()) {
    if (rng.chance(p.branching)) std::swap(active.back(), active[rng.below(active.size())]);
    const Cell cell = active.back();
    std::array<Cell, 4> open{};
    std::size_t count = 0;
    for (const Cell& s : kSteps) {
      const int i = cell.i + s.i, j = cell.j + s.j;
      if (i >= 0 && j >= 0 && i < columns && j < rows && !grid.get(2 * i, 2 * j)) open[count++] = s;
    }
    if (count == 0) {
      active.pop_back();
      continue;
    }
    const Cell s = open[rng.below(count)];
    grid.set(2 * cell.i + s.i, 2 * cell.j + s.j, true);
    grid.set(2 * (cell.i + s.i), 2 * (cell.j + s.j), true);
    active.push_back({cell.i + s.i, cell.j + s.j});
  }
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      if ((i + j) % 2 == 1 && !grid.get(i, j) && rng.chance(p.loops)) grid.set(i, j, true);
  return grid;
}

Region make(const Params& p, Rng& rng) {
  const double corridor = passage_width("corridor", p.corridor, 2.5, p);
  const double across = std::floor((p.width + p.wall) / (corridor + p.wall));
  const double up = std::floor((p.height + p.wall) / (corridor + p.wall));
  if (across < 1 || up < 1)
    throw_invalid("corridor is {:.4g} m, expected no more than the size, {:.4g} x {:.4g} m", corridor, p.width,
                  p.height);
  if (across * up > kMostCells)
    throw_invalid(
        "{:.4g} x {:.4g} m have {:.4g} cells, expected no more than 4000000; take a wider corridor or a "
        "smaller size",
        p.width, p.height, across * up);
  const int columns = static_cast<int>(across), rows = static_cast<int>(up);
  return traced(grown(columns, rows, p, rng), bands(columns, p.width, p.wall), bands(rows, p.height, p.wall));
}

}  // namespace

GeneratorInfo maze() {
  return describe_site<Params>(
      "maze", "a maze of corridors",
      "every cell reached, by a single path if loops is 0; corridors at least `passage` robot diameters wide",
      {{"corridor", &Params::corridor, Range{0, 10000}, "metres, at least; 0: 2.5 robot diameters"},
       {"wall", &Params::wall, Range{0.001, 10000}, "metres; thickness of walls"},
       {"loops", &Params::loops, Range{0, 1}, "probability that a wall that the tree left closed is opened"},
       {"branching", &Params::branching, Range{0, 1}, "0: long winding corridors; 1: many short dead ends"}},
      make);
}

}  // namespace oxturn::generator

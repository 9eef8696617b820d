// A random polyomino, orthogonal or octagonal polygon to be mown: the target area, within a larger free space.
//
// Source      the kinds of instances of Fekete, Krupke, Perk, Rieck, Scheffer, "The Lawn Mowing Problem: From Algebra
//             to Algorithms", ESA 2023
// Method      A polyomino grows cell by cell, each taken at random among those beside it. An orthogonal polygon is one
//             on unequal grid lines; an octagonal one has some of its corners cut at 45 degrees. Scaled to the area.
// Guarantee   The target area is a simple polygon: a cell is added only if the set cells around it are one run, so
//             the polygon neither encloses a hole nor touches itself. Free space is its bounding box grown by
//             `margin`; with margin 0 it is the polygon itself, and all of it is to be covered (milling).
// Complexity  O(squares)
// Decisions   1. Cuts are at most 0.45 of the narrowest distance of grid lines, so that no two of them meet.
//             2. Orthogonal and octagonal polygons have a cell for every three tool squares: arms of one to three.
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/raster.hpp"
#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

enum class Kind { polyomino, orthogonal, octagonal };

struct Params {
  Kind kind = Kind::polyomino;
  int squares = 60;
  double tool = 0.4, margin = 1.5;
};

constexpr double kSquaresPerCell = 3;
constexpr double kNarrowest = 0.6, kWidest = 1.8;  // distance of unequal grid lines, in cells
constexpr double kCutCorners = 0.6, kMostCut = 0.45;
constexpr double kGrid = 1.0 / 65536;  // metres

/// Beside a cell, counter-clockwise; those with even numbers share an edge with it.
constexpr std::array<std::array<int, 2>, 8> kAround{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// Are the set cells around the cell one run that shares an edge with it?
bool keeps_simple(const BitGrid& grid, int i, int j) {
  int changes = 0;
  bool beside = false;
  for (std::size_t k = 0; k < 8; ++k) {
    const auto set = [&](std::size_t n) { return grid.get(i + kAround[n % 8][0], j + kAround[n % 8][1]); };
    if (set(k) != set(k + 1)) ++changes;
    if (k % 2 == 0 && set(k)) beside = true;
  }
  return beside && changes == 2;
}

BitGrid grown(int cells, Rng& rng) {
  const int side = 2 * static_cast<int>(std::ceil(std::sqrt(static_cast<double>(cells)))) + 3;
  BitGrid grid({0, 0}, 1, side, side);
  std::vector<std::array<int, 2>> frontier;
  const auto add = [&](int i, int j) {
    grid.set(i, j, true);
    for (std::size_t k = 0; k < 8; k += 2) {
      const int x = i + kAround[k][0], y = j + kAround[k][1];
      if (grid.inside(x, y) && !grid.get(x, y)) frontier.push_back({x, y});
    }
  };
  add(side / 2, side / 2);
  // A cell that is turned down comes back to the frontier when another one beside it is added.
  for (int left = cells - 1; left > 0 && !frontier.empty();) {
    const std::size_t k = rng.below(frontier.size());
    const auto [i, j] = frontier[k];
    frontier[k] = frontier.back();
    frontier.pop_back();
    if (grid.get(i, j) || !keeps_simple(grid, i, j)) continue;
    add(i, j);
    --left;
  }
  return grid;
}

std::vector<double> grid_lines(int cells, bool equal, Rng& rng) {
  std::vector<double> lines{0};
  for (int k = 0; k < cells; ++k) lines.push_back(lines.back() + (equal ? 1 : rng.between(kNarrowest, kWidest)));
  return lines;
}

Ring with_cut_corners(const Ring& ring, Rng& rng) {
  Ring cut;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &before = ring[(i + ring.size() - 1) % ring.size()], &at = ring[i],
                &after = ring[(i + 1) % ring.size()];
    if (!rng.chance(kCutCorners)) {
      cut.push_back(at);
      continue;
    }
    const double by = rng.between(0.3, 1.0) * kMostCut * kNarrowest;
    cut.push_back(at + by * (before - at) / distance(at, before));
    cut.push_back(at + by * (after - at) / distance(at, after));
  }
  return cut;
}

Site make(const Params& p, Rng& rng) {
  const bool lattice = p.kind == Kind::polyomino;
  const int cells = lattice ? p.squares : std::max(4, static_cast<int>(p.squares / kSquaresPerCell));
  const BitGrid grid = grown(cells, rng);
  const std::vector<double> xs = grid_lines(grid.columns, lattice, rng), ys = grid_lines(grid.rows, lattice, rng);
  Ring ring = traced(grid, xs, ys).polygons.front().outer;
  if (p.kind == Kind::octagonal) ring = with_cut_corners(ring, rng);
  const double scale = p.tool * std::sqrt(p.squares / signed_area(ring)), margin = p.margin * p.tool;
  const Point low = bounding_box(ring).low;
  for (Point& q : ring) {
    q = scale * (q - low) + Point(margin, margin);
    q = {std::floor(q.x() / kGrid + 0.5) * kGrid, std::floor(q.y() / kGrid + 0.5) * kGrid};
  }
  Region target{{{std::move(ring), {}}}};
  if (p.margin <= 0) return target;
  const Point high = bounding_box(target).high + Point(margin, margin);
  return {box_region({0, 0}, high), std::move(target)};
}

}  // namespace

GeneratorInfo polyomino() {
  return describe_generator<Params>(
      "polyomino", "a lawn to be mown: a polyomino, orthogonal or octagonal polygon within a larger free space",
      "the target area is a simple polygon of so many tool squares; free space is a rectangle around it",
      {{"kind", &Params::kind, Choices{"polyomino", "orthogonal", "octagonal"}, "of polygon"},
       {"squares", &Params::squares, Range{1, 100000}, "area of the polygon, in squares of the tool's width"},
       {"tool", &Params::tool, Range{0.001, 1000}, "metres; width of the tool the map is scaled for"},
       {"margin", &Params::margin, Range{0, 1000},
        "free space around the polygon, in tool widths; 0: none, the polygon is the map"}},
      make);
}

}  // namespace oxturn::generator

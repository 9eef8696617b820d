#include "algorithms/lattice/promised_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oxturn {
namespace {

constexpr double kHalf = 0.5 * (1 - 1e-9);  // of a cell's side: neighbours' squares do not touch

/// All cells that next(cell, reach) reaches from `start`, by calls of reach(cell).
template <class Next>
std::vector<Cell> reached_from(const GridGraph& graph, const Cell& start, Next next) {
  std::vector<bool> seen(graph.size(), false);
  std::vector<Cell> cells{start};
  seen[graph.at(start)] = true;
  breadth_first(cells, [&](const Cell& at, const auto& take) {
    next(at, [&](const Cell& to) {
      if (seen[graph.at(to)]) return;
      seen[graph.at(to)] = true;
      take(to);
    });
  });
  return cells;
}

/// The last cell of a row without gaps, from the one with number `first` on. `cells`: row by row.
std::size_t end_of_row(const std::vector<Cell>& cells, std::size_t first) {
  std::size_t last = first;
  while (last + 1 < cells.size() && cells[last + 1] == neighbour(cells[last], kEast)) ++last;
  return last;
}

/// A coarse cell, by its lower left sub-cell, is free.
bool coarse_free(const GridGraph& fine, const Cell& base) {
  return fine.passable(base, kEast) && fine.passable(base, kNorth) && fine.passable(neighbour(base, kEast), kNorth) &&
         fine.passable(neighbour(base, kNorth), kEast);
}
/// Both lattice edges that leave the coarse cell over its side d are free.
bool side_open(const GridGraph& fine, const Cell& base, Direction d) {
  const Cell first = d == kEast || d == kNorth ? neighbour(base, d) : base;
  return fine.passable(first, d) && fine.passable(neighbour(first, d == kEast || d == kWest ? kNorth : kEast), d);
}

std::vector<Cell> free_cells(const GridGraph& graph, Components components, const Cell& first) {
  if (components == Components::start)
    return reached_from(graph, first, [&](const Cell& at, const auto& reach) {
      for (const Direction d : kAllDirections)
        if (graph.passable(at, d)) reach(neighbour(at, d));
    });
  std::vector<Cell> cells;
  for (std::size_t node = 0; node < graph.size(); ++node)
    if (graph.free(graph.cell(node))) cells.push_back(graph.cell(node));
  return cells;
}

std::vector<Cell> free_coarse_cells(const GridGraph& fine, Components components, const Cell& first) {
  if (components == Components::start)
    return reached_from(fine, first, [&](const Cell& at, const auto& reach) {
      for (const Direction d : kAllDirections) {
        const Cell to = neighbour(neighbour(at, d), d);
        if (side_open(fine, at, d) && coarse_free(fine, to)) reach(to);
      }
    });
  std::vector<Cell> bases;
  for (int j = (first.j % 2); j < fine.rows(); j += 2)
    for (int i = (first.i % 2); i < fine.columns(); i += 2)
      if (coarse_free(fine, {i, j})) bases.push_back({i, j});
  return bases;
}

}  // namespace

void promise_free_cells(Context& context, const GridGraph& graph, Components components, const Cell& first,
                        double tool_width) {
  if (!context.wants_promise()) return;
  context.promise([graph, components, first, tool_width] {
    return squares_of(graph, free_cells(graph, components, first), tool_width);
  });
}

void promise_coarse_cells(Context& context, const GridGraph& fine, Components components, const Cell& first,
                          double tool_width) {
  if (!context.wants_promise()) return;
  context.promise([fine, components, first, tool_width] {
    return squares_of(fine, coarse_sub_cells(fine, components, first), tool_width);
  });
}

void promise_cells(Context& context, const GridGraph& graph, std::vector<Cell> cells, double tool_width) {
  if (!context.wants_promise()) return;
  context.promise([graph, cells = std::move(cells), tool_width] { return squares_of(graph, cells, tool_width); });
}

void promise_region(Context& context, Region region) {
  context.promise([region = std::move(region)] { return region; });
}

std::vector<Cell> coarse_sub_cells(const GridGraph& fine, Components components, const Cell& first) {
  std::vector<Cell> cells;
  for (const auto& [i, j] : free_coarse_cells(fine, components, first))
    for (const Cell& sub : {Cell{i, j}, Cell{i + 1, j}, Cell{i, j + 1}, Cell{i + 1, j + 1}}) cells.push_back(sub);
  return cells;
}

Region squares_of(const GridGraph& graph, std::vector<Cell> cells, double tool_width) {
  const double half = std::min(kHalf, tool_width / std::sqrt(8) / graph.side());  // in sides
  const bool in_rows = half == kHalf;
  if (in_rows) std::ranges::sort(cells, {}, [&](const Cell& c) { return graph.at(c); });
  Region region;
  for (std::size_t first = 0; first < cells.size();) {
    const std::size_t last = in_rows ? end_of_row(cells, first) : first;
    const Cell &a = cells[first], &b = cells[last];
    region.polygons.push_back({{graph.centre(a.i - half, a.j - half), graph.centre(b.i + half, a.j - half),
                                graph.centre(b.i + half, a.j + half), graph.centre(a.i - half, a.j + half)},
                               {}});
    first = last + 1;
  }
  return region;
}

}  // namespace oxturn

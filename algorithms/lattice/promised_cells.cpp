#include "algorithms/lattice/promised_cells.hpp"

#include <algorithm>
#include <utility>

namespace oxturn {
namespace {

constexpr double kHalf = 0.5 * (1 - 1e-9);  // of a cell's side: neighbours' squares do not touch

Region squares(const GridGraph& graph, const std::vector<Cell>& cells, double tool_width) {
  const double half = std::min(kHalf, tool_width / std::sqrt(8) / graph.side());  // in sides
  Region region;
  region.polygons.reserve(cells.size());
  for (const Cell& c : cells)
    region.polygons.push_back({{graph.centre(c.i - half, c.j - half), graph.centre(c.i + half, c.j - half),
                                graph.centre(c.i + half, c.j + half), graph.centre(c.i - half, c.j + half)},
                               {}});
  return region;
}

std::vector<Cell> connected_cells(const GridGraph& graph, const Cell& start) {
  std::vector<bool> seen(graph.size(), false);
  std::vector<Cell> cells{start};
  seen[graph.at(start)] = true;
  breadth_first(cells, [&](const Cell& at, auto reach) {
    for (const Direction d : kAllDirections) {
      if (!graph.passable(at, d)) continue;
      const Cell next = neighbour(at, d);
      if (seen[graph.at(next)]) continue;
      seen[graph.at(next)] = true;
      reach(next);
    }
  });
  return cells;
}

}  // namespace

void promise_cells(Context& context, const GridGraph& graph, std::vector<Cell> cells, double tool_width) {
  context.promise([graph, cells = std::move(cells), tool_width] { return squares(graph, cells, tool_width); });
}

void promise_connected_cells(Context& context, const GridGraph& graph, const Cell& start, double tool_width) {
  context.promise([graph, start, tool_width] { return squares(graph, connected_cells(graph, start), tool_width); });
}

}  // namespace oxturn

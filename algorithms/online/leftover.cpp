#include "algorithms/online/leftover.hpp"

#include <algorithm>

#include "algorithms/lattice/grid_graph.hpp"
#include "algorithms/online/believed_paths.hpp"
#include "geometry/cell_ring.hpp"

namespace oxturn {
namespace {

constexpr int kLevel = 2;            // of the belief's cells
constexpr double kWorth = 1.0 / 64;  // tool widths square: a component
constexpr double kShare = 5e-4;      // of the target: all components
constexpr int kMostCalls = 8;

/// Clears the cells whose centre is within `reach` of the segment.
void clear_around(BitGrid& grid, const Point& a, const Point& b, double reach) {
  Box box{a.cwiseMin(b), a.cwiseMax(b)};
  box.grow(reach);
  const Cell low = cell_at(grid, box.low), high = cell_at(grid, box.high);
  for (int j = std::max(0, low.j); j <= std::min(grid.rows - 1, high.j); ++j)
    for (int i = std::max(0, low.i); i <= std::min(grid.columns - 1, high.i); ++i)
      if (grid.get(i, j) && distance_to_segment(grid.centre(i, j), a, b) <= reach) grid.set(i, j, false);
}

void clear_under(BitGrid& grid, const Path& path, double reach) {
  for (const Leg& leg : path.legs)
    for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k)
      clear_around(grid, leg.points[k - 1], leg.points[k], reach);
}

/// Clears connected components (by eight neighbours) of fewer than `least` cells; returns how many cells remain.
std::size_t drop_small(BitGrid& grid, std::size_t least) {
  BitGrid left = grid;  // not yet reached
  std::size_t kept = 0;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      if (!left.get(i, j)) continue;
      const std::vector<Cell> component = take_component(left, {i, j}, 1);
      if (component.size() >= least)
        kept += component.size();
      else
        for (const Cell& c : component) grid.set(c.i, c.j, false);
    }
  return kept;
}

/// The set cell nearest to p.
std::optional<Cell> nearest(const BitGrid& grid, const Point& p) {
  const auto [ci, cj] = cell_at(grid, p);
  std::optional<Cell> best;
  double least = std::numeric_limits<double>::infinity();
  for (int ring = 0; ring <= grid.columns + grid.rows && (!best || (ring - 1) * grid.cell <= least); ++ring)
    for_each_in_ring(ci, cj, ring, grid.columns, grid.rows, [&](int i, int j) {
      if (!grid.get(i, j)) return;
      if (const double d = distance(grid.centre(i, j), p); d < least) {
        least = d;
        best = {i, j};
      }
    });
  return best;
}

/// A point of configuration space from which the tool covers q; nullopt: there is none.
std::optional<Point> point_that_covers(const Problem& believed, const Point& q) {
  if (believed.walls().contains(q)) return q;
  const auto hit = believed.walls().nearest(q);
  if (!hit || hit->distance > believed.robot().tool_width / 2) return std::nullopt;
  return hit->point;
}

}  // namespace

void Leftover::planned(const Problem& believed, const Path& path) {
  planned_ = believed.target();
  path_ = path;
}

/// Of the believed target, without what the plan left out on purpose; components that are not worth it are dropped.
BitGrid Leftover::uncovered_cells(const View& view, const Problem& believed) const {
  const Robot& robot = view.robot;
  const double reach = robot.tool_width / 2;
  const BitGrid window = view.belief.cells(kLevel).free;
  const auto raster = [&](const Region& region, CellRule rule) {
    return rasterise(region, window.origin, window.cell, window.columns, window.rows, rule);
  };
  BitGrid uncovered = raster(believed.target(), CellRule::inside);
  const double target = static_cast<double>(uncovered.count());
  BitGrid left_out = raster(planned_, CellRule::touches);
  clear_under(left_out, path_, reach);
  for (std::size_t c = 0; c < uncovered.bits.size(); ++c)
    uncovered.bits[c] = uncovered.bits[c] != 0 && left_out.bits[c] == 0 ? 1 : 0;
  clear_under(uncovered, view.path, reach);
  const auto least =
      static_cast<std::size_t>(kWorth * robot.tool_width * robot.tool_width / (window.cell * window.cell)) + 1;
  if (static_cast<double>(drop_small(uncovered, least)) <= kShare * target)
    std::fill(uncovered.bits.begin(), uncovered.bits.end(), std::uint8_t{0});
  return uncovered;
}

/// From the pose over the uncovered cells, nearest first; clears what it covers or gives up.
Polyline Leftover::tour(const View& view, const Problem& believed, BitGrid& uncovered) {
  const double reach = view.robot.tool_width / 2;
  const BelievedPaths paths(believed, view.path_from_base());
  Polyline tour{view.pose};
  while (const auto cell = nearest(uncovered, tour.back())) {
    uncovered.set(cell->i, cell->j, false);  // one attempt each
    const auto goal = point_that_covers(believed, uncovered.centre(cell->i, cell->j));
    if (!goal) continue;
    const auto on = tour.size() == 1 ? paths.to(*goal) : believed.transit().path(tour.back(), *goal);
    if (!on) continue;
    Polyline longer = tour;
    longer.insert(longer.end(), on->begin() + 1, on->end());
    if (tour.size() > 1 && !paths.within_tether(longer)) {
      seen_ = 0;  // by another path, from where this tour ends
      break;
    }
    for (std::size_t k = tour.size(); k < longer.size(); ++k) clear_around(uncovered, longer[k - 1], longer[k], reach);
    tour = std::move(longer);
  }
  return tour;
}

std::optional<Motion> Leftover::next(const View& view) {
  if (seen_ == view.belief.revision() || ++calls_ > kMostCalls) return std::nullopt;
  seen_ = view.belief.revision();
  const auto believed = believed_problem(view, view.base(), 0);
  if (!believed) return std::nullopt;
  BitGrid uncovered = uncovered_cells(view, *believed);
  if (uncovered.count() == 0) return std::nullopt;
  Polyline line = tour(view, *believed, uncovered);
  if (line.size() < 2) return std::nullopt;
  return Motion{std::move(line), true};
}

}  // namespace oxturn

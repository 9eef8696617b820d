#include "algorithms/online/leftover.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/online/believed_paths.hpp"

namespace oxturn {
namespace {

constexpr int kLevel = 2;
constexpr double kWorth = 1.0 / 64;  // of a tool width square: a patch
constexpr double kShare = 5e-4;      // of the target: all patches
constexpr int kMostCalls = 8;

/// Clears the cells whose centre is within `reach` of the segment.
void clear_about(BitGrid& grid, const Point& a, const Point& b, double reach) {
  const auto column = [&](double x) { return static_cast<int>(std::floor((x - grid.origin.x()) / grid.cell)); };
  const auto row = [&](double y) { return static_cast<int>(std::floor((y - grid.origin.y()) / grid.cell)); };
  const Point low = a.cwiseMin(b), high = a.cwiseMax(b);
  for (int j = std::max(0, row(low.y() - reach)); j <= std::min(grid.rows - 1, row(high.y() + reach)); ++j)
    for (int i = std::max(0, column(low.x() - reach)); i <= std::min(grid.columns - 1, column(high.x() + reach)); ++i)
      if (grid.get(i, j) && distance_to_segment(grid.centre(i, j), a, b) <= reach) grid.set(i, j, false);
}

void clear_under(BitGrid& grid, const Path& path, double reach) {
  for (const Leg& leg : path.legs)
    for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k)
      clear_about(grid, leg.points[k - 1], leg.points[k], reach);
}

/// Drops patches of fewer than `least` cells; returns how many cells are left.
std::size_t drop_small(BitGrid& grid, std::size_t least) {
  BitGrid left = grid;
  std::size_t kept = 0;
  std::vector<std::pair<int, int>> patch;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      if (!left.get(i, j)) continue;
      patch.assign(1, {i, j});
      left.set(i, j, false);
      for (std::size_t k = 0; k < patch.size(); ++k)
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x) {
            const int p = patch[k].first + x, q = patch[k].second + y;
            if (!left.get(p, q)) continue;
            left.set(p, q, false);
            patch.emplace_back(p, q);
          }
      if (patch.size() >= least) {
        kept += patch.size();
        continue;
      }
      for (const auto& [p, q] : patch) grid.set(p, q, false);
    }
  return kept;
}

/// The set cell nearest to p, by growing squares.
std::optional<std::pair<int, int>> nearest(const BitGrid& grid, const Point& p) {
  const int ci = static_cast<int>(std::floor((p.x() - grid.origin.x()) / grid.cell));
  const int cj = static_cast<int>(std::floor((p.y() - grid.origin.y()) / grid.cell));
  std::optional<std::pair<int, int>> best;
  double least = std::numeric_limits<double>::infinity();
  for (int r = 0; r <= grid.columns + grid.rows && (!best || (r - 1) * grid.cell <= least); ++r)
    for (int j = std::max(0, cj - r); j <= std::min(grid.rows - 1, cj + r); ++j) {
      const int step = j == cj - r || j == cj + r || r == 0 ? 1 : 2 * r;
      for (int i = ci - r; i <= ci + r; i += step)
        if (grid.get(i, j))
          if (const double d = distance(grid.centre(i, j), p); d < least) {
            least = d;
            best = {i, j};
          }
    }
  return best;
}

}  // namespace

void Leftover::planned(const Problem& believed, const Path& path) {
  planned_ = believed.target();
  path_ = path;
}

std::optional<Motion> Leftover::next(const View& view) {
  if (seen_ == view.belief().revision() || ++calls_ > kMostCalls) return std::nullopt;
  seen_ = view.belief().revision();
  const Robot& robot = view.robot();
  const auto believed = believed_problem(view, robot.tether ? view.start() : view.pose(), 0);
  if (!believed) return std::nullopt;
  const double reach = robot.tool_width / 2;
  const BitGrid window = view.belief().cells(kLevel).free;
  const auto raster = [&](const Region& region, CellRule rule) {
    return rasterise(region, window.origin, window.cell, window.columns, window.rows, rule);
  };
  BitGrid bare = raster(believed->target(), CellRule::inside);
  const double target = static_cast<double>(bare.count());
  BitGrid spared = raster(planned_, CellRule::touches);  // by the plan, on purpose
  clear_under(spared, path_, reach);
  for (std::size_t c = 0; c < bare.bits.size(); ++c) bare.bits[c] = bare.bits[c] != 0 && spared.bits[c] == 0 ? 1 : 0;
  clear_under(bare, view.path(), reach);
  const auto least =
      static_cast<std::size_t>(kWorth * robot.tool_width * robot.tool_width / (window.cell * window.cell)) + 1;
  if (static_cast<double>(drop_small(bare, least)) <= kShare * target) return std::nullopt;

  const BelievedPaths ways(*believed, robot.tether ? view.way() : Polyline{view.pose()});
  Polyline tour{view.pose()};
  while (const auto cell = nearest(bare, tour.back())) {
    const Point place = bare.centre(cell->first, cell->second);
    bare.set(cell->first, cell->second, false);  // one try each
    Point goal = place;
    if (!believed->walls().contains(place)) {
      const auto hit = believed->walls().nearest(place);
      if (!hit || hit->distance > reach) continue;
      goal = hit->point;
    }
    std::optional<Polyline> on;
    if (tour.size() == 1)
      on = ways.to(goal);
    else
      on = believed->transit().path(tour.back(), goal);
    if (!on) continue;
    Polyline longer = tour;
    longer.insert(longer.end(), on->begin() + 1, on->end());
    if (robot.tether && tour.size() > 1 && !ways.holds(longer)) {
      bare.set(cell->first, cell->second, true);  // by another way, from where this tour ends
      seen_ = 0;
      break;
    }
    for (std::size_t k = tour.size(); k < longer.size(); ++k) clear_about(bare, longer[k - 1], longer[k], reach);
    tour = std::move(longer);
  }
  if (tour.size() < 2) return std::nullopt;
  return Motion{std::move(tour), true};
}

}  // namespace oxturn

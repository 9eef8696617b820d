#include "algorithms/online/explore.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "algorithms/online/string_ways.hpp"

namespace oxturn {
namespace {

using Key = std::pair<std::int64_t, std::int64_t>;

struct Cell {
  int i, j;
};

/// The set cells of a row or column and all within `reach` of them.
template <class Get, class Set>
void widen_line(int n, int reach, Get get, Set set) {
  int since = reach + 1;  // cells since the last set one
  for (int i = 0; i < n; ++i) {
    since = get(i) ? 0 : std::min(since + 1, reach + 1);
    if (since <= reach) set(i);
  }
  since = reach + 1;
  for (int i = n - 1; i >= 0; --i) {
    since = get(i) ? 0 : std::min(since + 1, reach + 1);
    if (since <= reach) set(i);
  }
}

/// Set cells and all within `reach` cells of them, in both directions.
BitGrid widened(const BitGrid& grid, int reach) {
  BitGrid across = grid;
  for (int j = 0; j < grid.rows; ++j)
    widen_line(
        grid.columns, reach, [&](int i) { return grid.get(i, j); }, [&](int i) { across.set(i, j, true); });
  BitGrid out = across;
  for (int i = 0; i < grid.columns; ++i)
    widen_line(
        grid.rows, reach, [&](int j) { return across.get(i, j); }, [&](int j) { out.set(i, j, true); });
  return out;
}

/// Free cells only on the straight way between two cells, the ends excepted. Two places a cell, in 1/65536 of one.
bool in_sight(const BitGrid& free, const Cell& a, const Cell& b) {
  const int steps = 2 * std::max(std::abs(b.i - a.i), std::abs(b.j - a.j));
  if (steps == 0) return true;
  const std::int64_t one = 1 << 16, di = (b.i - a.i) * one / steps, dj = (b.j - a.j) * one / steps;
  std::int64_t i = a.i * one + one / 2, j = a.j * one + one / 2;
  for (int s = 1; s < steps; ++s) {
    i += di;
    j += dj;
    if (free.bits[free.at(static_cast<int>(i >> 16), static_cast<int>(j >> 16))] == 0) return false;
  }
  return true;
}

struct Frontier {
  std::vector<Cell> cells;
  std::vector<double> from;  // how near each must be looked at from
};

constexpr std::size_t kSamples = 12;  // cells that stand for a frontier
constexpr std::size_t kMostTried = 16;
constexpr int kStride = 4;  // cells between viewpoints that are tried

}  // namespace

// Only ever finer: the way driven so far must lie in the world that it is judged in.
std::optional<Problem> Explorer::world(const View& view, const Point& base) {
  for (; level_ > 0; --level_)
    if (auto believed = believed_problem(view, base, level_)) return believed;
  return believed_problem(view, base, 0);
}

std::optional<Motion> Explorer::next(const View& view) {
  const Robot& robot = view.robot();
  const Point base = robot.tether ? view.start() : view.pose();
  const auto believed = world(view, base);
  if (!believed) return std::nullopt;
  const Belief::Cells& cells = view.belief().cells(level_);
  const BitGrid& free = cells.free;
  const double cell = free.cell;
  if (look_cell_ != cell) look_from_.clear();
  look_cell_ = cell;
  const double size = robot.radius > 0 ? robot.radius : robot.tool_width / 2;
  const double farthest = 0.9 * view.belief().trusted_range();
  const auto key = [&](const Cell& c) {
    const Point p = (free.centre(c.i, c.j) - view.start()) / cell;
    return Key{static_cast<std::int64_t>(std::floor(p.x())), static_cast<std::int64_t>(std::floor(p.y()))};
  };
  const auto cell_of = [&](const Point& p) {
    const Point at = (p - free.origin) / cell;
    return Cell{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  };
  const Cell here = cell_of(view.pose());

  // Frontier cells, less those that have been looked at in vain from next to them.
  const bool noisy = robot.lidar->noise > 0;  // then stars end farther from the walls
  const BitGrid walled = widened(cells.wall, std::max(1, static_cast<int>((noisy ? 0.75 * size : size / 4) / cell)));
  BitGrid frontier(free.origin, cell, free.columns, free.rows);
  for (int j = 0; j < free.rows; ++j)
    for (int i = 0; i < free.columns; ++i) {
      if (!free.get(i, j)) continue;
      bool open = false;
      for (int y = -1; y <= 1 && !open; ++y)
        for (int x = -1; x <= 1 && !open; ++x) open = !free.get(i + x, j + y) && !walled.get(i + x, j + y);
      if (!open) continue;
      const Cell c{i, j};
      const auto known = look_from_.find(key(c));
      double from = known == look_from_.end() ? farthest : known->second;
      if (free.inside(here.i, here.j) && cell * std::hypot(i - here.i, j - here.j) <= from && in_sight(free, here, c)) {
        from /= 2;
        look_from_[key(c)] = from;
      }
      if (from >= size) frontier.set(i, j, true);
    }

  const double least = settings_.least > 0 ? settings_.least : size / 2;
  std::vector<Frontier> all;
  {
    BitGrid left = frontier;
    for (int j = 0; j < left.rows; ++j)
      for (int i = 0; i < left.columns; ++i) {
        if (!left.get(i, j)) continue;
        std::vector<Cell> group{{i, j}};
        left.set(i, j, false);
        for (std::size_t k = 0; k < group.size(); ++k) {
          const Cell at = group[k];
          for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x)
              if (left.get(at.i + x, at.j + y)) {
                left.set(at.i + x, at.j + y, false);
                group.push_back({at.i + x, at.j + y});
              }
        }
        if (static_cast<double>(group.size()) * cell < least) continue;
        Frontier f;
        const std::size_t every = std::max<std::size_t>(1, group.size() / kSamples);
        for (std::size_t k = 0; k < group.size(); k += every) {
          const auto known = look_from_.find(key(group[k]));
          f.cells.push_back(group[k]);
          f.from.push_back(known == look_from_.end() ? farthest : known->second);
        }
        all.push_back(std::move(f));
      }
  }
  if (all.empty()) return std::nullopt;

  // Outwards from the robot over the places where it can stand.
  const BitGrid room =
      rasterise(believed->configuration_space(), free.origin, cell, free.columns, free.rows, CellRule::centre);
  StringWays ways(*believed, robot.tether ? view.way() : Polyline{view.pose()});
  using Item = std::pair<double, std::size_t>;
  for (const double share : {0.5, 0.0}) {
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    std::vector<double> away(free.bits.size(), std::numeric_limits<double>::infinity());
    const int reach = 8;
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if (room.get(here.i + x, here.j + y)) {
          const double d = cell * std::hypot(x, y);
          away[room.at(here.i + x, here.j + y)] = d;
          queue.emplace(d, room.at(here.i + x, here.j + y));
        }
    // With a tether the way may be a long one, back along the way driven: then others are tried, as long as they may
    // be shorter.
    std::vector<Cell> tried;
    std::optional<Polyline> best;
    double shortest = std::numeric_limits<double>::infinity();
    while (!queue.empty() && tried.size() < kMostTried) {
      const auto [d, index] = queue.top();
      queue.pop();
      if (d >= shortest) break;
      if (d > away[index]) continue;
      const Cell at{static_cast<int>(index % static_cast<std::size_t>(room.columns)),
                    static_cast<int>(index / static_cast<std::size_t>(room.columns))};
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          if (!room.get(at.i + x, at.j + y)) continue;
          const double then = d + cell * std::hypot(x, y);
          double& known = away[room.at(at.i + x, at.j + y)];
          if (then >= known - 1e-12) continue;
          known = then;
          queue.emplace(then, room.at(at.i + x, at.j + y));
        }
      if (at.i % kStride != 0 || at.j % kStride != 0 || d < (share > 0 ? 3 * size : cell)) continue;
      bool good = false;
      for (std::size_t f = 0; f < all.size() && !good; ++f) {
        std::size_t seen = 0;
        const std::size_t wanted = static_cast<std::size_t>(share * static_cast<double>(all[f].cells.size())) + 1;
        for (std::size_t k = 0; k < all[f].cells.size() && seen < wanted; ++k) {
          if (seen + all[f].cells.size() - k < wanted) break;
          const Cell& c = all[f].cells[k];
          const double x = cell * (c.i - at.i), y = cell * (c.j - at.j);
          if (x * x + y * y <= all[f].from[k] * all[f].from[k] && in_sight(free, at, c)) ++seen;
        }
        good = seen >= wanted;
      }
      if (!good) continue;
      const auto close = [&](const Cell& c) { return cell * std::hypot(c.i - at.i, c.j - at.j) < 2 * size; };
      if (std::any_of(tried.begin(), tried.end(), close)) continue;
      tried.push_back(at);
      auto way = ways.to(room.centre(at.i, at.j));
      if (!way || length(*way) >= shortest) continue;
      shortest = length(*way);
      best = std::move(way);
      if (shortest < 1.2 * d + size) break;
    }
    if (best) return Motion{std::move(*best), true};
  }
  return std::nullopt;
}

}  // namespace oxturn

#include "algorithms/online/explore.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "algorithms/online/believed_paths.hpp"

namespace oxturn {
namespace {

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
constexpr int kBegin = 8;   // cells about the robot from which the search begins
constexpr int kStride = 4;  // cells between viewpoints that are tried

Cell cell_at(const BitGrid& grid, const Point& p) {
  const Point at = (p - grid.origin) / grid.cell;
  return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
}

double size_of(const Robot& robot) { return robot.radius > 0 ? robot.radius : robot.tool_width / 2; }

/// Set cells that touch, or nearly; groups shorter than `least` metres left out.
std::vector<Frontier> groups_of(BitGrid open, double least) {
  std::vector<Frontier> all;
  for (int j = 0; j < open.rows; ++j)
    for (int i = 0; i < open.columns; ++i) {
      if (!open.get(i, j)) continue;
      std::vector<Cell> group{{i, j}};
      open.set(i, j, false);
      for (std::size_t k = 0; k < group.size(); ++k) {
        const Cell at = group[k];
        for (int y = -2; y <= 2; ++y)
          for (int x = -2; x <= 2; ++x)
            if (open.get(at.i + x, at.j + y)) {
              open.set(at.i + x, at.j + y, false);
              group.push_back({at.i + x, at.j + y});
            }
      }
      if (static_cast<double>(group.size()) * open.cell < least) continue;
      Frontier f;
      const std::size_t every = std::max<std::size_t>(1, group.size() / kSamples);
      for (std::size_t k = 0; k < group.size(); k += every) f.cells.push_back(group[k]);
      all.push_back(std::move(f));
    }
  return all;
}

/// A frontier that the tether does not reach through what is known matters to nobody: whoever comes to what lies behind
/// it within the tether's length crosses another one that is nearer.
void drop_out_of_reach(std::vector<Frontier>& frontiers, const BitGrid& free, const Problem& believed) {
  const Robot& robot = believed.robot();
  const double limit = robot.tether->length + robot.tool_width / 2 + 2 * free.cell;
  for (Frontier& f : frontiers)
    std::erase_if(f.cells, [&](const Cell& c) {
      const double away = believed.tether()->geodesics().distance(free.centre(c.i, c.j));
      return std::isfinite(away) && away > limit;
    });
  std::erase_if(frontiers, [](const Frontier& f) { return f.cells.empty(); });
}

/// Is more than `share` of a frontier in sight, and near enough?
bool sees_one(const BitGrid& free, const Cell& at, const std::vector<Frontier>& frontiers, double share) {
  for (const Frontier& f : frontiers) {
    const std::size_t n = f.cells.size(), wanted = static_cast<std::size_t>(share * static_cast<double>(n)) + 1;
    std::size_t seen = 0;
    for (std::size_t k = 0; k < n && seen < wanted && seen + n - k >= wanted; ++k) {
      const double x = free.cell * (f.cells[k].i - at.i), y = free.cell * (f.cells[k].j - at.j);
      if (x * x + y * y <= f.from[k] * f.from[k] && in_sight(free, at, f.cells[k])) ++seen;
    }
    if (seen >= wanted) return true;
  }
  return false;
}

struct Viewing {
  double share;    // of a frontier that must be in sight
  double nearest;  // metres to go, at least
  double size;     // of the robot
};

/// Outwards from the robot over the cells where it can stand (`room`), to the first viewpoint. With a tether the way
/// there may be a long one, back along the way driven: then others are tried as long as they may be shorter.
std::optional<Polyline> path_to_view(const BitGrid& free, const BitGrid& room, const Point& pose,
                                    const std::vector<Frontier>& frontiers, const BelievedPaths& ways,
                                    const Viewing& viewing) {
  const double cell = room.cell;
  using Item = std::pair<double, std::size_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::vector<double> away(room.bits.size(), std::numeric_limits<double>::infinity());
  const auto reach = [&](int i, int j, double d) {
    if (!room.get(i, j) || d >= away[room.at(i, j)] - 1e-12) return;
    away[room.at(i, j)] = d;
    queue.emplace(d, room.at(i, j));
  };
  // The robot may stand just outside of the room.
  const Cell here = cell_at(room, pose);
  for (int y = -kBegin; y <= kBegin; ++y)
    for (int x = -kBegin; x <= kBegin; ++x) reach(here.i + x, here.j + y, cell * std::hypot(x, y));
  std::vector<Cell> tried;
  std::optional<Polyline> best;
  double shortest = std::numeric_limits<double>::infinity();
  while (!queue.empty() && tried.size() < kMostTried) {
    const auto [d, index] = queue.top();
    queue.pop();
    if (d >= shortest) break;
    if (d > away[index]) continue;
    const auto columns = static_cast<std::size_t>(room.columns);
    const Cell at{static_cast<int>(index % columns), static_cast<int>(index / columns)};
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) reach(at.i + x, at.j + y, d + cell * std::hypot(x, y));
    if (at.i % kStride != 0 || at.j % kStride != 0 || d < viewing.nearest) continue;
    const auto close = [&](const Cell& c) { return cell * std::hypot(c.i - at.i, c.j - at.j) < 2 * viewing.size; };
    if (!sees_one(free, at, frontiers, viewing.share) || std::any_of(tried.begin(), tried.end(), close)) continue;
    tried.push_back(at);
    auto way = ways.to(room.centre(at.i, at.j));
    if (!way || length(*way) >= shortest) continue;
    shortest = length(*way);
    best = std::move(way);
    if (shortest < 1.2 * d + viewing.size) break;
  }
  return best;
}

}  // namespace

// Only ever finer: the way driven so far must lie in the world that it is judged in.
std::optional<Problem> Explorer::world(const View& view, const Point& base) {
  while (level_ > 0 && view.belief().cell() * (1 << level_) > size_of(view.robot()) / 7) --level_;
  for (; level_ > 0; --level_)
    if (auto believed = believed_problem(view, base, level_)) return believed;
  return believed_problem(view, base, 0);
}

double& Explorer::look_from(const BitGrid& grid, int i, int j, double farthest) {
  if (look_cell_ != grid.cell) look_from_.clear();
  look_cell_ = grid.cell;
  const Point at = (grid.centre(i, j) - look_origin_) / grid.cell;
  const std::pair key(static_cast<std::int64_t>(std::floor(at.x())), static_cast<std::int64_t>(std::floor(at.y())));
  return look_from_.try_emplace(key, farthest).first->second;
}

/// Free cells next to unknown ones, less those that have been looked at in vain from next to them.
BitGrid Explorer::open_cells(const View& view, const Belief::Cells& cells) {
  const BitGrid& free = cells.free;
  const Robot& robot = view.robot();
  const double size = size_of(robot), farthest = 0.9 * view.belief().trusted_range();
  const double band = robot.lidar->noise > 0 ? 0.75 * size : size / 4;  // with noise stars end farther from the walls
  const BitGrid walled = widened(cells.wall, std::max(1, static_cast<int>(band / free.cell)));
  BitGrid open = walled;
  for (std::size_t c = 0; c < open.bits.size(); ++c) open.bits[c] = free.bits[c] == 0 && walled.bits[c] == 0 ? 1 : 0;
  open = widened(open, 1);
  const Cell here = cell_at(free, view.pose());
  for (int j = 0; j < free.rows; ++j)
    for (int i = 0; i < free.columns; ++i) {
      if (!open.get(i, j)) continue;
      open.set(i, j, false);
      if (!free.get(i, j)) continue;
      double& from = look_from(free, i, j, farthest);
      const double away = free.cell * std::hypot(i - here.i, j - here.j);
      if (free.inside(here.i, here.j) && away <= from && in_sight(free, here, {i, j})) from /= 2;
      if (from >= size) open.set(i, j, true);
    }
  return open;
}

std::optional<Motion> Explorer::next(const View& view) {
  const Robot& robot = view.robot();
  const auto believed = world(view, robot.tether ? view.start() : view.pose());
  if (!believed) return std::nullopt;
  const Belief::Cells& cells = view.belief().cells(level_);
  const BitGrid& free = cells.free;
  look_origin_ = view.start();
  const double size = size_of(robot), farthest = 0.9 * view.belief().trusted_range();
  std::vector<Frontier> frontiers =
      groups_of(open_cells(view, cells), settings_.least > 0 ? settings_.least : size / 2);
  if (robot.tether) drop_out_of_reach(frontiers, free, *believed);
  if (frontiers.empty()) return std::nullopt;
  for (Frontier& f : frontiers)
    for (const Cell& c : f.cells) f.from.push_back(look_from(free, c.i, c.j, farthest));

  const BitGrid room =
      rasterise(believed->configuration_space(), free.origin, free.cell, free.columns, free.rows, CellRule::centre);
  const BelievedPaths ways(*believed, robot.tether ? view.way() : Polyline{view.pose()});
  // Half of a frontier, and not just round the corner; or else anything.
  for (const auto& [share, nearest] : {std::pair(0.5, 3 * size), std::pair(0.0, free.cell)})
    if (auto way = path_to_view(free, room, view.pose(), frontiers, ways, {share, nearest, size}))
      return Motion{std::move(*way), true};
  return std::nullopt;
}

}  // namespace oxturn

#include "algorithms/online/explore.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/lattice/grid_graph.hpp"
#include "algorithms/online/believed_paths.hpp"
#include "base/graph_search.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kSamples = 12;    // cells that represent a frontier
constexpr std::size_t kMostTried = 16;  // viewpoints
constexpr int kBegin = 8;               // cells around the robot from which the search begins
constexpr int kStride = 4;              // cells between viewpoints that are tried
constexpr int kTouching = 2;            // cells at most between cells of one frontier
constexpr double kTrusted = 0.9;        // of the trusted range: farthest distance to a frontier

/// Calls set(i) for the set cells of a row or column and all within `reach` of them.
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

/// Set cells and all within `reach` cells of them, along both axes.
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

/// The segment between two cells passes free cells only, the ends excepted. Two samples a cell, in fixed point.
bool in_sight(const BitGrid& free, const Cell& a, const Cell& b) {
  constexpr int kFraction = 16;  // bits
  const int steps = 2 * std::max(std::abs(b.i - a.i), std::abs(b.j - a.j));
  if (steps == 0) return true;
  const std::int64_t one = 1 << kFraction, di = (b.i - a.i) * one / steps, dj = (b.j - a.j) * one / steps;
  std::int64_t i = a.i * one + one / 2, j = a.j * one + one / 2;
  for (int s = 1; s < steps; ++s) {
    i += di;
    j += dj;
    if (free.bits[free.at(static_cast<int>(i >> kFraction), static_cast<int>(j >> kFraction))] == 0) return false;
  }
  return true;
}

struct Frontier {
  std::vector<Cell> cells;   // samples
  std::vector<double> from;  // how near each must be looked at from
};

/// Frontiers of the set cells; those shorter than `least` metres are left out.
std::vector<Frontier> frontiers_of(BitGrid open, double least) {
  std::vector<Frontier> all;
  for (int j = 0; j < open.rows; ++j)
    for (int i = 0; i < open.columns; ++i) {
      if (!open.get(i, j)) continue;
      const std::vector<Cell> group = take_component(open, {i, j}, kTouching);
      if (static_cast<double>(group.size()) * open.cell < least) continue;
      Frontier f;
      const std::size_t every = std::max<std::size_t>(1, group.size() / kSamples);
      for (std::size_t k = 0; k < group.size(); k += every) f.cells.push_back(group[k]);
      all.push_back(std::move(f));
    }
  return all;
}

/// Drops what the tether does not reach through known space. What lies behind such a frontier and can be reached within
/// the tether's length lies behind a nearer frontier, too.
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

/// Of some frontier, more than `share` is in sight and near enough.
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
  double nearest;  // metres to drive, at least
  double size;     // of the robot
};

/// Searches outwards from the robot over the cells that it can occupy, to the first viewpoint. With a tether the path
/// there may be long, back along the driven path; then other viewpoints are tried as long as they may be nearer.
class ViewpointSearch {
 public:
  ViewpointSearch(const BitGrid& free, const BitGrid& room, const std::vector<Frontier>& frontiers,
                  const BelievedPaths& paths)
      : free_(free), room_(room), frontiers_(frontiers), paths_(paths) {}

  /// The path to the viewpoint; nullopt if there is none.
  std::optional<Polyline> run(const Point& pose, const Viewing& viewing) {
    tried_.clear();
    best_.reset();
    shortest_ = std::numeric_limits<double>::infinity();
    const auto neighbours = [this](std::size_t node, const auto& reach) {
      const Cell at = cell(node);
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (room_.get(at.i + x, at.j + y)) reach(room_.at(at.i + x, at.j + y), room_.cell * math::hypot(x, y));
    };
    dijkstra(search_, room_.bits.size(), sources(pose), neighbours,
             [&](std::size_t node) { return finished(cell(node), search_.cost(node), viewing); });
    return best_;
  }

 private:
  Cell cell(std::size_t node) const {
    const auto columns = static_cast<std::size_t>(room_.columns);
    return {static_cast<int>(node % columns), static_cast<int>(node / columns)};
  }
  /// The robot may be just outside of the room.
  std::vector<std::pair<std::size_t, double>> sources(const Point& pose) const {
    const Cell here = cell_at(room_, pose);
    std::vector<std::pair<std::size_t, double>> all;
    for (int y = -kBegin; y <= kBegin; ++y)
      for (int x = -kBegin; x <= kBegin; ++x)
        if (room_.get(here.i + x, here.j + y))
          all.emplace_back(room_.at(here.i + x, here.j + y), room_.cell * math::hypot(x, y));
    return all;
  }

  /// Tries the cell as a viewpoint; true: the search can end.
  bool finished(const Cell& at, double away, const Viewing& viewing) {
    if (away >= shortest_) return true;
    if (at.i % kStride != 0 || at.j % kStride != 0 || away < viewing.nearest) return false;
    const auto close = [&](const Cell& c) {
      return room_.cell * math::hypot(c.i - at.i, c.j - at.j) < 2 * viewing.size;
    };
    if (!sees_one(free_, at, frontiers_, viewing.share) || std::any_of(tried_.begin(), tried_.end(), close))
      return false;
    tried_.push_back(at);
    auto path = paths_.to(room_.centre(at.i, at.j));
    if (path && length(*path) < shortest_) {
      shortest_ = length(*path);
      best_ = std::move(path);
      if (shortest_ < 1.2 * away + viewing.size) return true;
    }
    return tried_.size() >= kMostTried;
  }

  const BitGrid &free_, &room_;
  const std::vector<Frontier>& frontiers_;
  const BelievedPaths& paths_;
  SearchTree<double> search_;
  std::vector<Cell> tried_;
  std::optional<Polyline> best_;
  double shortest_ = 0;
};

}  // namespace

/// Only ever finer: the driven path must lie in the world in which it is judged.
std::optional<Problem> Explorer::world(const View& view) {
  while (level_ > 0 && view.belief.cell() * (1 << level_) > robot_size(view.robot) / 7) --level_;
  for (; level_ > 0; --level_)
    if (auto believed = believed_problem(view, view.base(), level_)) return believed;
  return believed_problem(view, view.base(), 0);
}

double& Explorer::look_from(const BitGrid& grid, int i, int j, double farthest) {
  if (look_cell_ != grid.cell) look_from_.clear();
  look_cell_ = grid.cell;
  const Point at = (grid.centre(i, j) - look_origin_) / grid.cell;
  const std::pair key(static_cast<std::int64_t>(std::floor(at.x())), static_cast<std::int64_t>(std::floor(at.y())));
  return look_from_.try_emplace(key, farthest).first->second;
}

/// Free cells next to unknown ones, without those that have been looked at in vain from next to them.
BitGrid Explorer::open_cells(const View& view, const Belief::Cells& cells) {
  const BitGrid& free = cells.free;
  const Robot& robot = view.robot;
  const double size = robot_size(robot), farthest = kTrusted * view.belief.trusted_range();
  const double band = robot.lidar->noise > 0 ? 0.75 * size : size / 4;  // with noise stars end farther from the walls
  const BitGrid walled = widened(cells.wall, std::max(1, static_cast<int>(band / free.cell)));
  BitGrid open = walled;
  for (std::size_t c = 0; c < open.bits.size(); ++c) open.bits[c] = free.bits[c] == 0 && walled.bits[c] == 0 ? 1 : 0;
  open = widened(open, 1);
  const Cell here = cell_at(free, view.pose);
  for (int j = 0; j < free.rows; ++j)
    for (int i = 0; i < free.columns; ++i) {
      if (!open.get(i, j)) continue;
      open.set(i, j, false);
      if (!free.get(i, j)) continue;
      double& from = look_from(free, i, j, farthest);
      const double away = free.cell * math::hypot(i - here.i, j - here.j);
      if (free.inside(here.i, here.j) && away <= from && in_sight(free, here, {i, j})) from /= 2;
      if (from >= size) open.set(i, j, true);
    }
  return open;
}

std::optional<Motion> Explorer::next(const View& view) {
  const auto believed = world(view);
  if (!believed) return std::nullopt;
  const Belief::Cells& cells = view.belief.cells(level_);
  const BitGrid& free = cells.free;
  look_origin_ = view.start;
  const double size = robot_size(view.robot), farthest = kTrusted * view.belief.trusted_range();
  std::vector<Frontier> frontiers = frontiers_of(open_cells(view, cells), size / 2);
  if (view.robot.tether) drop_out_of_reach(frontiers, free, *believed);
  if (frontiers.empty()) return std::nullopt;
  for (Frontier& f : frontiers)
    for (const Cell& c : f.cells) f.from.push_back(look_from(free, c.i, c.j, farthest));

  const BitGrid room =
      rasterise(believed->configuration_space(), free.origin, free.cell, free.columns, free.rows, CellRule::centre);
  const BelievedPaths paths(*believed, view.path_from_base());
  ViewpointSearch search(free, room, frontiers, paths);
  // Half of a frontier, and not just around the corner; or else anything.
  for (const auto& [share, nearest] : {std::pair(0.5, 3 * size), std::pair(0.0, free.cell)})
    if (auto path = search.run(view.pose, {share, nearest, size})) return Motion{std::move(*path), true};
  return std::nullopt;
}

}  // namespace oxturn

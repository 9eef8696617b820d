#include "algorithms/grid/world_scan.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {
namespace {

constexpr int kBegin = 4;           // cells around the pose, which may be nearer to a wall than cells can show
constexpr std::size_t kMost = 500;  // refusals; more would mean a belief that never settles

/// Removes the cells whose centres are within `reach` cells of (x, y).
void remove_disc(BitGrid& room, double x, double y, double reach) {
  for (int j = static_cast<int>(std::ceil(y - reach)); j <= static_cast<int>(std::floor(y + reach)); ++j) {
    if (j < 0 || j >= room.rows) continue;
    const double half = std::sqrt(std::max(0.0, reach * reach - (j - y) * (j - y)));
    const int from = std::max(0, static_cast<int>(std::ceil(x - half)));
    const int to = std::min(room.columns - 1, static_cast<int>(std::floor(x + half)));
    for (int i = from; i <= to; ++i) room.set(i, j, false);
  }
}

/// Cells that the robot's centre may occupy as far as is known.
BitGrid room_of(const Belief::Cells& cells, double radius, const std::vector<Point>& refused) {
  const BitGrid& wall = cells.wall;
  BitGrid room(wall.origin, wall.cell, wall.columns, wall.rows);
  std::fill(room.bits.begin(), room.bits.end(), std::uint8_t{1});
  for (int j = 0; j < wall.rows; ++j)
    for (int i = 0; i < wall.columns; ++i)
      if (wall.get(i, j) && !(wall.get(i - 1, j) && wall.get(i + 1, j) && wall.get(i, j - 1) && wall.get(i, j + 1)))
        remove_disc(room, i, j, radius / wall.cell + 0.5);
  for (const Point& p : refused) {
    const Point at = (p - wall.origin) / wall.cell - Point(0.5, 0.5);
    remove_disc(room, at.x(), at.y(), radius / 2 / wall.cell);
  }
  return room;
}

/// All cells between a and b along the segment belong to the room.
bool straight(const BitGrid& room, const Cell& a, const Cell& b) {
  const int steps = 2 * std::max(std::abs(b.i - a.i), std::abs(b.j - a.j));
  for (int s = 1; s < steps; ++s) {
    const double t = static_cast<double>(s) / steps;
    if (!room.get(static_cast<int>(std::lround(a.i + t * (b.i - a.i))),
                  static_cast<int>(std::lround(a.j + t * (b.j - a.j)))))
      return false;
  }
  return true;
}

/// A breadth-first search from the cells around the pose to the border of the window.
class SearchOut {
 public:
  explicit SearchOut(const BitGrid& room) : room_(room), reached_(room.bits.size()) {}

  /// The cells of the path whose end is nearest, by steps, to the point far up; empty if there is none.
  std::vector<Cell> run(const Point& pose) {
    const auto [ci, cj] = cell_at(room_, pose);
    const auto enqueue = [this](const Cell& c) { queue_.push_back(c); };
    reach({ci, cj}, std::nullopt, 0, enqueue);
    for (int y = -kBegin; y <= kBegin; ++y)
      for (int x = -kBegin; x <= kBegin; ++x) reach({ci + x, cj + y}, std::nullopt, std::abs(x) + std::abs(y), enqueue);
    breadth_first(queue_, [this](const Cell& c, const auto& append) {
      if (c.i == 0 || c.j == 0 || c.i == room_.columns - 1 || c.j == room_.rows - 1) {
        consider(c);
        return;
      }
      const int steps = at_cell(c).steps + 1;
      for (const Direction d : kAllDirections) reach(neighbour(c, d), c, steps, append);
    });
    std::vector<Cell> path;
    for (std::optional<Cell> c = best_; c; c = at_cell(*c).from) path.push_back(*c);
    std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  struct Reached {
    bool reached = false;
    std::optional<Cell> from;
    int steps = 0;
  };
  Reached& at_cell(const Cell& c) { return reached_[room_.at(c.i, c.j)]; }
  template <class Append>
  void reach(const Cell& c, std::optional<Cell> from, int steps, const Append& append) {
    if (!room_.get(c.i, c.j) || at_cell(c).reached) return;
    at_cell(c) = {true, from, steps};
    append(c);
  }
  void consider(const Cell& c) {
    const int whole = at_cell(c).steps + (room_.rows - c.j);
    if (best_ && whole >= least_) return;
    least_ = whole;
    best_ = c;
  }

  const BitGrid& room_;
  std::vector<Reached> reached_;
  std::vector<Cell> queue_;
  std::optional<Cell> best_;
  int least_ = 0;
};

/// A path out of the window; empty if there is none.
Polyline path_out(const BitGrid& room, const Point& pose) {
  const std::vector<Cell> cells = SearchOut(room).run(pose);
  if (cells.empty()) return {};
  Polyline path{pose, room.centre(cells[0].i, cells[0].j)};
  for (std::size_t k = 0; k + 1 < cells.size();) {
    std::size_t next = k + 1;
    while (next + 1 < cells.size() && straight(room, cells[k], cells[next + 1])) ++next;
    path.push_back(room.centre(cells[next].i, cells[next].j));
    k = next;
  }
  return path;
}

/// As much of the path as is believed free, to within `step` metres.
Polyline known_part(const Belief& belief, const Polyline& path, double radius, double step) {
  Polyline part{path.front()};
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Point a = part.back();
    const double length = distance(a, path[k]);
    if (belief.free_for(a, path[k], radius)) {
      if (length > 0) part.push_back(path[k]);
      continue;
    }
    const auto at = [&](double s) { return lerp(a, path[k], s / length); };
    double free = 0;
    for (double s = step; s < length && belief.free_for(at(free), at(s), radius); s += step) free = s;
    if (free > 0) part.push_back(at(free));
    break;
  }
  return part;
}

/// The point so many metres along the path; its end if it is shorter.
Point point_along(const Polyline& path, double metres) {
  for (std::size_t k = 1; k < path.size(); ++k) {
    const double length = distance(path[k - 1], path[k]);
    if (length >= metres) return lerp(path[k - 1], path[k], metres / length);
    metres -= length;
  }
  return path.back();
}

/// Where to drive next; nullopt: the outer wall is closed. `refused`: points that are taken as wall (Decision 2).
std::optional<Motion> next_motion(const View& view, std::vector<Point>& refused) {
  const Robot& robot = view.robot;
  const double size = robot_size(robot);
  const double radius = std::max(0.0, robot.radius - 5e-7 * robot.tool_width);  // touching a wall is allowed
  while (refused.size() < kMost) {
    const BitGrid room = room_of(view.belief.cells(Belief::kCoarsest), robot.radius, refused);
    const Polyline path = path_out(room, view.pose);
    if (path.empty()) return std::nullopt;
    Polyline part = known_part(view.belief, path, radius, size / 8);
    if (length(part) > size / 4) return Motion{std::move(part), false};
    refused.push_back(point_along(path, length(part) + size / 2));
  }
  return std::nullopt;
}

}  // namespace

void scan_world(OnlineRobot& robot, const Context& context) {
  std::vector<Point> refused;
  while (!context.cancelled()) {
    const auto motion = next_motion(robot.view(), refused);
    if (!motion) return;
    robot.go(*motion);
  }
}

}  // namespace oxturn

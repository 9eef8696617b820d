#include "algorithms/grid/world_scan.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr int kBegin = 4;           // cells about the pose, which may be nearer to a wall than cells can tell
constexpr std::size_t kMost = 500;  // refusals; more would be a belief that never settles

/// Takes the cells whose centres are within `reach` cells of (x, y).
void stamp(BitGrid& room, double x, double y, double reach) {
  for (int j = static_cast<int>(std::ceil(y - reach)); j <= static_cast<int>(std::floor(y + reach)); ++j) {
    if (j < 0 || j >= room.rows) continue;
    const double half = std::sqrt(std::max(0.0, reach * reach - (j - y) * (j - y)));
    const int from = std::max(0, static_cast<int>(std::ceil(x - half)));
    const int to = std::min(room.columns - 1, static_cast<int>(std::floor(x + half)));
    for (int i = from; i <= to; ++i) room.set(i, j, false);
  }
}

/// Cells where the robot's centre may be as far as is known.
BitGrid room_of(const Belief::Cells& cells, double radius, const std::vector<Point>& refused) {
  const BitGrid& wall = cells.wall;
  BitGrid room(wall.origin, wall.cell, wall.columns, wall.rows);
  std::fill(room.bits.begin(), room.bits.end(), std::uint8_t{1});
  for (int j = 0; j < wall.rows; ++j)
    for (int i = 0; i < wall.columns; ++i)
      if (wall.get(i, j) && !(wall.get(i - 1, j) && wall.get(i + 1, j) && wall.get(i, j - 1) && wall.get(i, j + 1)))
        stamp(room, i, j, radius / wall.cell + 0.5);
  for (const Point& p : refused) {
    const Point at = (p - wall.origin) / wall.cell - Point(0.5, 0.5);
    stamp(room, at.x(), at.y(), radius / 2 / wall.cell);
  }
  return room;
}

bool clear(const BitGrid& room, const std::pair<int, int>& a, const std::pair<int, int>& b) {
  const int steps = 2 * std::max(std::abs(b.first - a.first), std::abs(b.second - a.second));
  for (int s = 1; s < steps; ++s) {
    const double t = static_cast<double>(s) / steps;
    if (!room.get(static_cast<int>(std::lround(a.first + t * (b.first - a.first))),
                  static_cast<int>(std::lround(a.second + t * (b.second - a.second)))))
      return false;
  }
  return true;
}

/// Breadth first to the window's border; empty if it cannot be reached.
Polyline path_out(const BitGrid& room, const Point& pose) {
  const Point at = (pose - room.origin) / room.cell;
  const int ci = static_cast<int>(std::floor(at.x())), cj = static_cast<int>(std::floor(at.y()));
  std::vector<std::int32_t> from(room.bits.size(), -1);
  std::vector<std::uint32_t> queue;
  std::vector<std::int32_t> steps;
  const auto see = [&](int i, int j, std::int32_t by, std::int32_t step) {
    if (!room.get(i, j) || from[room.at(i, j)] >= 0) return;
    from[room.at(i, j)] = by < 0 ? static_cast<std::int32_t>(room.at(i, j)) : by;
    queue.push_back(static_cast<std::uint32_t>(room.at(i, j)));
    steps.push_back(step);
  };
  see(ci, cj, -1, 0);
  for (int y = -kBegin; y <= kBegin; ++y)
    for (int x = -kBegin; x <= kBegin; ++x) see(ci + x, cj + y, -1, std::abs(x) + std::abs(y));
  const auto columns = static_cast<std::size_t>(room.columns);
  std::int64_t best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const int i = static_cast<int>(queue[k] % columns), j = static_cast<int>(queue[k] / columns);
    if (i == 0 || j == 0 || i == room.columns - 1 || j == room.rows - 1) {
      const double whole = steps[k] + (room.rows - j);  // to the place far up
      if (whole < least) {
        least = whole;
        best = queue[k];
      }
      continue;
    }
    const auto by = static_cast<std::int32_t>(queue[k]);
    for (const auto& [x, y] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)})
      see(i + x, j + y, by, steps[k] + 1);
  }
  if (best < 0) return {};
  std::vector<std::pair<int, int>> cells;
  for (auto c = static_cast<std::int32_t>(best);; c = from[static_cast<std::size_t>(c)]) {
    cells.emplace_back(static_cast<int>(static_cast<std::size_t>(c) % columns),
                       static_cast<int>(static_cast<std::size_t>(c) / columns));
    if (from[static_cast<std::size_t>(c)] == c) break;
  }
  std::reverse(cells.begin(), cells.end());
  Polyline way{pose, room.centre(cells[0].first, cells[0].second)};
  for (std::size_t k = 0; k + 1 < cells.size();) {
    std::size_t next = k + 1;
    while (next + 1 < cells.size() && clear(room, cells[k], cells[next + 1])) ++next;
    way.push_back(room.centre(cells[next].first, cells[next].second));
    k = next;
  }
  return way;
}

/// As much of the way as is believed free, to within `step` metres.
Polyline known_part(const Belief& belief, const Polyline& way, double radius, double step) {
  Polyline part{way.front()};
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double far = distance(part.back(), way[k]);
    const Point a = part.back();
    if (belief.free_for(a, way[k], radius)) {
      if (far > 0) part.push_back(way[k]);
      continue;
    }
    double free = 0;
    for (double s = step; s < far && belief.free_for(lerp(a, way[k], free / far), lerp(a, way[k], s / far), radius);
         s += step)
      free = s;
    if (free > 0) part.push_back(lerp(a, way[k], free / far));
    break;
  }
  return part;
}

}  // namespace

std::optional<Motion> WorldScan::next(const View& view) {
  const Robot& robot = view.robot();
  const double size = robot.radius > 0 ? robot.radius : robot.tool_width / 2;
  const double radius = std::max(0.0, robot.radius - 5e-7 * robot.tool_width);
  while (refused_.size() < kMost) {
    const BitGrid room = room_of(view.belief().cells(Belief::kCoarsest), robot.radius, refused_);
    const Polyline way = path_out(room, view.pose());
    if (way.empty()) return std::nullopt;
    Polyline part = known_part(view.belief(), way, radius, size / 8);
    if (length(part) > size / 4) return Motion{std::move(part), false};
    Point ahead = way.back();
    double left = length(part) + size / 2;
    for (std::size_t k = 1; k < way.size(); ++k) {
      const double far = distance(way[k - 1], way[k]);
      if (far >= left) {
        ahead = lerp(way[k - 1], way[k], left / far);
        break;
      }
      left -= far;
    }
    refused_.push_back(ahead);
  }
  return std::nullopt;
}

}  // namespace oxturn

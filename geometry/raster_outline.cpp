// Method      Each boundary is walked with the set cell on the left. At a grid point where two set cells share only
//             that corner, the walk turns left, so that they stay apart; where two clear cells do, the walk visits the
//             point twice and is cut there into loops, so that no ring touches itself.
#include <array>
#include <map>

#include "base/graph_search.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

struct GridPoint {
  int x, y;
  auto operator<=>(const GridPoint&) const = default;
};
using Loop = std::vector<GridPoint>;

// Directions 0 to 3: east, north, west, south.
constexpr std::array<GridPoint, 4> kStep{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
// The cells ahead of a grid point, on the left and on the right of the direction of the walk, relative to the point.
constexpr std::array<GridPoint, 4> kLeftAhead{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
constexpr std::array<GridPoint, 4> kRightAhead{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};

/// 4-connected components of the set cells, numbered in row order.
ConnectedComponents components(const BitGrid& grid) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  return connected_components(
      grid.bits.size(), [&](std::size_t c) { return grid.bits[c] != 0; },
      [&](std::size_t c, auto reach) {
        const int i = static_cast<int>(c % columns), j = static_cast<int>(c / columns);
        for (const GridPoint& d : kStep)
          if (grid.inside(i + d.x, j + d.y)) reach(grid.at(i + d.x, j + d.y));
      });
}

/// Cuts a closed walk into loops that visit no point twice.
std::vector<Loop> loops_of(const Loop& walk) {
  std::map<GridPoint, std::ptrdiff_t> position;  // in `rest`
  std::vector<Loop> loops;
  Loop rest;  // of the walk so far
  for (const GridPoint& p : walk) {
    if (const auto met = position.find(p); met != position.end()) {
      const auto begin = rest.begin() + met->second;
      loops.emplace_back(begin, rest.end());
      rest.erase(begin, rest.end());
      for (const GridPoint& q : loops.back()) position.erase(q);
    }
    position[p] = std::ssize(rest);
    rest.push_back(p);
  }
  loops.push_back(std::move(rest));
  return loops;
}

bool counter_clockwise(const Loop& loop) {
  std::int64_t twice_area = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const GridPoint &a = loop[k], &b = loop[k + 1 == loop.size() ? 0 : k + 1];
    twice_area += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return twice_area > 0;
}

/// Walks boundaries and remembers which lower sides of set cells it has passed.
class Outliner {
 public:
  explicit Outliner(const BitGrid& grid) : grid_(grid), passed_(grid.bits.size(), 0) {}

  /// Does a ring that is still to be walked run along the lower side of the cell?
  bool begins_ring(int i, int j) const {
    return grid_.get(i, j) && !grid_.get(i, j - 1) && passed_[grid_.at(i, j)] == 0;
  }
  /// The ring along the lower side of the cell, eastwards; several where it meets itself.
  std::vector<Loop> rings_from(int i, int j) {
    const GridPoint start{i, j};
    Loop walk;
    bool meets_itself = false;
    GridPoint at = start;
    std::size_t direction = 0;
    do {
      if (direction == 0) passed_[grid_.at(at.x, at.y)] = 1;
      at = {at.x + kStep[direction].x, at.y + kStep[direction].y};
      std::size_t next = direction;
      const bool right = set(at, kRightAhead[direction]);
      if (!set(at, kLeftAhead[direction])) {
        next = (direction + 1) % 4;
        meets_itself = meets_itself || right;
      } else if (right) {
        next = (direction + 3) % 4;
      }
      if (next != direction) walk.push_back(at);
      direction = next;
    } while (at != start || direction != 0);
    return meets_itself ? loops_of(walk) : std::vector<Loop>{walk};
  }

 private:
  bool set(const GridPoint& at, const GridPoint& offset) const { return grid_.get(at.x + offset.x, at.y + offset.y); }

  const BitGrid& grid_;
  std::vector<std::uint8_t> passed_;
};

}  // namespace

Region trace(const BitGrid& grid) {
  const ConnectedComponents component = components(grid);
  Region region;
  region.polygons.resize(static_cast<std::size_t>(component.count));
  Outliner outliner(grid);
  // Row order meets a component's outer ring before its holes.
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      if (!outliner.begins_ring(i, j)) continue;
      Polygon& polygon = region.polygons[static_cast<std::size_t>(component.of[grid.at(i, j)])];
      for (const Loop& loop : outliner.rings_from(i, j)) {
        Ring ring;
        for (const GridPoint& c : loop) ring.push_back(grid.origin + grid.cell * Point(c.x, c.y));
        if (counter_clockwise(loop))
          polygon.outer = std::move(ring);
        else
          polygon.holes.push_back(std::move(ring));
      }
    }
  return region;
}

}  // namespace oxturn

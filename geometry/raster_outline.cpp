// Boundaries are walked with the set cell at the left. A walk that comes back to a corner (clear cells that share
// only that corner, next to it) is cut there, so that no ring touches itself: its loops are rings of their own.
#include <algorithm>
#include <array>

#include "geometry/raster.hpp"

namespace oxturn {
namespace {

struct Corner {
  int x, y;
};
constexpr std::array<Corner, 4> kStep{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};  // east, north, west, south
// The cells ahead of a corner, to the left and to the right of the way, relative to the corner.
constexpr std::array<Corner, 4> kLeftAhead{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
constexpr std::array<Corner, 4> kRightAhead{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};

// 4-connected components of the set cells, numbered from 0 in row order; -1 for clear cells.
std::vector<std::int32_t> components(const BitGrid& grid, std::size_t& count) {
  std::vector<std::int32_t> label(grid.bits.size(), -1);
  std::vector<Corner> stack;
  count = 0;
  for (int j0 = 0; j0 < grid.rows; ++j0)
    for (int i0 = 0; i0 < grid.columns; ++i0) {
      if (!grid.get(i0, j0) || label[grid.at(i0, j0)] >= 0) continue;
      const auto number = static_cast<std::int32_t>(count++);
      label[grid.at(i0, j0)] = number;
      stack.push_back({i0, j0});
      while (!stack.empty()) {
        const Corner c = stack.back();
        stack.pop_back();
        for (const Corner& d : kStep) {
          const int i = c.x + d.x, j = c.y + d.y;
          if (!grid.get(i, j) || label[grid.at(i, j)] >= 0) continue;
          label[grid.at(i, j)] = number;
          stack.push_back({i, j});
        }
      }
    }
  return label;
}

/// Cuts a walk where it meets itself.
std::vector<std::vector<Corner>> loops_of(const std::vector<Corner>& walk) {
  const auto key = [](const Corner& c) { return std::pair(c.y, c.x); };
  std::vector<std::size_t> order(walk.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(walk[a]) < key(walk[b]); });
  std::vector<std::size_t> place(walk.size());  // equal corners, equal number
  for (std::size_t k = 1; k < order.size(); ++k)
    place[order[k]] = place[order[k - 1]] + (key(walk[order[k]]) != key(walk[order[k - 1]]) ? 1 : 0);
  constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
  std::vector<std::size_t> position(walk.size(), kNowhere), stack;
  std::vector<std::vector<Corner>> loops;
  for (std::size_t k = 0; k < walk.size(); ++k) {
    const std::size_t at = position[place[k]];
    if (at != kNowhere) {
      std::vector<Corner> loop;
      for (std::size_t s = at; s < stack.size(); ++s) {
        loop.push_back(walk[stack[s]]);
        position[place[stack[s]]] = kNowhere;
      }
      stack.resize(at);
      loops.push_back(std::move(loop));
    }
    position[place[k]] = stack.size();
    stack.push_back(k);
  }
  std::vector<Corner> rest;
  for (const std::size_t k : stack) rest.push_back(walk[k]);
  loops.push_back(std::move(rest));
  return loops;
}

bool counter_clockwise(const std::vector<Corner>& loop) {
  std::int64_t twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Corner &a = loop[k], &b = loop[k + 1 == loop.size() ? 0 : k + 1];
    twice += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return twice > 0;
}

}  // namespace

Region trace(const BitGrid& grid) {
  std::size_t count = 0;
  const std::vector<std::int32_t> label = components(grid, count);
  Region region;
  region.polygons.resize(count);
  std::vector<std::uint8_t> done(grid.bits.size(), 0);  // the cell's lower side has been walked

  // Every ring has a lower side of a set cell, walked eastwards with the cell at the left. Row order meets a
  // component's outer ring before its holes.
  for (int j0 = 0; j0 < grid.rows; ++j0)
    for (int i0 = 0; i0 < grid.columns; ++i0) {
      if (!grid.get(i0, j0) || grid.get(i0, j0 - 1) || done[grid.at(i0, j0)]) continue;
      std::vector<Corner> walk;
      bool meets_itself = false;
      Corner at{i0, j0};
      std::size_t way = 0;
      do {
        if (way == 0) done[grid.at(at.x, at.y)] = 1;
        at = {at.x + kStep[way].x, at.y + kStep[way].y};
        // Left first: cells that share only a corner stay apart.
        std::size_t turn = way;
        const bool right = grid.get(at.x + kRightAhead[way].x, at.y + kRightAhead[way].y);
        if (!grid.get(at.x + kLeftAhead[way].x, at.y + kLeftAhead[way].y)) {
          turn = (way + 1) % 4;
          meets_itself = meets_itself || right;
        } else if (right) {
          turn = (way + 3) % 4;
        }
        if (turn != way) walk.push_back(at);
        way = turn;
      } while (at.x != i0 || at.y != j0 || way != 0);
      Polygon& polygon = region.polygons[static_cast<std::size_t>(label[grid.at(i0, j0)])];
      const auto add = [&](const std::vector<Corner>& loop) {
        Ring ring;
        for (const Corner& c : loop) ring.push_back(grid.origin + grid.cell * Point(c.x, c.y));
        if (counter_clockwise(loop))
          polygon.outer = std::move(ring);
        else
          polygon.holes.push_back(std::move(ring));
      };
      if (!meets_itself)
        add(walk);
      else
        for (const auto& loop : loops_of(walk)) add(loop);
    }
  return region;
}

}  // namespace oxturn

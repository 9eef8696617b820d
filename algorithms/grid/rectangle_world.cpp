#include "algorithms/grid/rectangle_world.hpp"

#include <algorithm>

namespace oxturn {
namespace {

// Closes short free runs along one axis: step (1, 0) for rows, (0, 1) for columns. Only walls of `free` itself count,
// so the two axes do not feed each other.
void close_runs(const BitGrid& free, int gap, bool rows, BitGrid& mended) {
  const int lines = rows ? free.rows : free.columns, along = rows ? free.columns : free.rows;
  for (int line = 0; line < lines; ++line) {
    const auto get = [&](int k) { return rows ? free.get(k, line) : free.get(line, k); };
    for (int k = 1; k < along;) {  // the border of the grid is no wall: a run that touches it is no gap
      if (!get(k) || get(k - 1)) {
        ++k;
        continue;
      }
      int end = k;
      while (end < along && get(end)) ++end;
      if (end < along && end - k <= gap)
        for (int m = k; m < end; ++m) rows ? mended.set(m, line, false) : mended.set(line, m, false);
      k = end;
    }
  }
}

// Numbers of the small wall components (8-connected), 0 for everything else.
std::vector<int> small_obstacles(const BitGrid& free, int small) {
  std::vector<int> label(free.bits.size(), 0);
  std::vector<std::uint8_t> seen(free.bits.size(), 0);
  std::vector<std::pair<int, int>> queue;
  int count = 0;
  for (int j0 = 0; j0 < free.rows; ++j0)
    for (int i0 = 0; i0 < free.columns; ++i0) {
      if (free.get(i0, j0) || seen[free.at(i0, j0)]) continue;
      queue.assign(1, {i0, j0});
      seen[free.at(i0, j0)] = 1;
      int left = i0, right = i0, bottom = j0, top = j0;
      bool border = false;
      for (std::size_t k = 0; k < queue.size(); ++k) {
        const auto [i, j] = queue[k];
        left = std::min(left, i);
        right = std::max(right, i);
        bottom = std::min(bottom, j);
        top = std::max(top, j);
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di) {
            if (!free.inside(i + di, j + dj)) {
              border = true;
              continue;
            }
            std::uint8_t& mark = seen[free.at(i + di, j + dj)];
            if (mark || free.get(i + di, j + dj)) continue;
            mark = 1;
            queue.push_back({i + di, j + dj});
          }
      }
      if (border || right - left + 1 > small || top - bottom + 1 > small) continue;
      ++count;
      for (const auto& [i, j] : queue) label[free.at(i, j)] = count;
    }
  return label;
}

}  // namespace

BitGrid without_gaps(const BitGrid& free, int gap, int small) {
  BitGrid mended = free;
  if (gap > 0) {
    close_runs(free, gap, true, mended);
    close_runs(free, gap, false, mended);
  }
  if (small <= 0) return mended;
  const BitGrid closed = mended;
  const std::vector<int> label = small_obstacles(closed, small);
  const auto obstacle = [&](int i, int j) { return closed.inside(i, j) ? label[closed.at(i, j)] : 0; };
  for (int j = 0; j < closed.rows; ++j)
    for (int i = 0; i < closed.columns; ++i) {
      if (!closed.get(i, j)) continue;
      for (const int beside : {obstacle(i - 1, j), obstacle(i + 1, j)})
        if (beside != 0 && (beside == obstacle(i, j - 1) || beside == obstacle(i, j + 1))) mended.set(i, j, false);
    }
  return mended;
}

std::vector<CellRectangle> rectangles_of(const BitGrid& free, bool by_rows) {
  std::vector<CellRectangle> found;
  BitGrid left = free;  // not yet in a rectangle
  const auto room = [&](int i, int j, int most) {
    int run = 0;
    while (run < most && left.get(i, j + run)) ++run;
    return run;
  };
  const auto start = [&](int i, int j) {
    if (!left.get(i, j)) return;
    const int height = room(i, j, free.rows);
    CellRectangle r{i, j, i, j + height - 1};
    while (room(r.right + 1, j, height) == height) ++r.right;
    for (int y = r.bottom; y <= r.top; ++y)
      for (int x = r.left; x <= r.right; ++x) left.set(x, y, false);
    found.push_back(r);
  };
  if (by_rows) {
    for (int j = 0; j < free.rows; ++j)
      for (int i = 0; i < free.columns; ++i) start(i, j);
  } else {
    for (int i = 0; i < free.columns; ++i)
      for (int j = 0; j < free.rows; ++j) start(i, j);
  }
  return found;
}

}  // namespace oxturn

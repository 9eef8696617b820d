#include "algorithms/grid/rectangle_world.hpp"

#include <algorithm>

#include "base/graph_search.hpp"

namespace oxturn {
namespace {

/// Calls close(k) for the cells of free runs of at most `gap` cells in a line of n. The border of the grid is no wall,
/// so a run that touches it is no gap.
template <class IsFree, class Close>
void close_gaps_in_line(int n, int gap, IsFree is_free, Close close) {
  for (int k = 1; k < n;) {
    if (!is_free(k) || is_free(k - 1)) {
      ++k;
      continue;
    }
    int end = k;
    while (end < n && is_free(end)) ++end;
    if (end < n && end - k <= gap)
      for (int m = k; m < end; ++m) close(m);
    k = end;
  }
}

/// In rows and columns. Only walls of `free` itself count, so one axis does not affect the other.
BitGrid with_gaps_closed(const BitGrid& free, int gap) {
  BitGrid closed = free;
  for (int j = 0; j < free.rows; ++j)
    close_gaps_in_line(
        free.columns, gap, [&](int i) { return free.get(i, j); }, [&](int i) { closed.set(i, j, false); });
  for (int i = 0; i < free.columns; ++i)
    close_gaps_in_line(
        free.rows, gap, [&](int j) { return free.get(i, j); }, [&](int j) { closed.set(i, j, false); });
  return closed;
}

/// The connected components of the walls (by eight neighbours) that are at most `small` cells a side and do not touch
/// the border of the grid.
class SmallObstacles {
 public:
  SmallObstacles(const BitGrid& free, int small) : free_(free) {
    const auto columns = static_cast<std::size_t>(free.columns);
    walls_ = connected_components(
        free.bits.size(), [&](std::size_t c) { return free.bits[c] == 0; },
        [&](std::size_t c, const auto& reach) {
          const int i = static_cast<int>(c % columns), j = static_cast<int>(c / columns);
          for (int y = j - 1; y <= j + 1; ++y)
            for (int x = i - 1; x <= i + 1; ++x)
              if (free.inside(x, y)) reach(free.at(x, y));
        });
    std::vector<CellRectangle> boxes(static_cast<std::size_t>(walls_.count),
                                     {free.columns, free.rows, -1, -1});  // empty
    for (int j = 0; j < free.rows; ++j)
      for (int i = 0; i < free.columns; ++i) {
        const std::int32_t wall = walls_.of[free.at(i, j)];
        if (wall < 0) continue;
        CellRectangle& box = boxes[static_cast<std::size_t>(wall)];
        box = {std::min(box.left, i), std::min(box.bottom, j), std::max(box.right, i), std::max(box.top, j)};
      }
    for (const CellRectangle& box : boxes)
      small_.push_back(box.left > 0 && box.bottom > 0 && box.right < free.columns - 1 && box.top < free.rows - 1 &&
                       box.width() <= small && box.height() <= small);
  }
  /// The number of the small obstacle that contains the cell; -1 for none.
  std::int32_t at(int i, int j) const {
    const std::int32_t wall = free_.inside(i, j) ? walls_.of[free_.at(i, j)] : -1;
    return wall >= 0 && small_[static_cast<std::size_t>(wall)] ? wall : -1;
  }

 private:
  const BitGrid& free_;
  ConnectedComponents walls_;
  std::vector<bool> small_;
};

}  // namespace

BitGrid without_gaps(const BitGrid& free, int gap, int small) {
  const BitGrid closed = gap > 0 ? with_gaps_closed(free, gap) : free;
  if (small <= 0) return closed;
  BitGrid filled = closed;
  const SmallObstacles obstacles(closed, small);
  for (int j = 0; j < closed.rows; ++j)
    for (int i = 0; i < closed.columns; ++i) {
      if (!closed.get(i, j)) continue;
      for (const std::int32_t beside : {obstacles.at(i - 1, j), obstacles.at(i + 1, j)})
        if (beside >= 0 && (beside == obstacles.at(i, j - 1) || beside == obstacles.at(i, j + 1)))
          filled.set(i, j, false);
    }
  return filled;
}

std::vector<CellRectangle> rectangles_of(const BitGrid& free, ScanOrder order) {
  std::vector<CellRectangle> found;
  BitGrid left = free;  // not yet in a rectangle
  const auto room_above = [&](int i, int j, int most) {
    int run = 0;
    while (run < most && left.get(i, j + run)) ++run;
    return run;
  };
  const auto start_at = [&](int i, int j) {
    if (!left.get(i, j)) return;
    const int height = room_above(i, j, free.rows);
    CellRectangle r{i, j, i, j + height - 1};
    while (room_above(r.right + 1, j, height) == height) ++r.right;
    for (int y = r.bottom; y <= r.top; ++y)
      for (int x = r.left; x <= r.right; ++x) left.set(x, y, false);
    found.push_back(r);
  };
  if (order == ScanOrder::rows) {
    for (int j = 0; j < free.rows; ++j)
      for (int i = 0; i < free.columns; ++i) start_at(i, j);
  } else {
    for (int i = 0; i < free.columns; ++i)
      for (int j = 0; j < free.rows; ++j) start_at(i, j);
  }
  return found;
}

}  // namespace oxturn

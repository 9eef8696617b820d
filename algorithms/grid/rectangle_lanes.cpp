#include "algorithms/grid/rectangle_lanes.hpp"

#include <algorithm>

namespace oxturn {
namespace {

/// The first of the rectangle's columns (rows).
Lane first_line(const CellRectangle& r, bool upright) {
  return upright ? Lane{true, r.left, r.bottom, r.top} : Lane{false, r.bottom, r.left, r.right};
}

}  // namespace

RectangleLanes::RectangleLanes(const GridGraph& graph, const RectangleOptions& options, const Robot& robot)
    : graph_(graph),
      along_(options.along),
      smallest_(options.cells_needed(robot)),
      shift_(options.shift),
      distance_(options.lane_distance(robot)) {}

std::vector<Lane> RectangleLanes::runs(const Lane& whole) const {
  std::vector<Lane> found;
  for (int k = whole.low; k <= whole.high; ++k) {
    if (!free(whole, k)) continue;
    int end = k;
    while (end < whole.high && passable(whole, end)) ++end;
    found.push_back({whole.upright, whole.line, k, end});
    k = end;
  }
  return found;
}

std::optional<Lane> RectangleLanes::start_of(CellRectangle& r) const {
  if (r.width() < smallest_ || r.height() < smallest_) return std::nullopt;
  const auto in_column = [&] { return runs({true, r.left, r.bottom, std::min(r.top, r.bottom + shift_)}); };
  while (r.left <= r.right && in_column().empty()) ++r.left;
  if (r.left > r.right) return std::nullopt;
  if (upright(r)) return in_column().front();
  std::vector<Lane> in_row;
  while ((in_row = runs(first_line(r, false))).empty()) ++r.bottom;
  return in_row.front();
}

RectangleLanes::Found RectangleLanes::in(const CellRectangle& r, const Lane& start) const {
  const Lane first = first_line(r, start.upright);
  const int last = start.upright ? r.right : r.top;
  Found found;
  found.before_start = {first.upright, first.line, first.low, start.low - 1};
  // By cell of a line: the last line in which it was driven.
  std::vector<int> driven(static_cast<std::size_t>(first.high - first.low) + 1, first.line - distance_);
  const auto driven_at = [&](int k) -> int& { return driven[static_cast<std::size_t>(k - first.low)]; };
  for (Lane line = first; line.line <= last; ++line.line) {
    Lane beyond = line;
    ++beyond.line;
    const auto is_needed = [&](int k) {
      return line.line - driven_at(k) >= distance_ || line.line == last || !free(beyond, k);
    };
    line.low = line.line == start.line ? start.low : first.low;
    const std::vector<Lane> all = runs(line);
    line.low = first.low;
    if (all.empty()) found.skipped.push_back(line);
    for (const Lane& run : all) {
      bool needed = false;
      for (int k = run.low; k <= run.high && !needed; ++k) needed = is_needed(k);
      if (!needed) continue;
      for (int k = run.low; k <= run.high; ++k) driven_at(k) = run.line;
      found.lanes.push_back(run);
    }
  }
  return found;
}

}  // namespace oxturn

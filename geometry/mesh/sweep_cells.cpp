// The cells of the plane sweep: boustrophedon cells and trapezoids.
//
// Method      The plane sweep breaks ties of x by y, so a vertical wall can cause a cut that no critical point asks
//             for. Wherever exactly one cell meets exactly one cell across a cut, the two are joined again. So vertical
//             walls in floor and ceiling make no cells of their own, and cells are still monotone in x.
// Source      Choset and Pignon, "Coverage path planning: the boustrophedon cellular decomposition", 1997.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/sorting.hpp"
#include "geometry/mesh/partition.hpp"
#include "geometry/mesh/plane_sweep.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The left or right side of a cell.
struct Side {
  double x, low, high;
  std::size_t cell;
  bool operator<(const Side& o) const { return x != o.x ? x < o.x : low != o.low ? low < o.low : cell < o.cell; }
};

/// Pairs (left cell, right cell) that share part of a cut.
std::vector<std::pair<std::size_t, std::size_t>> contacts(const std::vector<PlaneSweepCell>& cells) {
  std::vector<Side> left_sides, right_sides;  // sorted, and disjoint at each x
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const PlaneSweepCell& c = cells[i];
    left_sides.push_back({c.lower.front().point.x(), c.lower.front().point.y(), c.upper.front().point.y(), i});
    right_sides.push_back({c.lower.back().point.x(), c.lower.back().point.y(), c.upper.back().point.y(), i});
  }
  std::sort(left_sides.begin(), left_sides.end());
  std::sort(right_sides.begin(), right_sides.end());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t r = 0, l = 0; r < right_sides.size() && l < left_sides.size();) {
    const Side &right = right_sides[r], &left = left_sides[l];
    if (right.x != left.x) {
      right.x < left.x ? ++r : ++l;
      continue;
    }
    if (std::min(right.high, left.high) > std::max(right.low, left.low)) pairs.emplace_back(right.cell, left.cell);
    right.high < left.high ? ++r : ++l;
  }
  return pairs;
}

/// Appends a chain at the cut that is undone: a common point that is no vertex of the region disappears.
void append(Chain& chain, const Chain& more) {
  auto from = more.begin();
  if (chain.back().point == from->point) {
    if (chain.back().is_vertex || from->is_vertex)
      chain.back().is_vertex = true;
    else
      chain.pop_back();
    ++from;
  }
  chain.insert(chain.end(), from, more.end());
}

Polyline points(const Chain& chain) {
  Polyline line;
  for (const ChainPoint& p : chain)
    if (line.empty() || line.back() != p.point) line.push_back(p.point);
  return line;
}

/// For each cell the one that continues it across a cut that is not needed, or kNone.
std::vector<std::size_t> continuations(std::size_t cells,
                                       const std::vector<std::pair<std::size_t, std::size_t>>& contacts) {
  std::vector<int> to_right(cells, 0), to_left(cells, 0);
  for (const auto& [left, right] : contacts) {
    ++to_right[left];
    ++to_left[right];
  }
  std::vector<std::size_t> next(cells, kNone);
  for (const auto& [left, right] : contacts)
    if (to_right[left] == 1 && to_left[right] == 1) next[left] = right;
  return next;
}

/// Takes cuts out of `next`, along each chain of cells wherever what lies between cuts is at least so wide.
void keep_cuts(const std::vector<PlaneSweepCell>& cells, double least, std::vector<std::size_t>& next) {
  std::vector<bool> begins(cells.size(), true);
  for (const std::size_t k : next)
    if (k != kNone) begins[k] = false;
  const auto left = [&](std::size_t c) { return cells[c].lower.front().point.x(); };
  const auto right = [&](std::size_t c) { return cells[c].lower.back().point.x(); };
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (!begins[first]) continue;
    std::size_t last = first;
    while (next[last] != kNone) last = next[last];
    double from = left(first);
    for (std::size_t c = first; c != last;) {
      const std::size_t following = next[c];
      if (right(c) - from >= least && right(last) - right(c) >= least) {
        next[c] = kNone;
        from = right(c);
      }
      c = following;
    }
  }
}

/// The cells with unneeded cuts undone: all that leave a part narrower than `least` to their left or right.
std::vector<BoustrophedonCell> joined(std::vector<PlaneSweepCell> cells, double least) {
  const auto pairs = contacts(cells);
  std::vector<std::size_t> next = continuations(cells.size(), pairs);
  if (std::isfinite(least)) keep_cuts(cells, least, next);
  std::vector<bool> continues_another(cells.size(), false);
  for (const std::size_t k : next)
    if (k != kNone) continues_another[k] = true;

  std::vector<BoustrophedonCell> out;
  std::vector<std::size_t> number(cells.size());  // in `out`, of each cell of the sweep
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (continues_another[i]) continue;
    number[i] = out.size();
    for (std::size_t k = next[i]; k != kNone; k = next[k]) {
      append(cells[i].lower, cells[k].lower);
      append(cells[i].upper, cells[k].upper);
      number[k] = out.size();
    }
    out.push_back({points(cells[i].lower), points(cells[i].upper), {}});
  }
  for (const auto& [left, right] : pairs) {
    if (number[left] == number[right]) continue;
    out[number[left]].neighbours.push_back(number[right]);
    out[number[right]].neighbours.push_back(number[left]);
  }
  for (BoustrophedonCell& c : out) sort_unique(c.neighbours);
  return out;
}

}  // namespace

std::vector<BoustrophedonCell> boustrophedon_cells(const Region& region) {
  return joined(plane_sweep_cells(region, Cuts::critical), kInfinity);
}

std::vector<BoustrophedonCell> trapezoid_cells(const Region& region, double least) {
  return joined(plane_sweep_cells(region, Cuts::every_vertex), least);
}

std::vector<Ring> trapezoid_partition(const Region& region) {
  std::vector<Ring> parts;
  for (const PlaneSweepCell& c : plane_sweep_cells(region, Cuts::every_vertex)) {
    Ring ring;
    const auto add = [&](const Point& p) {
      if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
    };
    for (const ChainPoint& p : c.lower) add(p.point);
    for (std::size_t i = c.upper.size(); i-- > 0;) add(c.upper[i].point);
    if (ring.size() >= 3) parts.push_back(std::move(ring));
  }
  return parts;
}

}  // namespace oxturn

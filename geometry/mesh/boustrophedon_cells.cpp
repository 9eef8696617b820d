// Cells from the sweep, joined where a cut was not needed, and the relation between them.
//
// The sweep breaks ties of x by y, so a vertical wall can cause a cut that no critical point asks for. Wherever
// exactly one cell meets exactly one cell across a cut, the two are joined again: the result is the same for
// vertical walls in floor and ceiling, and still monotone in x.
#include <algorithm>

#include "geometry/mesh/partition.hpp"
#include "geometry/mesh/plane_sweep.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The left or right side of a cell.
struct Side {
  double x, low, high;
  std::size_t cell;
  bool operator<(const Side& o) const { return x != o.x ? x < o.x : low != o.low ? low < o.low : cell < o.cell; }
};

/// Pairs (left cell, right cell) that share a stretch of a cut: both lists are sorted and disjoint at each x.
std::vector<std::pair<std::size_t, std::size_t>> contacts(const std::vector<PlaneSweepCell>& cells) {
  std::vector<Side> ends, begins;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const PlaneSweepCell& c = cells[i];
    begins.push_back({c.lower.front().place.x(), c.lower.front().place.y(), c.upper.front().place.y(), i});
    ends.push_back({c.lower.back().place.x(), c.lower.back().place.y(), c.upper.back().place.y(), i});
  }
  std::sort(begins.begin(), begins.end());
  std::sort(ends.begin(), ends.end());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t e = 0, b = 0; e < ends.size() && b < begins.size();) {
    if (ends[e].x != begins[b].x) {
      ends[e].x < begins[b].x ? ++e : ++b;
      continue;
    }
    if (std::min(ends[e].high, begins[b].high) > std::max(ends[e].low, begins[b].low)) {
      pairs.emplace_back(ends[e].cell, begins[b].cell);
    }
    ends[e].high < begins[b].high ? ++e : ++b;
  }
  return pairs;
}

void append(Chain& chain, const Chain& more) {
  std::size_t from = 0;
  if (chain.back().place == more.front().place) {
    if (!chain.back().corner && !more.front().corner) {
      chain.pop_back();  // a cut that is no more
      from = 1;
    } else {
      chain.back().corner = true;
      from = 1;
    }
  }
  chain.insert(chain.end(), more.begin() + static_cast<std::ptrdiff_t>(from), more.end());
}

Polyline points(const Chain& chain) {
  Polyline line;
  for (const ChainPoint& p : chain) {
    if (line.empty() || line.back() != p.place) line.push_back(p.place);
  }
  return line;
}

}  // namespace

std::vector<BoustrophedonCell> boustrophedon_cells(const Region& region) {
  std::vector<PlaneSweepCell> cells = plane_sweep_cells(region, Cuts::critical);
  const auto pairs = contacts(cells);
  std::vector<int> to_right(cells.size(), 0), to_left(cells.size(), 0);
  for (const auto& [left, right] : pairs) {
    ++to_right[left];
    ++to_left[right];
  }
  std::vector<std::size_t> next(cells.size(), kNone);
  std::vector<bool> joined(cells.size(), false);
  for (const auto& [left, right] : pairs) {
    if (to_right[left] != 1 || to_left[right] != 1) continue;
    next[left] = right;
    joined[right] = true;
  }
  std::vector<BoustrophedonCell> out;
  std::vector<std::size_t> number(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (joined[i]) continue;
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
  for (BoustrophedonCell& c : out) {
    std::sort(c.neighbours.begin(), c.neighbours.end());
    c.neighbours.erase(std::unique(c.neighbours.begin(), c.neighbours.end()), c.neighbours.end());
  }
  return out;
}

}  // namespace oxturn

#include "geometry/raster_rows.hpp"

#include <algorithm>

#include "geometry/centre_crossings.hpp"

namespace oxturn {
namespace {

struct RowsFrame {
  Point origin;
  double cell;
  int columns, rows;
};

/// Columns of each row, sorted.
struct SortedColumns {
  std::vector<std::int32_t> all;
  std::vector<std::size_t> first;  // of each row

  std::span<const std::int32_t> row(std::size_t j) const { return {all.data() + first[j], first[j + 1] - first[j]}; }
};
struct CentreMark {
  std::int32_t row, column;
};

SortedColumns by_row(const std::vector<CentreMark>& marks, int rows) {
  SortedColumns sorted;
  sorted.all.resize(marks.size());
  sorted.first.resize(static_cast<std::size_t>(rows) + 1);
  for (const CentreMark& m : marks) ++sorted.first[static_cast<std::size_t>(m.row) + 1];
  for (std::size_t j = 1; j < sorted.first.size(); ++j) sorted.first[j] += sorted.first[j - 1];
  std::vector<std::size_t> next(sorted.first.begin(), sorted.first.end() - 1);
  for (const CentreMark& m : marks) sorted.all[next[static_cast<std::size_t>(m.row)]++] = m.column;
  const auto at = [&](std::size_t k) { return sorted.all.begin() + static_cast<std::ptrdiff_t>(k); };
  for (std::size_t j = 0; j + 1 < sorted.first.size(); ++j) std::sort(at(sorted.first[j]), at(sorted.first[j + 1]));
  return sorted;
}

}  // namespace

RasterRows::RasterRows(const Region& region, const Point& origin, double cell, int columns, int rows)
    : columns_(columns) {
  std::vector<CentreMark> flips, on_edge;
  for_each_centre_crossing(
      region, RowsFrame{origin, cell, columns, rows},
      [&](int i, int j) {
        flips.push_back({j, i});
      },
      [&](int i, int j) {
        on_edge.push_back({j, i});
      });
  const SortedColumns inside = by_row(flips, rows), edges = by_row(on_edge, rows);
  for (std::size_t j = 0; j < static_cast<std::size_t>(rows); ++j) {
    first_.push_back(runs_.size());
    const std::span<const std::int32_t> ends = inside.row(j);
    std::vector<Run> found;
    for (const std::int32_t i : edges.row(j)) found.push_back({i, i + 1});
    for (std::size_t k = 0; k < ends.size(); k += 2)
      found.push_back({ends[k], k + 1 < ends.size() ? ends[k + 1] : columns});
    std::ranges::sort(found, {}, &Run::low);
    for (const Run& run : found) {
      if (run.low >= run.high) continue;
      if (runs_.size() > first_.back() && run.low <= runs_.back().high)
        runs_.back().high = std::max(runs_.back().high, run.high);
      else
        runs_.push_back(run);
    }
  }
  first_.push_back(runs_.size());
}

}  // namespace oxturn

/// Which pairs of segments come near each other? Private to geometry, not installed.
///
///   for_close_pairs(n, segment, 1.0, {}, [&](std::uint32_t i, std::uint32_t j) { /* candidates */ });
///
/// Up to some thousand segments are swept by x: each is compared with those that begin before it ends, usually a few.
/// More are distributed to the cells of a grid over their box and clipped to them, and each cell is swept. Where
/// segments overlap in x too much, cells are divided by smaller grids, and where these do not help (all detail in one
/// corner, or long segments), space is halved at the mean of the segments' ends. O(n + pairs) for segments spread
/// evenly and in the order of their left ends, O(n log n + pairs) for other usual data. UniformGrid would not do: it
/// does not adapt to crowded areas, and searching it pair by pair costs the square of the segments in a cell.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace oxturn {

/// A segment, or the part of it in a cell.
struct SegmentPart {
  double x0, y0, x1, y1;  // x0 <= x1; y0 is the height at x0
  std::uint32_t id;
};

template <class At, class F>
class ClosePairs {
 public:
  ClosePairs(std::size_t n, At at, double slack, const std::vector<std::uint8_t>& active, F f)
      : slack_(slack), active_(active), f_(std::move(f)) {
    if (n > kMany && distribute(n, at, extent(n, at), 0)) return;
    arena_.reserve(3 * n);
    for (std::size_t k = 0; k < n; ++k) arena_.push_back(at(k));
    search(0, n, 0);
  }

 private:
  static constexpr std::size_t kFew = 24;       // each is compared with each
  static constexpr std::size_t kMany = 2048;    // too many to be swept without a grid
  static constexpr std::size_t kOverlaps = 64;  // comparisons for each segment, above which a grid finds fewer
  static constexpr std::size_t kWorthGrid = 256;
  static constexpr std::size_t kInCell = 512;  // of the first grid: so many are swept
  static constexpr int kDeepest = 60;

  bool is_active(const SegmentPart& s) const { return active_.empty() || active_[s.id] != 0; }

  /// Sweeps a range of the arena by x: each segment is compared with those that begin before it ends. False, if that
  /// takes more than `most` comparisons; some pairs have been found by then.
  bool sweep(std::size_t begin, std::size_t end, std::size_t most) {
    const auto first = arena_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = arena_.begin() + static_cast<std::ptrdiff_t>(end);
    const auto by_left_end = [](const SegmentPart& s, const SegmentPart& t) { return s.x0 < t.x0; };
    if (!std::is_sorted(first, last, by_left_end)) std::sort(first, last, by_left_end);
    actives_.clear();
    if (!active_.empty())
      for (std::size_t i = begin; i < end; ++i)
        if (is_active(arena_[i])) actives_.push_back(i);
    std::size_t compared = 0, next = 0;  // the first of actives_ behind i
    for (std::size_t i = begin; i < end; ++i) {
      if (next < actives_.size() && actives_[next] == i) ++next;
      if (is_active(arena_[i]))
        compared += compare(i, i + 1, end, [](std::size_t j) { return j; });
      else
        compared += compare(i, next, actives_.size(), [this](std::size_t k) { return actives_[k]; });
      if (compared > most) return false;
    }
    return true;
  }
  /// Compares segment i with the segments at(from), at(from + 1), ... before at(to) that begin before it ends; returns
  /// how many these are.
  template <class Where>
  std::size_t compare(std::size_t i, std::size_t from, std::size_t to, Where at) {
    const SegmentPart a = arena_[i];
    const double low = std::min(a.y0, a.y1) - slack_, high = std::max(a.y0, a.y1) + slack_, right = a.x1 + slack_;
    constexpr std::size_t kAtATime = 32;
    std::array<std::uint32_t, kAtATime> met;
    std::size_t k = from;
    for (bool more = true; more;) {
      std::size_t count = 0;
      const std::size_t stop = std::min(to, k + kAtATime);
      for (; k < stop; ++k) {
        const SegmentPart& b = arena_[at(k)];
        if (b.x0 > right) break;
        met[count] = b.id;  // kept if they meet: without a branch, which would be mispredicted often
        count += static_cast<std::size_t>(std::min(b.y0, b.y1) <= high) &
                 static_cast<std::size_t>(std::max(b.y0, b.y1) >= low);
      }
      more = k == stop && k < to;
      for (std::size_t m = 0; m < count; ++m) f_(a.id, met[m]);
    }
    return k - from;
  }

  void sweep_all(std::size_t begin, std::size_t end) { sweep(begin, end, std::numeric_limits<std::size_t>::max()); }

  /// Clips s to low <= x <= high; s comes to it.
  static void clip_x(SegmentPart& s, double low, double high) {
    const double slope = (s.y1 - s.y0) / (s.x1 - s.x0), x = s.x0, y = s.y0;
    if (s.x1 > high) {
      s.x1 = high;
      s.y1 = y + (high - x) * slope;
    }
    if (s.x0 < low) {
      s.x0 = low;
      s.y0 = y + (low - x) * slope;
    }
  }
  static void clip_y(SegmentPart& s, double low, double high) {
    const double slope = (s.x1 - s.x0) / (s.y1 - s.y0), x = s.x0, y = s.y0;
    const bool rises = s.y0 < s.y1;
    double &x_low = rises ? s.x0 : s.x1, &y_low = rises ? s.y0 : s.y1;
    double &x_high = rises ? s.x1 : s.x0, &y_high = rises ? s.y1 : s.y0;
    if (y_high > high) {
      x_high = x + (high - y) * slope;
      y_high = high;
    }
    if (y_low < low) {
      x_low = x + (low - y) * slope;
      y_low = low;
    }
  }

  /// One axis of a grid: `count` intervals of equal width.
  struct Intervals {
    double low, width, per_width;
    std::size_t count;
    Intervals(double from, double size, double number)
        : low(from),
          width(size / std::floor(number)),
          per_width(width > 0 ? 1 / width : 0),
          count(static_cast<std::size_t>(number)) {}
    std::size_t at(double v) const {
      return static_cast<std::size_t>(std::clamp((v - low) * per_width, 0.0, static_cast<double>(count - 1)));
    }
    double border(std::size_t k) const { return low + static_cast<double>(k) * width; }
  };
  struct Grid {
    Intervals columns, rows;
    std::size_t cells() const { return columns.count * rows.count; }
  };

  /// A cell of a grid, and a little beside it.
  struct Window {
    double left, right, low, high;
    Window(const Grid& grid, std::size_t cell, double beside)
        : left(grid.columns.border(cell / grid.rows.count) - beside),
          right(grid.columns.border(cell / grid.rows.count + 1) + beside),
          low(grid.rows.border(cell % grid.rows.count) - beside),
          high(grid.rows.border(cell % grid.rows.count + 1) + beside) {}
    SegmentPart clipped(SegmentPart s) const {
      if (s.x0 < left || s.x1 > right) clip_x(s, left, right);
      if (std::min(s.y0, s.y1) < low || std::max(s.y0, s.y1) > high) clip_y(s, low, high);
      return s;
    }
  };

  struct Extent {
    double x_low = 1e300, x_high = -1e300, y_low = 1e300, y_high = -1e300, x_sum = 0, y_sum = 0;
    std::size_t active = 0;
  };
  template <class Source>
  Extent extent(std::size_t n, Source source) const {
    Extent e;
    for (std::size_t k = 0; k < n; ++k) {
      const SegmentPart s = source(k);
      e.x_sum += s.x0 + s.x1;
      e.y_sum += s.y0 + s.y1;
      e.x_low = std::min(e.x_low, s.x0);
      e.x_high = std::max(e.x_high, s.x1);
      e.y_low = std::min({e.y_low, s.y0, s.y1});
      e.y_high = std::max({e.y_high, s.y0, s.y1});
      e.active += is_active(s) ? 1u : 0u;
    }
    return e;
  }

  Grid grid_over(std::size_t n, const Extent& e) const {
    const double width = e.x_high - e.x_low + slack_, height = e.y_high - e.y_low + slack_;
    const std::size_t per_cell = n > kMany && e.active > n / 8 ? kInCell : kFew / 3;
    const double cells = static_cast<double>(n) / static_cast<double>(per_cell);
    const double columns = std::clamp(std::sqrt(cells * width / height), 1.0, cells);
    return {Intervals(e.x_low, width, columns), Intervals(e.y_low, height, cells / columns)};
  }
  /// Calls f(cell) for every cell within the slack of s.
  template <class G>
  void for_each_cell(const Grid& grid, const SegmentPart& s, G f) const {
    const std::size_t c0 = grid.columns.at(s.x0 - slack_), c1 = grid.columns.at(s.x1 + slack_);
    for (std::size_t c = c0; c <= c1; ++c) {
      SegmentPart part = s;
      if (c0 != c1) clip_x(part, grid.columns.border(c) - 2 * slack_, grid.columns.border(c + 1) + 2 * slack_);
      const std::size_t r0 = grid.rows.at(std::min(part.y0, part.y1) - slack_);
      const std::size_t r1 = grid.rows.at(std::max(part.y0, part.y1) + slack_);
      for (std::size_t r = r0; r <= r1; ++r) f(c * grid.rows.count + r);
    }
  }

  /// Distributes n segments to a grid over their box and searches its cells; false if that would not help.
  template <class Source>
  bool distribute(std::size_t n, Source source, const Extent& e, int depth) {
    const Grid grid = grid_over(n, e);
    std::vector<std::uint32_t> first(grid.cells() + 1, 0);
    std::vector<std::uint8_t> active(grid.cells(), 0);
    std::size_t entries = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const SegmentPart s = source(k);
      const std::uint8_t is = is_active(s) ? 1 : 0;
      for_each_cell(grid, s, [&](std::size_t cell) {
        ++first[cell + 1];
        active[cell] |= is;
        ++entries;
      });
      if (entries > 2 * n) return false;
    }
    for (std::size_t cell = 0; cell < active.size(); ++cell) {
      if (first[cell + 1] > n / 2) return false;
      first[cell + 1] = first[cell] + (active[cell] != 0 ? first[cell + 1] : 0);
    }
    std::vector<std::uint32_t> items(first.back()), next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < n; ++k)
      for_each_cell(grid, source(k), [&](std::size_t cell) {
        if (active[cell] != 0) items[next[cell]++] = static_cast<std::uint32_t>(k);
      });
    const std::size_t top = arena_.size();
    for (std::size_t cell = 0; cell < active.size(); ++cell) {
      const Window window(grid, cell, 2 * slack_);
      for (std::size_t i = first[cell]; i < first[cell + 1]; ++i) arena_.push_back(window.clipped(source(items[i])));
      search(top, arena_.size(), depth + 1);
      arena_.resize(top);
    }
    return true;
  }

  /// Searches a range of the arena; what it appends there is removed again.
  void search(std::size_t begin, std::size_t end, int depth) {
    const std::size_t n = end - begin;
    if (n < 2) return;
    if (depth > kDeepest) return sweep_all(begin, end);
    if (n <= kMany && sweep(begin, end, std::max(kFew * kFew, kOverlaps * n))) return;
    const auto at = [&](std::size_t k) { return arena_[begin + k]; };
    const Extent e = extent(n, at);
    if (e.active == 0 || (n >= kWorthGrid && distribute(n, at, e, depth))) return;
    const bool longer_in_x = e.x_high - e.x_low >= e.y_high - e.y_low;
    if (!halve(begin, end, longer_in_x, e, depth) && !halve(begin, end, !longer_in_x, e, depth)) sweep_all(begin, end);
  }

  /// Halves space at the mean of one coordinate and searches both halves; false if that would separate too little.
  bool halve(std::size_t begin, std::size_t end, bool by_x, const Extent& e, int depth) {
    const std::size_t n = end - begin;
    const double m = (by_x ? e.x_sum : e.y_sum) / (2 * static_cast<double>(n));
    std::size_t lower = 0, upper = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const SegmentPart& s = arena_[i];
      const double low = by_x ? s.x0 : std::min(s.y0, s.y1), high = by_x ? s.x1 : std::max(s.y0, s.y1);
      lower += low <= m + slack_ ? 1u : 0u;
      upper += high >= m - slack_ ? 1u : 0u;
    }
    if (lower + upper > n + n / 2 + 8 || std::max(lower, upper) * 16 > n * 15) return false;
    const std::size_t top = arena_.size();
    for (const auto& [low, high] : {std::pair(-1e300, m + slack_), std::pair(m - slack_, 1e300)}) {
      append_clipped(begin, end, by_x, low, high);
      search(top, arena_.size(), depth + 1);
      arena_.resize(top);
    }
    return true;
  }
  void append_clipped(std::size_t begin, std::size_t end, bool by_x, double low, double high) {
    for (std::size_t i = begin; i < end; ++i) {
      SegmentPart s = arena_[i];
      if (by_x) {
        if (s.x1 < low || s.x0 > high) continue;
        clip_x(s, low, high);
      } else {
        if (std::max(s.y0, s.y1) < low || std::min(s.y0, s.y1) > high) continue;
        clip_y(s, low, high);
      }
      arena_.push_back(s);
    }
  }

  std::vector<SegmentPart> arena_;
  std::vector<std::size_t> actives_;  // of the range that is swept: where active segments are in the arena
  double slack_;
  const std::vector<std::uint8_t>& active_;
  F f_;
};

/// at(k) is the k-th of n segments. Calls f(i, j), sometimes repeatedly, with the ids of segments whose bounding boxes
/// come within `slack` of each other in some cell; no pair of segments within `slack` of each other is left out, except
/// pairs of two inactive ones. active[id] != 0 marks active segments; if `active` is empty, all are.
template <class At, class F>
void for_close_pairs(std::size_t n, At at, double slack, const std::vector<std::uint8_t>& active, F f) {
  ClosePairs<At, F>(n, at, slack, active, std::move(f));
}

}  // namespace oxturn

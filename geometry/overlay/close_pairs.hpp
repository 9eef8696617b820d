// Which pairs of segments come near each other? Private to geometry: not installed.
//
// Many segments are dealt out to the cells of a grid over their box, clipped to them; the cells are searched in the
// same way, small ones pair by pair. Where a grid does not help (all detail lies in one corner, or segments are long for
// their number), space is halved at the mean of what it holds. O(n + pairs) for segments that are spread evenly,
// O(n log n + pairs) for other usual data.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace oxturn {

/// A segment, or the part of it inside a cell.
struct SegmentPart {
  double x0, y0, x1, y1;  // x0 <= x1; y0 is the height at x0
  std::uint32_t id;
};

template <class At, class F>
class ClosePairs {
 public:
  /// at(k): the k-th of n stretches. f(i, j) is called for ids of stretches whose boxes, grown by `slack`, meet; a pair
  /// may come several times. Pairs of two quiet stretches (loud[id] == 0) are left out; an empty `loud` means all are
  /// loud.
  ClosePairs(std::size_t n, At at, double slack, const std::vector<std::uint8_t>& loud, F f)
      : slack_(slack), loud_(loud), f_(std::move(f)) {
    if (n >= kMany && deal(n, at, extent(n, at), 0)) return;
    arena_.reserve(3 * n);
    for (std::size_t k = 0; k < n; ++k) arena_.push_back(at(k));
    visit(0, n, 0);
  }

 private:
  static constexpr std::size_t kLeaf = 24;
  static constexpr std::size_t kMany = 256;   // worth a grid
  static constexpr std::size_t kDeal = 1024;  // per cell of the first grid, so that a cell fits into the cache

  bool is_loud(const SegmentPart& s) const { return loud_.empty() || loud_[s.id] != 0; }

  void leaf(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const SegmentPart& a = arena_[i];
      const double low = std::min(a.y0, a.y1) - slack_, high = std::max(a.y0, a.y1) + slack_;
      const double west = a.x0 - slack_, east = a.x1 + slack_;
      const bool loud = is_loud(a);
      for (std::size_t j = i + 1; j < end; ++j) {
        const SegmentPart& b = arena_[j];
        if (b.x0 > east || b.x1 < west || std::min(b.y0, b.y1) > high || std::max(b.y0, b.y1) < low) continue;
        if (loud || is_loud(b)) f_(a.id, b.id);
      }
    }
  }

  /// The part of s, which comes to it, between two lines upright or level.
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
    const bool up = s.y0 < s.y1;
    double &x_low = up ? s.x0 : s.x1, &y_low = up ? s.y0 : s.y1, &x_high = up ? s.x1 : s.x0, &y_high = up ? s.y1 : s.y0;
    if (y_high > high) {
      x_high = x + (high - y) * slope;
      y_high = high;
    }
    if (y_low < low) {
      x_low = x + (low - y) * slope;
      y_low = low;
    }
  }

  /// Splits the stretches at `m` across axis; appends the wanted half. Cuts are widened by the slack, so that what
  /// is near the border is in both halves.
  void append_half(std::size_t begin, std::size_t end, bool by_x, double m, bool upper) {
    const double low = upper ? m - slack_ : -1e300, high = upper ? 1e300 : m + slack_;
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

  /// One axis of a grid.
  struct Bands {
    double low, width, per_width;
    std::size_t count;
    Bands(double from, double size, double bands)
        : low(from),
          width(size / std::floor(bands)),
          per_width(width > 0 ? 1 / width : 0),
          count(static_cast<std::size_t>(bands)) {}
    std::size_t at(double v) const {
      return static_cast<std::size_t>(std::clamp((v - low) * per_width, 0.0, static_cast<double>(count - 1)));
    }
    double border(std::size_t k) const { return low + static_cast<double>(k) * width; }
  };

  struct Extent {
    double x_low = 1e300, x_high = -1e300, y_low = 1e300, y_high = -1e300, x_sum = 0, y_sum = 0;
    std::size_t loud = 0;
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
      e.loud += is_loud(s) ? 1u : 0u;
    }
    return e;
  }

  /// Deals n stretches out to a grid over their box and visits its cells; false if that would not help.
  template <class Source>
  bool deal(std::size_t n, Source source, const Extent& e, int depth) {
    const double wide = e.x_high - e.x_low + slack_, high = e.y_high - e.y_low + slack_;
    const std::size_t per_cell = n > 8 * kDeal && e.loud > n / 8 ? kDeal : kLeaf / 3;
    const double cells = static_cast<double>(n) / static_cast<double>(per_cell);
    const double across = std::clamp(std::sqrt(cells * wide / high), 1.0, cells);
    const Bands columns(e.x_low, wide, across), rows(e.y_low, high, cells / across);
    // f(cell, stretch clipped to its column, row, is it in several rows?)
    const auto each = [&](const SegmentPart& s, auto f) {
      const std::size_t c0 = columns.at(s.x0 - slack_), c1 = columns.at(s.x1 + slack_);
      for (std::size_t c = c0; c <= c1; ++c) {
        SegmentPart part = s;
        if (c0 != c1) clip_x(part, columns.border(c) - 2 * slack_, columns.border(c + 1) + 2 * slack_);
        const std::size_t r0 = rows.at(std::min(part.y0, part.y1) - slack_);
        const std::size_t r1 = rows.at(std::max(part.y0, part.y1) + slack_);
        for (std::size_t r = r0; r <= r1; ++r) f(c * rows.count + r, part, r, r0 != r1);
      }
    };
    std::vector<std::uint32_t> start(columns.count * rows.count + 1, 0);
    std::vector<std::uint8_t> loud(columns.count * rows.count, 0);
    std::size_t sum = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const SegmentPart s = source(k);
      const std::uint8_t is = is_loud(s) ? 1 : 0;
      each(s, [&](std::size_t cell, const SegmentPart&, std::size_t, bool) {
        ++start[cell + 1];
        loud[cell] |= is;
        ++sum;
      });
      if (sum > 2 * n) return false;
    }
    for (std::size_t cell = 0; cell < loud.size(); ++cell) {
      if (start[cell + 1] > n / 2) return false;
      start[cell + 1] = start[cell] + (loud[cell] != 0 ? start[cell + 1] : 0);
    }
    const std::size_t top = arena_.size();
    arena_.resize(top + start.back());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t k = 0; k < n; ++k) {
      const SegmentPart s = source(k);
      each(s, [&](std::size_t cell, SegmentPart part, std::size_t r, bool several) {
        if (loud[cell] == 0) return;
        if (several) clip_y(part, rows.border(r) - 2 * slack_, rows.border(r + 1) + 2 * slack_);
        arena_[top + next[cell]++] = part;
      });
    }
    for (std::size_t cell = 0; cell < loud.size(); ++cell) visit(top + start[cell], top + start[cell + 1], depth + 1);
    arena_.resize(top);
    return true;
  }

  void visit(std::size_t begin, std::size_t end, int depth) {
    const std::size_t n = end - begin;
    if (n < 2) return;
    if (n <= kLeaf || depth > 60) return leaf(begin, end);
    const auto at = [&](std::size_t k) { return arena_[begin + k]; };
    const Extent e = extent(n, at);
    if (e.loud == 0 || (n >= kMany && deal(n, at, e, depth))) return;
    const double count = 2 * static_cast<double>(n);
    bool by_x = e.x_high - e.x_low >= e.y_high - e.y_low;
    for (int attempt = 0; attempt < 2; ++attempt, by_x = !by_x) {
      const double m = by_x ? e.x_sum / count : e.y_sum / count;
      std::size_t lower = 0, upper = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const SegmentPart& s = arena_[i];
        const double low = by_x ? s.x0 : std::min(s.y0, s.y1), high = by_x ? s.x1 : std::max(s.y0, s.y1);
        lower += low <= m + slack_ ? 1u : 0u;
        upper += high >= m - slack_ ? 1u : 0u;
      }
      if (lower + upper > n + n / 2 + 8 || std::max(lower, upper) * 16 > n * 15) continue;  // cuts too much, or nothing
      const std::size_t top = arena_.size();
      append_half(begin, end, by_x, m, false);
      visit(top, arena_.size(), depth + 1);
      arena_.resize(top);
      append_half(begin, end, by_x, m, true);
      visit(top, arena_.size(), depth + 1);
      arena_.resize(top);
      return;
    }
    leaf(begin, end);
  }

  std::vector<SegmentPart> arena_;
  double slack_;
  const std::vector<std::uint8_t>& loud_;
  F f_;
};

template <class At, class F>
void for_close_pairs(std::size_t n, At at, double slack, const std::vector<std::uint8_t>& loud, F f) {
  ClosePairs<At, F>(n, at, slack, loud, std::move(f));
}

}  // namespace oxturn

// Which pairs of segments come near each other? Private to geometry: not installed.
//
// Space is halved again and again at the mean of what it holds, segments are clipped to the halves, and small
// cells are searched pair by pair. Unlike a uniform grid this does not mind that all detail lies in one corner of
// the map. O(n log n + pairs) for usual data.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace oxturn {

/// A segment, or the part of it inside a cell.
struct Stretch {
  double x0, y0, x1, y1;  // x0 <= x1; y0 is the height at x0
  std::uint32_t id;
};

template <class F>
class ClosePairs {
 public:
  /// f(i, j) is called for ids of stretches whose boxes, grown by `slack`, meet; a pair may come several times.
  /// Pairs of two quiet stretches (loud[id] == 0) are left out; an empty `loud` means all are loud.
  ClosePairs(std::vector<Stretch> stretches, double slack, const std::vector<std::uint8_t>& loud, F f)
      : arena_(std::move(stretches)), slack_(slack), loud_(loud), f_(std::move(f)) {
    arena_.reserve(arena_.size() * 3);
    visit(0, arena_.size(), 0);
  }

 private:
  static constexpr std::size_t kLeaf = 24;

  bool is_loud(const Stretch& s) const { return loud_.empty() || loud_[s.id] != 0; }

  void leaf(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Stretch& a = arena_[i];
      const double low = std::min(a.y0, a.y1) - slack_, high = std::max(a.y0, a.y1) + slack_;
      const double west = a.x0 - slack_, east = a.x1 + slack_;
      const bool loud = is_loud(a);
      for (std::size_t j = i + 1; j < end; ++j) {
        const Stretch& b = arena_[j];
        if (b.x0 > east || b.x1 < west || std::min(b.y0, b.y1) > high || std::max(b.y0, b.y1) < low) continue;
        if (loud || is_loud(b)) f_(a.id, b.id);
      }
    }
  }

  /// Splits the stretches at `m` across axis; appends the wanted half. Cuts are widened by the slack, so that what
  /// is near the border is in both halves.
  void append_half(std::size_t begin, std::size_t end, bool by_x, double m, bool upper) {
    for (std::size_t i = begin; i < end; ++i) {
      Stretch s = arena_[i];
      if (by_x) {
        if (upper ? s.x1 < m - slack_ : s.x0 > m + slack_) continue;
        const double cut = upper ? m - slack_ : m + slack_;
        if (s.x0 < cut && cut < s.x1) {
          const double t = (cut - s.x0) / (s.x1 - s.x0);
          const double y = s.y0 + t * (s.y1 - s.y0);
          if (upper) {
            s.x0 = cut;
            s.y0 = y;
          } else {
            s.x1 = cut;
            s.y1 = y;
          }
        }
      } else {
        const double low = std::min(s.y0, s.y1), high = std::max(s.y0, s.y1);
        if (upper ? high < m - slack_ : low > m + slack_) continue;
        const double cut = upper ? m - slack_ : m + slack_;
        if (low < cut && cut < high) {
          const double t = (cut - s.y0) / (s.y1 - s.y0);
          const double x = s.x0 + t * (s.x1 - s.x0);
          if ((s.y0 < s.y1) == upper) {
            s.x0 = x;
            s.y0 = cut;
          } else {
            s.x1 = x;
            s.y1 = cut;
          }
        }
      }
      arena_.push_back(s);
    }
  }

  void visit(std::size_t begin, std::size_t end, int depth) {
    const std::size_t n = end - begin;
    if (n < 2) return;
    if (n <= kLeaf || depth > 60) return leaf(begin, end);
    double x_sum = 0, y_sum = 0;
    double x_low = 1e300, x_high = -1e300, y_low = 1e300, y_high = -1e300;
    bool loud = false;
    for (std::size_t i = begin; i < end; ++i) {
      const Stretch& s = arena_[i];
      const double x0 = s.x0, x1 = s.x1, y0 = s.y0, y1 = s.y1;
      x_sum += x0 + x1;
      y_sum += y0 + y1;
      x_low = std::min(x_low, x0);
      x_high = std::max(x_high, x1);
      y_low = std::min({y_low, y0, y1});
      y_high = std::max({y_high, y0, y1});
      loud = loud || is_loud(s);
    }
    if (!loud) return;
    const double count = 2 * static_cast<double>(n);
    bool by_x = x_high - x_low >= y_high - y_low;
    for (int attempt = 0; attempt < 2; ++attempt, by_x = !by_x) {
      const double m = by_x ? x_sum / count : y_sum / count;
      std::size_t lower = 0, upper = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Stretch& s = arena_[i];
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

  std::vector<Stretch> arena_;
  double slack_;
  const std::vector<std::uint8_t>& loud_;
  F f_;
};

template <class F>
void for_close_pairs(std::vector<Stretch> stretches, double slack, const std::vector<std::uint8_t>& loud, F f) {
  ClosePairs<F>(std::move(stretches), slack, loud, std::move(f));
}

}  // namespace oxturn

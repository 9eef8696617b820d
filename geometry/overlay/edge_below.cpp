#include "geometry/overlay/edge_below.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oxturn {
namespace {

__extension__ typedef __int128 Wide;

}  // namespace

bool EdgeBelow::higher(const Edge& e, const Edge& f, std::int32_t x) {
  const std::int64_t ex = std::int64_t{e.b.x} - e.a.x, ey = std::int64_t{e.b.y} - e.a.y;
  const std::int64_t fx = std::int64_t{f.b.x} - f.a.x, fy = std::int64_t{f.b.y} - f.a.y;
  // The heights at x are (a.y * ex + ey * (x - a.x)) / ex, compared over the common denominator ex * fx.
  const Wide e_height = (Wide{e.a.y} * ex + Wide{ey} * (std::int64_t{x} - e.a.x)) * fx;
  const Wide f_height = (Wide{f.a.y} * fx + Wide{fy} * (std::int64_t{x} - f.a.x)) * ex;
  if (e_height != f_height) return e_height > f_height;
  return ey * fx < fy * ex;  // they meet at x: the one that rises less was above
}

/// Calls f(cell, edge index) for every cell that an edge belongs to: its level in all columns with an x for which
/// borders[c] < x <= borders[c + 1] and that it spans.
template <class F>
void EdgeBelow::for_each_cell_of_edges(F f) const {
  std::size_t first = 0;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    const std::size_t l = level(std::min(e.a.y, e.b.y));
    while (first + 1 < borders_.size() && borders_[first + 1] <= e.a.x) ++first;
    for (std::size_t c = first; c < borders_.size() && (borders_[c] < e.b.x || c == 0); ++c) f(c * levels_ + l, i);
  }
}

EdgeBelow::EdgeBelow(std::vector<Edge> edges) : edges_(std::move(edges)) {
  const std::size_t n = edges_.size();
  if (n == 0) return;
  const auto by_left_end = [](const Edge& e, const Edge& f) { return e.a.x < f.a.x; };
  if (!std::is_sorted(edges_.begin(), edges_.end(), by_left_end)) std::sort(edges_.begin(), edges_.end(), by_left_end);
  const std::size_t columns = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(n))));
  for (std::size_t c = 0; c < columns; ++c) {
    const std::int32_t x = edges_[c * n / columns].a.x;
    if (borders_.empty() || x > borders_.back()) borders_.push_back(x);
  }
  std::int32_t lowest = edges_[0].a.y, highest = lowest;
  for (const Edge& e : edges_) {
    lowest = std::min({lowest, e.a.y, e.b.y});
    highest = std::max({highest, e.a.y, e.b.y});
  }
  levels_ = borders_.size();
  low_ = lowest;
  height_ = (std::int64_t{highest} - lowest) / static_cast<std::int64_t>(levels_) + 1;

  first_.assign(borders_.size() * levels_ + 1, 0);
  top_.assign(borders_.size() * levels_, std::numeric_limits<std::int32_t>::min());
  for_each_cell_of_edges([&](std::size_t cell, std::uint32_t i) {
    ++first_[cell + 1];
    top_[cell] = std::max({top_[cell], edges_[i].a.y, edges_[i].b.y});
  });
  for (std::size_t cell = 0; cell < top_.size(); ++cell) {
    first_[cell + 1] += first_[cell];
    if (cell % levels_ != 0) top_[cell] = std::max(top_[cell], top_[cell - 1]);
  }
  items_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_each_cell_of_edges([&](std::size_t cell, std::uint32_t i) { items_[next[cell]++] = i; });
}

std::size_t EdgeBelow::column(std::int32_t x) const {
  const auto it = std::lower_bound(borders_.begin(), borders_.end(), x);
  return it == borders_.begin() ? 0 : static_cast<std::size_t>(it - borders_.begin()) - 1;
}

std::size_t EdgeBelow::level(std::int32_t y) const {
  const std::int64_t l = (std::int64_t{y} - low_) / height_;
  return static_cast<std::size_t>(std::clamp<std::int64_t>(l, 0, static_cast<std::int64_t>(levels_) - 1));
}

std::uint32_t EdgeBelow::below(const LatticePoint& p) const {
  if (edges_.empty()) return kNone;
  const Edge* best = nullptr;
  const std::size_t lowest = column(p.x) * levels_;
  for (std::size_t cell = lowest + level(p.y) + 1; cell-- > lowest;) {
    if (best && top_[cell] < std::min(best->a.y, best->b.y)) break;
    for (std::size_t k = first_[cell]; k < first_[cell + 1]; ++k) {
      const Edge& e = edges_[items_[k]];
      if (is_below(e, p) && (!best || higher(e, *best, p.x))) best = &e;
    }
  }
  return best ? best->id : kNone;
}

}  // namespace oxturn

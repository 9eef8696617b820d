#include "geometry/edge_below.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

__extension__ typedef __int128 Wide;

/// Is e above f just left of x? Both span it, and do not cross.
bool higher(const EdgeBelow::Edge& e, const EdgeBelow::Edge& f, std::int32_t x) {
  const std::int64_t ex = std::int64_t{e.b.x} - e.a.x, ey = std::int64_t{e.b.y} - e.a.y;
  const std::int64_t fx = std::int64_t{f.b.x} - f.a.x, fy = std::int64_t{f.b.y} - f.a.y;
  // heights at x are (a.y * ex + ey * (x - a.x)) / ex
  const Wide e_height = (Wide{e.a.y} * ex + Wide{ey} * (std::int64_t{x} - e.a.x)) * fx;
  const Wide f_height = (Wide{f.a.y} * fx + Wide{fy} * (std::int64_t{x} - f.a.x)) * ex;
  if (e_height != f_height) return e_height > f_height;
  return ey * fx < fy * ex;  // they meet at x: the flatter came from above
}

}  // namespace

EdgeBelow::EdgeBelow(std::vector<Edge> edges) : edges_(std::move(edges)) {
  const std::size_t n = edges_.size();
  if (n == 0) return;
  std::vector<std::int32_t> left(n);
  for (std::size_t i = 0; i < n; ++i) left[i] = edges_[i].a.x;
  std::sort(left.begin(), left.end());
  const std::size_t columns = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(n))));
  for (std::size_t c = 0; c < columns; ++c) {
    const std::int32_t x = left[c * n / columns];
    if (borders_.empty() || x > borders_.back()) borders_.push_back(x);
  }
  // column c holds what spans some x with borders[c] < x <= borders[c + 1]
  start_.assign(borders_.size() + 1, 0);
  const auto each = [&](auto f) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::size_t last = column(edges_[i].b.x);
      for (std::size_t c = column(edges_[i].a.x + 1); c <= last; ++c) f(c, i);
    }
  };
  each([&](std::size_t c, std::uint32_t) { ++start_[c + 1]; });
  for (std::size_t c = 0; c < borders_.size(); ++c) start_[c + 1] += start_[c];
  index_.resize(start_.back());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  each([&](std::size_t c, std::uint32_t i) { index_[next[c]++] = i; });
}

std::size_t EdgeBelow::column(std::int32_t x) const {
  const auto it = std::lower_bound(borders_.begin(), borders_.end(), x);  // first border >= x
  return it == borders_.begin() ? 0 : static_cast<std::size_t>(it - borders_.begin()) - 1;
}

std::uint32_t EdgeBelow::below(const Site& p) const {
  if (edges_.empty()) return kNone;
  const Edge* best = nullptr;
  const std::size_t c = column(p.x);
  for (std::size_t k = start_[c]; k < start_[c + 1]; ++k) {
    const Edge& e = edges_[index_[k]];
    if (e.a.x >= p.x || e.b.x < p.x) continue;
    if (std::min(e.a.y, e.b.y) > p.y || turn(e.a, e.b, p) <= 0) continue;
    if (!best || higher(e, *best, p.x)) best = &e;
  }
  return best ? best->id : kNone;
}

}  // namespace oxturn

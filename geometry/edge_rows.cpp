#include "geometry/edge_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/ray_crossing.hpp"

namespace oxturn {

/// As many rows as make about two entries for each edge, but no more than edges.
EdgeRows::EdgeRows(const Region& region) {
  std::vector<Edge> all;
  all.reserve(vertex_count(region));
  double rise = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  for_each_edge(region, [&](const Point& a, const Point& b) {
    if (a.y() == b.y()) return;  // no horizontal ray crosses it
    all.push_back({a, b});
    rise += std::abs(b.y() - a.y());
    low = std::min({low, a.y(), b.y()});
    high = std::max({high, a.y(), b.y()});
  });
  if (all.empty()) return;
  low_ = low;
  high_ = high;
  rows_per_metre_ = static_cast<double>(all.size()) / std::max(rise, high - low);
  const auto for_each_row = [&](const Edge& e, const auto& f) {
    for (std::size_t r = row(std::min(e.a.y(), e.b.y())), last = row(std::max(e.a.y(), e.b.y())); r <= last; ++r) f(r);
  };
  first_.assign(row(high_) + 2, 0);
  for (const Edge& e : all) for_each_row(e, [&](std::size_t r) { ++first_[r + 1]; });
  for (std::size_t r = 1; r < first_.size(); ++r) first_[r] += first_[r - 1];
  edges_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const Edge& e : all) for_each_row(e, [&](std::size_t r) { edges_[next[r]++] = e; });
}

bool EdgeRows::contains(const Point& p) const {
  if (!(p.y() >= low_ && p.y() <= high_)) return false;
  const std::size_t r = row(p.y());
  bool odd = false;
  for (std::size_t i = first_[r]; i < first_[r + 1]; ++i) odd ^= crosses_ray(edges_[i].a, edges_[i].b, p);
  return odd;
}

}  // namespace oxturn

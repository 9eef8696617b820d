#include "algorithms/improve/window_part.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "algorithms/improve/witnesses.hpp"

namespace oxturn {
namespace {

// In tool widths. An edge along a wall is cut beside itself: a point on it, rounded, may lie in the wall.
constexpr double kBeside = 1e-9, kOnChord = 1e-8;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The parameters between which the edge lies in the box; nullopt: in no more than a point.
std::optional<std::pair<double, double>> clipped(const Point& a, const Point& b, const Box& box) {
  double first = 0, last = 1;
  for (const int k : {0, 1}) {
    const double from = a[k], by = b[k] - a[k], low = box.low[k], high = box.high[k];
    if (by == 0) {
      if (from < low || from > high) return std::nullopt;
      continue;
    }
    first = std::max(first, ((by > 0 ? low : high) - from) / by);
    last = std::min(last, ((by > 0 ? high : low) - from) / by);
  }
  if (first >= last) return std::nullopt;
  return std::pair(first, last);
}

}  // namespace

WindowPart::WindowPart(const Polyline& path, const Box& window, const EdgeIndex& walls, double width, bool fixed_end)
    : walls_(walls), width_(width) {
  Polyline outside;
  bool inside = false;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Point &a = path[i], &b = path[i + 1];
    const auto part = part_of(a, b, window);
    if (!part) {
      if (inside)
        end_visit();
      else
        outside.push_back(a);
      inside = false;
      continue;
    }
    if (!inside) {
      if (part->a != a) outside.push_back(a);
      begin_visit(std::exchange(outside, {}));
      points_.push_back(part->a);
    }
    points_.push_back(part->b);
    inside = part->b == b;
    if (!inside) end_visit();
  }
  if (points_.empty()) return;
  if (!inside) {
    outside.push_back(path.back());
    add_fixed(outside.front());
    after_.assign(outside.begin() + 1, outside.end());
  } else if (fixed_end) {
    end_visit();
  }
  std::ranges::sort(made_, before);
}

/// The point of the edge at t, such that both parts of the edge are free.
std::optional<Point> WindowPart::cut(const Point& a, const Point& b, double t) {
  const Point at = lerp(a, b, t), beside = kBeside * width_ / distance(a, b) * perpendicular(b - a);
  for (const Point& p : {at, Point(at + beside), Point(at - beside)})
    if (walls_.contains(a, p) && walls_.contains(p, b)) {
      made_.push_back(p);
      return p;
    }
  return std::nullopt;
}

std::optional<Edge> WindowPart::part_of(const Point& a, const Point& b, const Box& window) {
  const auto range = clipped(Witnesses::turned(a), Witnesses::turned(b), window);
  if (!range) return std::nullopt;
  const auto from = range->first > 0 ? cut(a, b, range->first) : a;
  const auto to = range->second < 1 ? cut(a, b, range->second) : b;
  if (!from || !to || !walls_.contains(*from, *to)) return std::nullopt;
  return Edge{*from, *to};
}

void WindowPart::add_fixed(const Point& p) {
  fixed_.push_back(points_.size());
  points_.push_back(p);
}

/// `outside`: the path since the last visit. Its ends are kept beside the visits.
void WindowPart::begin_visit(Polyline outside) {
  const bool first = points_.empty();
  visit_ = points_.size();
  if (!outside.empty() && !first) {
    add_fixed(outside.front());
    outside.erase(outside.begin());
  }
  if (!outside.empty()) {
    const std::size_t from = points_.size() - 1;
    add_fixed(outside.back());
    outside.pop_back();
    if (first)
      before_ = std::move(outside);
    else if (!outside.empty())
      links_.push_back({from, from + 1, std::move(outside)});
  }
  visit_ = points_.size();
  fixed_.push_back(points_.size());
}

/// Where the path only passes, a vertex is added that can be moved.
void WindowPart::end_visit() {
  if (points_.size() == visit_ + 2) {
    if (const auto middle = cut(points_[visit_], points_.back(), 0.5)) points_.insert(points_.end() - 1, *middle);
  }
  fixed_.push_back(points_.size() - 1);
}

Polyline WindowPart::joined(const VertexPath& inside) const { return without_made(assembled(inside)); }

Polyline WindowPart::assembled(const VertexPath& inside) const {
  std::vector<std::size_t> link_at(points_.size(), kNone);
  for (std::size_t k = 0; k < links_.size(); ++k) link_at[links_[k].from] = link_at[links_[k].to] = k;
  Polyline all = before_;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    all.push_back(inside[i]);
    if (i + 1 == inside.size() || !inside.edge_fixed(i + 1)) continue;
    const std::size_t k = link_at[inside.origin(i)];
    if (k == kNone || k != link_at[inside.origin(i + 1)]) continue;
    const Polyline& outside = links_[k].outside;
    if (inside.origin(i) == links_[k].from)
      all.insert(all.end(), outside.begin(), outside.end());
    else
      all.insert(all.end(), outside.rbegin(), outside.rend());
  }
  all.insert(all.end(), after_.begin(), after_.end());
  return all;
}

/// Without the vertices at which edges were cut, where these edges are still straight.
Polyline WindowPart::without_made(const Polyline& path) const {
  Polyline kept{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const bool last = i + 1 == path.size();
    if (!last && std::ranges::binary_search(made_, path[i], before) &&
        distance_to_segment(path[i], kept.back(), path[i + 1]) < kOnChord * width_ &&
        walls_.contains(kept.back(), path[i + 1]))
      continue;
    kept.push_back(path[i]);
  }
  return kept;
}

}  // namespace oxturn

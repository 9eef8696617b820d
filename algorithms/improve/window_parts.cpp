#include "algorithms/improve/window_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "algorithms/improve/witnesses.hpp"

namespace oxturn {
namespace {

// In tool widths. An edge along a wall is cut beside itself: a point on it, rounded, may lie in the wall.
constexpr double kBeside = 1e-9, kOnChord = 1e-8;

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

WindowParts::WindowParts(const Polyline& path, const std::vector<Box>& windows, const EdgeIndex& walls, double width,
                         bool fixed_end)
    : walls_(walls), width_(width), fixed_end_(fixed_end), path_{path.front()}, parts_(windows.size()) {
  for (std::size_t i = 1; i < path.size(); ++i) add_edge(path[i - 1], path[i], windows);
  if (begin_) end_visit(fixed_end_);
  for (Part& part : parts_)
    for (const Visit& v : part.visits) part.inner += v.last - v.first - (last_is_fixed(v) ? 1 : 0);
  std::ranges::sort(made_, before);
}

/// The edge from the last vertex to b, cut at the sides of the windows that it crosses.
void WindowParts::add_edge(const Point& a, const Point& b, const std::vector<Box>& windows) {
  const Point from = Witnesses::turned(a), to = Witnesses::turned(b);
  Box edge;
  edge.add(from);
  edge.add(to);
  std::vector<Crossing> crossings;
  for (std::uint32_t k = 0; k < windows.size(); ++k)
    if (windows[k].overlaps(edge))
      if (const auto range = clipped(from, to, windows[k])) crossings.push_back({range->first, range->second, k});
  std::ranges::sort(crossings, {}, &Crossing::first);
  for (const Crossing& c : crossings) {
    const auto in = c.first > 0 ? cut(path_.back(), b, lerp(a, b, c.first)) : path_.back();
    const auto out = in && c.last < 1 ? cut(*in, b, lerp(a, b, c.last)) : b;
    if (!in || !out || !walls_.contains(*in, *out)) continue;
    if (begin_ && (*in != path_.back() || window_.back() != c.window)) end_visit(true);
    if (*in != path_.back()) add(*in, kOutside);
    if (!begin_) begin_ = path_.size() - 1;
    add(*out, c.window);
    if (*out == b) return;
    end_visit(true);
  }
  if (begin_) end_visit(true);
  add(b, kOutside);
}

void WindowParts::add(const Point& p, std::uint32_t window) {
  window_.push_back(window);
  path_.push_back(p);
}

/// Where the path only passes, a vertex is added that can be moved; it is of no use to an end that moves itself.
void WindowParts::end_visit(bool fixed) {
  const std::size_t first = *std::exchange(begin_, std::nullopt);
  if (fixed && path_.size() == first + 2) {
    const Point &a = path_[first], &b = path_.back();
    if (const auto middle = cut(a, b, lerp(a, b, 0.5))) {
      path_.insert(path_.end() - 1, *middle);
      window_.push_back(window_.back());
    }
  }
  parts_[window_.back()].visits.push_back({first, path_.size() - 1});
}

/// A point at or beside `at` such that both parts of the edge are free.
std::optional<Point> WindowParts::cut(const Point& from, const Point& to, const Point& at) {
  if (from == to) return std::nullopt;
  const Point beside = kBeside * width_ / distance(from, to) * perpendicular(to - from);
  for (const Point& p : {at, Point(at + beside), Point(at - beside)})
    if (walls_.contains(from, p) && walls_.contains(p, to)) {
      made_.push_back(p);
      return p;
    }
  return std::nullopt;
}

WindowParts::Sequence WindowParts::sequence(std::size_t k) const {
  Sequence all;
  const auto add = [&](std::size_t at, bool fixed, bool outside) {
    if (fixed) all.fixed.push_back(all.at.size());
    all.at.push_back(at);
    all.outside.push_back(outside ? 1 : 0);
  };
  const std::vector<Visit>& visits = parts_[k].visits;
  for (const Visit& v : visits) {
    const std::size_t behind = all.at.empty() ? std::max<std::size_t>(v.first, 1) - 1 : all.at.back() + 1;
    if (behind < v.first) add(behind, true, true);
    if (behind + 1 < v.first) add(v.first - 1, true, true);
    add(v.first, true, true);
    for (std::size_t i = v.first + 1; i < v.last; ++i) add(i, false, false);
    add(v.last, last_is_fixed(v), false);
  }
  if (!visits.empty() && visits.back().last + 1 < path_.size()) add(visits.back().last + 1, true, true);
  return all;
}

VertexPath WindowParts::part(std::size_t k) const {
  const Sequence all = sequence(k);
  Polyline points;
  for (const std::size_t i : all.at) points.push_back(path_[i]);
  return {points, all.fixed, width_};
}

/// Drives through the path and the changed parts, from the start on.
class WindowParts::Joining {
 public:
  Joining(const WindowParts& parts, const std::vector<std::optional<VertexPath>>& changed)
      : parts_(parts), changed_(changed), kept_(changed.size()), ports_(parts.path_.size()) {
    for (std::size_t k = 0; k < changed.size(); ++k) {
      sequences_.push_back(changed[k] ? parts.sequence(k) : Sequence());
      if (changed[k]) find_ports(*changed[k], sequences_.back());
    }
  }

  /// Of the windows from `first` to `end` - 1, the first, and all others that make one path with those kept so far.
  void keep(std::size_t first, std::size_t end) {
    bool any = false;
    for (std::size_t k = first; k < end; ++k) {
      any = any || changed_[k];
      kept_[k] = changed_[k] ? 1 : 0;
    }
    if (!any || driven()) return;
    std::fill(kept_.begin() + static_cast<std::ptrdiff_t>(first), kept_.begin() + static_cast<std::ptrdiff_t>(end), 0);
    if (end - first == 1) return;
    const std::size_t middle = std::midpoint(first, end);
    keep(first, middle);
    keep(middle, end);
  }

  Joined result() && {
    driven();
    return {std::move(line_), std::move(kept_)};
  }

 private:
  /// Where a visit of a changed part begins or ends: a position in it, and the direction to the rest of the visit.
  struct Port {
    std::size_t at = 0;
    bool forward = true;
    bool last = true;  // nothing is left of the visit: the path ends here
  };

  void find_ports(const VertexPath& changed, const Sequence& s) {
    const auto outside = [&](std::size_t i) {  // the edge from i to i + 1
      if (!changed.edge_fixed(i + 1)) return false;
      const auto [low, high] = std::minmax({changed.origin(i), changed.origin(i + 1)});
      return high == low + 1 && s.outside[high] != 0;
    };
    for (std::size_t i = 0; i < changed.size(); ++i) {
      if (!changed.fixed(i)) continue;
      if (i + 1 < changed.size() && !outside(i)) ports_[s.at[changed.origin(i)]] = {i, true, false};
      if (i > 0 && !outside(i - 1)) ports_[s.at[changed.origin(i)]] = {i, false, false};
    }
  }

  /// False: the windows kept make a path and loops.
  bool driven() {
    const Polyline& path = parts_.path_;
    line_.assign(1, path.front());
    std::size_t expected = path.size(), passed = 1, i = 0;
    for (std::size_t k = 0; k < kept_.size(); ++k)
      if (kept_[k] != 0) expected -= parts_.parts_[k].inner;
    for (bool forward = true; i + 1 < path.size() && (forward || i > 0); ++passed) {
      const std::uint32_t k = parts_.window_[forward ? i : i - 1];
      if (k == kOutside || kept_[k] == 0) {
        i = forward ? i + 1 : i - 1;
      } else {
        const auto end = through(*changed_[k], ports_[i]);
        if (!end) break;
        i = sequences_[k].at[changed_[k]->origin(*end)];
        forward = i + 1 == path.size() || parts_.window_[i] != k;
      }
      line_.push_back(path[i]);
    }
    return passed == expected;
  }

  /// Up to the visit's other end, which is left out; nullopt: the path ends in this visit.
  std::optional<std::size_t> through(const VertexPath& changed, const Port& from) {
    if (from.last) return std::nullopt;
    for (std::size_t i = from.at; from.forward ? i + 1 < changed.size() : i > 0;) {
      i = from.forward ? i + 1 : i - 1;
      if (changed.fixed(i)) return i;
      line_.push_back(changed[i]);
    }
    return std::nullopt;
  }

  const WindowParts& parts_;
  const std::vector<std::optional<VertexPath>>& changed_;
  std::vector<std::uint8_t> kept_;
  std::vector<Sequence> sequences_;
  std::vector<Port> ports_;  // by position in the path
  Polyline line_;
};

Joined WindowParts::joined(const std::vector<std::optional<VertexPath>>& changed) const {
  Joining joining(*this, changed);
  joining.keep(0, changed.size());
  Joined all = std::move(joining).result();
  all.path = without_made(all.path);
  return all;
}

/// Without the vertices at which edges were cut, where these edges are still straight.
Polyline WindowParts::without_made(const Polyline& path) const {
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

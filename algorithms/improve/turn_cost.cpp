#include "algorithms/improve/turn_cost.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr double kRounded = 0.1;  // tool widths before and behind a corner

/// Positions in a path, at most six.
class Positions {
 public:
  explicit Positions(std::initializer_list<std::size_t> all) {
    for (const std::size_t i : all)
      if (std::find(all_.begin(), all_.begin() + size_, i) == all_.begin() + size_) all_[size_++] = i;
  }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.begin() + size_; }

 private:
  std::array<std::size_t, 6> all_{};
  std::ptrdiff_t size_ = 0;
};

/// The path as the change will make it.
class Changed {
 public:
  Changed(const VertexPath& path, const Change& change) : path_(path), c_(change) {}
  std::size_t size() const {
    return c_.kind == Change::Kind::replace ? path_.size() + c_.point_count - (c_.last - c_.first) : path_.size();
  }
  const Point& operator[](std::size_t k) const {
    switch (c_.kind) {
      case Change::Kind::replace:
        if (k < c_.first) return path_[k];
        if (k < c_.first + c_.point_count) return c_.points[k - c_.first];
        return path_[k - c_.point_count + (c_.last - c_.first)];
      case Change::Kind::reverse:
        return path_[k < c_.first || k > c_.last ? k : c_.first + c_.last - k];
      case Change::Kind::relocate:
        return path_[relocated(k)];
    }
    return path_[k];
  }

 private:
  /// Where vertex k of the path to be is now.
  std::size_t relocated(std::size_t k) const {
    const std::size_t count = c_.last - c_.first + 1;
    const bool later = c_.after > c_.last;
    const std::size_t begin = later ? c_.after + 1 - count : c_.after + 1;  // of the moved ones
    if (k >= begin && k < begin + count) return c_.turned ? c_.last - (k - begin) : c_.first + (k - begin);
    if (later && k >= c_.first && k < begin) return k + count;
    if (!later && k >= begin + count && k <= c_.last) return k - count;
    return k;
  }
  const VertexPath& path_;
  const Change& c_;
};

}  // namespace

double TurnCost::operator()(const Point& a, const Point& b, const Point& c) const {
  const Point u = b - a, v = c - b;
  const double angle = std::abs(std::atan2(cross(u, v), u.dot(v)));
  const double half = std::tan(angle / 2);
  if (half <= 0) return 0;
  const double radius = kRounded * robot_.tool_width / half;
  const double speed = std::min(robot_.speed, robot_.turn_rate * radius), slower = robot_.speed - speed;
  return angle * (robot_.speed / speed - 1) * radius + slower * slower / robot_.acceleration;
}

double TurnCost::total(const Polyline& points) const {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) sum += (*this)(points[i - 1], points[i], points[i + 1]);
  return sum;
}

double TurnCost::change(const VertexPath& path, const Change& change) const {
  const auto sum = [this](const auto& vertices, const Positions& positions) {
    double total = 0;
    for (const std::size_t i : positions)
      if (i > 0 && i + 1 < vertices.size()) total += (*this)(vertices[i - 1], vertices[i], vertices[i + 1]);
    return total;
  };
  const Changed changed(path, change);
  const std::size_t first = change.first, last = change.last, after = change.after;
  if (change.kind == Change::Kind::replace) {
    const std::size_t n = change.point_count;  // positions beyond the vertices replaced are counted once
    const Positions removed{first - 1, first, std::min(first + 1, last), last};
    const Positions added{first - 1, first, std::min(first + 1, first + n), first + n};
    return sum(changed, added) - sum(path, removed);
  }
  const Positions removed{first - 1, first, last, last + 1};
  if (change.kind == Change::Kind::reverse) return sum(changed, removed) - sum(path, removed);
  const std::size_t count = last - first + 1;
  const Positions all{first - 1, first, last, last + 1, after, after + 1};
  const Positions added = after > last ? Positions{first - 1, first, after - count, after + 1 - count, after, after + 1}
                                       : Positions{after, after + 1, after + count, after + count + 1, last, last + 1};
  return sum(changed, added) - sum(path, all);
}

}  // namespace oxturn

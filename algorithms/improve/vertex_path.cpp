#include "algorithms/improve/vertex_path.hpp"

#include <algorithm>

namespace oxturn {

VertexPath::VertexPath(const Polyline& points, const std::vector<std::size_t>& fixed, double bucket) : cell_(bucket) {
  std::vector<std::uint8_t> is_fixed(points.size());
  for (const std::size_t i : fixed) is_fixed[i] = 1;
  Box box;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_fixed[i] == 0) box.add(points[i]);
  if (!box.empty()) {
    origin_ = box.low;
    columns_ = static_cast<std::size_t>(box.size().x() / cell_) + 1;
    rows_ = static_cast<std::size_t>(box.size().y() / cell_) + 1;
  }
  buckets_.resize(columns_ * rows_);
  replace(0, 0, points);
  fixed_ = std::move(is_fixed);
}

Polyline VertexPath::points() const {
  Polyline all;
  all.reserve(size());
  for (const Id id : order_) all.push_back(at_[id]);
  return all;
}

double VertexPath::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < size(); ++i) sum += distance((*this)[i - 1], (*this)[i]);
  return sum;
}

std::size_t VertexPath::bucket(const Point& p) const {
  const auto index = [&](double v, std::size_t n) {
    return v > 0 ? std::min(static_cast<std::size_t>(v / cell_), n - 1) : 0;
  };
  return index(p.y() - origin_.y(), rows_) * columns_ + index(p.x() - origin_.x(), columns_);
}

void VertexPath::enter(Id id, const Point& p) {
  at_[id] = p;
  buckets_[bucket(p)].push_back(id);
}

void VertexPath::leave(Id id) {
  std::vector<Id>& all = buckets_[bucket(at_[id])];
  *std::find(all.begin(), all.end(), id) = all.back();
  all.pop_back();
}

void VertexPath::renumber(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) position_[order_[i]] = static_cast<std::uint32_t>(i);
}

void VertexPath::replace(std::size_t first, std::size_t count, std::span<const Point> points) {
  const std::size_t same = std::min(count, points.size());
  for (std::size_t k = 0; k < same; ++k) {
    leave(order_[first + k]);
    enter(order_[first + k], points[k]);
  }
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t k = same; k < count; ++k) {
    leave(order_[first + k]);
    unused_.push_back(order_[first + k]);
  }
  order_.erase(at(first + same), at(first + count));
  std::vector<Id> fresh;
  for (std::size_t k = same; k < points.size(); ++k) {
    if (unused_.empty()) {
      unused_.push_back(static_cast<Id>(at_.size()));
      at_.emplace_back();
      position_.push_back(0);
      fixed_.push_back(0);
    }
    fresh.push_back(unused_.back());
    unused_.pop_back();
    enter(fresh.back(), points[k]);
  }
  order_.insert(at(first + same), fresh.begin(), fresh.end());
  if (count != points.size()) renumber(first + same, size());
}

void VertexPath::reverse(std::size_t first, std::size_t last) {
  std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(first),
               order_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  renumber(first, last + 1);
}

void VertexPath::relocate(std::size_t first, std::size_t last, std::size_t after, bool turned) {
  if (turned) reverse(first, last);
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  if (after > last) {
    std::rotate(at(first), at(last + 1), at(after + 1));
    renumber(first, after + 1);
  } else {
    std::rotate(at(after + 1), at(first), at(last + 1));
    renumber(after + 1, last + 1);
  }
}

std::optional<std::size_t> VertexPath::near(const Point& p, Rng& rng) const {
  const std::vector<Id>& all = buckets_[bucket(p)];
  if (all.empty()) return std::nullopt;
  return position_[all[rng.below(all.size())]];
}

}  // namespace oxturn

#include "metrics/uncovered_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace oxturn {
namespace {

// In tile sides.
constexpr double kNear = 1e-9;   // rounding
constexpr double kTouch = 1e-6;  // parts that share less of an edge are not connected

bool boxes_touch(const Extent& a, const Extent& b) {
  return std::abs(a.centre.x - b.centre.x) <= a.half.x + b.half.x + kNear &&
         std::abs(a.centre.y - b.centre.y) <= a.half.y + b.half.y + kNear;
}

/// Do two edges lie on one line and overlap?
bool share_edge(const Convex& a, const Convex& b) {
  for (std::size_t i = 0, last = a.size - 1; i < a.size; last = i++) {
    const Vec from = a.at[last], along = a.at[i] - from;
    const double length = std::sqrt(dot(along, along));
    if (length < kTouch) continue;
    const Vec u = (1 / length) * along;
    const auto off = [&](Vec p) { return std::abs(cross(u, p - from)); };
    bool near = off(b.at[b.size - 1]) <= kNear;
    for (std::size_t k = 0, before = b.size - 1; k < b.size; before = k++) {
      const bool was_near = near;
      near = off(b.at[k]) <= kNear;
      if (!was_near || !near) continue;
      const double s = dot(u, b.at[before] - from), t = dot(u, b.at[k] - from);
      if (std::min(length, std::max(s, t)) - std::max(0.0, std::min(s, t)) > kTouch) return true;
    }
  }
  return false;
}

}  // namespace

void UncoveredPieces::start_row(std::int64_t row) {
  join(below_, bottom_);
  below_.clear();
  if (row == row_ + 1) below_.swap(top_);
  bottom_.clear();
  top_.clear();
  right_.clear();
  row_ = row;
  column_ = -1;
}

/// Joins parts on both sides of a border where they share some of it.
void UncoveredPieces::join(std::vector<Touch>& left, std::vector<Touch>& right) {
  const auto by_from = [](const Touch& l, const Touch& r) { return l.from < r.from; };
  std::sort(left.begin(), left.end(), by_from);
  std::sort(right.begin(), right.end(), by_from);
  for (std::size_t i = 0, k = 0; i < left.size() && k < right.size();) {
    if (std::min(left[i].to, right[k].to) - std::max(left[i].from, right[k].from) > kTouch)
      joined_.unite(left[i].part, right[k].part);
    left[i].to < right[k].to ? ++i : ++k;
  }
}

/// `vertices` are relative to `centre`.
template <class Vertices>
std::size_t UncoveredPieces::new_part(double area, Vec centre, const Vertices& vertices) {
  Vec sum{0, 0};
  for (const Vec p : vertices) sum = sum + p;
  parts_.push_back({area, centre + (1.0 / static_cast<double>(vertices.size())) * sum});
  if (outlines_ == MissedOutlines::kept) {
    sizes_.push_back(static_cast<std::uint8_t>(vertices.size()));
    for (const Vec p : vertices) vertices_.push_back(centre + p);
  }
  joined_.add();
  return parts_.size() - 1;
}

/// `c` is relative to `centre`.
void UncoveredPieces::add_part(const Convex& c, double area, Vec centre) {
  const std::size_t part = new_part(area, centre, std::span(c.at.data(), c.size));
  for (std::size_t i = 0; i < c.size; ++i) {
    const Vec p = c.at[i], q = c.at[(i + 1) % c.size];
    const auto touch = [&](double a, double b) { return Touch{std::min(a, b), std::max(a, b), part}; };
    const auto on = [](double a, double b, double border) {
      return std::abs(a - border) < kNear && std::abs(b - border) < kNear;
    };
    if (on(p.x, q.x, -0.5)) left_.push_back(touch(centre.y + p.y, centre.y + q.y));
    if (on(p.x, q.x, 0.5)) right_.push_back(touch(centre.y + p.y, centre.y + q.y));
    if (on(p.y, q.y, -0.5)) bottom_.push_back(touch(centre.x + p.x, centre.x + q.x));
    if (on(p.y, q.y, 0.5)) top_.push_back(touch(centre.x + p.x, centre.x + q.x));
  }
}

void UncoveredPieces::add_tile(std::int64_t column, const std::vector<Convex>& uncovered, const TileTarget& target) {
  std::vector<Touch> before;
  before.swap(right_);
  left_.clear();
  pieces_ = uncovered;
  target.cut(pieces_, spare_);
  const Vec centre{static_cast<double>(column) + 0.5, static_cast<double>(row_) + 0.5};
  const std::size_t first = parts_.size();
  boxes_.clear();
  for (const Convex& c : pieces_) {
    const double size = area(c);
    if (size < kLeastArea || !target.contains(middle_of(c))) continue;
    add_part(c, size, centre);
    boxes_.push_back(extent_of({&c, 1}));
    pieces_[boxes_.size() - 1] = c;
  }
  if (boxes_.size() > 1) join_within(first);
  if (column == column_) join(before, left_);
  column_ = column + 1;
}

/// Joins the parts of a tile, in pieces_ and from parts_[first] on, that share an edge: a sweep from left to right.
void UncoveredPieces::join_within(std::size_t first) {
  order_.clear();
  for (std::size_t i = 0; i < boxes_.size(); ++i) order_.emplace_back(boxes_[i].centre.x - boxes_[i].half.x, i);
  std::sort(order_.begin(), order_.end());
  for (std::size_t n = 0; n < order_.size(); ++n) {
    const std::size_t i = order_[n].second;
    const double right = boxes_[i].centre.x + boxes_[i].half.x + kNear;
    for (std::size_t m = n + 1; m < order_.size() && order_[m].first <= right; ++m) {
      const std::size_t k = order_[m].second;
      if (!boxes_touch(boxes_[i], boxes_[k]) || joined_.same(first + i, first + k)) continue;
      if (share_edge(pieces_[i], pieces_[k])) joined_.unite(first + i, first + k);
    }
  }
}

void UncoveredPieces::add_run(std::int64_t from, std::int64_t to) {
  std::vector<Touch> before;
  before.swap(right_);
  const double low = static_cast<double>(row_), left = static_cast<double>(from), right = static_cast<double>(to);
  const std::size_t part =
      new_part(right - left, {left, low}, std::array{Vec{0, 0}, Vec{right - left, 0}, Vec{right - left, 1}, Vec{0, 1}});
  left_.assign(1, {low, low + 1, part});
  right_.assign(1, {low, low + 1, part});
  bottom_.push_back({left, right, part});
  top_.push_back({left, right, part});
  if (from == column_) join(before, left_);
  column_ = to;
}

/// By representative.
std::vector<double> UncoveredPieces::areas_of_pieces() {
  std::vector<double> areas(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) areas[joined_.find(i)] += parts_[i].area;
  return areas;
}

/// The outline of the next part, whose vertices are freed.
Ring UncoveredPieces::take_outline(const Point& origin, double side, std::size_t size) {
  Ring ring;
  ring.reserve(size);
  for (std::size_t k = 0; k < size; ++k) ring.push_back(origin + side * Point(vertices_[k].x, vertices_[k].y));
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(size));
  return ring;
}

std::vector<MissedPiece> UncoveredPieces::take(const Point& origin, double side, double least) {
  start_row(row_ + 2);  // joins the last row
  const std::vector<double> areas = areas_of_pieces();
  std::vector<std::uint32_t> piece_of(parts_.size());
  std::vector<std::size_t> largest;  // largest: part of a piece
  std::vector<MissedPiece> pieces;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Ring outline;
    if (outlines_ == MissedOutlines::kept) outline = take_outline(origin, side, sizes_[i]);
    const std::size_t root = joined_.find(i);
    if (areas[root] <= least) continue;
    if (piece_of[root] == 0) {
      pieces.push_back({areas[root] * side * side, {}, {}});
      largest.push_back(i);
      piece_of[root] = static_cast<std::uint32_t>(pieces.size());
    }
    const std::size_t piece = piece_of[root] - 1;
    if (parts_[i].area >= parts_[largest[piece]].area) {
      largest[piece] = i;
      pieces[piece].at = origin + side * Point(parts_[i].middle.x, parts_[i].middle.y);
    }
    if (!outline.empty()) pieces[piece].outline.push_back(std::move(outline));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const MissedPiece& l, const MissedPiece& r) { return l.area_m2 > r.area_m2; });
  *this = UncoveredPieces(outlines_);
  return pieces;
}

}  // namespace oxturn

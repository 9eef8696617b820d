#include "metrics/target_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oxturn {

bool TileTarget::contains(Vec p) const {
  int winding = winding_;
  for (const Step& s : crossings_)
    if (s.x < p.x) winding += s.sign;
  for (const Edge& e : edges_)
    if (e.from < p.x && p.x <= e.to && dot(e.above.normal, p) <= e.above.reach) winding += e.sign;
  return winding > 0;
}

namespace {

/// Divides each piece along the line that bounds `h`, if the piece reaches across it and meets from <= x <= to.
void divide(std::vector<Convex>& pieces, const HalfPlane& h, double from, double to, std::vector<Convex>& spare) {
  spare.clear();
  for (const Convex& c : pieces) {
    const Extent box = extent_of({&c, 1});
    if (box.centre.x + box.half.x <= from || box.centre.x - box.half.x >= to) {
      spare.push_back(c);
      continue;
    }
    if (c.size > Convex::kWide) {
      const auto [one, two] = halves(c);
      oxturn::divide(one, h, spare);
      oxturn::divide(two, h, spare);
      continue;
    }
    oxturn::divide(c, h, spare);
  }
  pieces.swap(spare);
}

}  // namespace

bool TileTarget::cut(std::vector<Convex>& pieces, std::vector<Convex>& spare) const {
  if (edges_.size() > kMostEdges) return false;
  const auto upright = [&](double x) {
    if (std::abs(x) < 0.5) divide(pieces, {{1, 0}, x}, -1, 1, spare);
  };
  for (const Step& s : crossings_) upright(s.x);
  for (const Edge& e : edges_) {
    upright(e.from);
    upright(e.to);
  }
  for (const Edge& e : edges_) divide(pieces, e.above, e.from + kSlack, e.to - kSlack, spare);
  return true;
}

double TileTarget::area_in(const Convex& c) const {
  if (c.size < 3) return 0;
  double left = c.at[0].x, right = left;
  for (std::size_t i = 1; i < c.size; ++i) {
    left = std::min(left, c.at[i].x);
    right = std::max(right, c.at[i].x);
  }
  const double whole = area(c);
  double sum = winding_ * whole;
  Convex one, two;
  for (const Step& s : crossings_) {
    if (s.x >= right) continue;
    const Convex* part = s.x <= left ? &c : clip(c, {{-1, 0}, -s.x}, one);
    if (part != nullptr) sum += s.sign * area(*part);
  }
  for (const Edge& e : edges_) {
    if (e.from >= right || e.to <= left) continue;
    const Convex* part = clip(c, e.above, one);
    if (part != nullptr && e.from > left) part = clip(*part, {{-1, 0}, -e.from}, two);
    if (part != nullptr && e.to < right) part = clip(*part, {{1, 0}, e.to}, part == &one ? two : one);
    if (part != nullptr) sum += e.sign * area(*part);
  }
  return std::clamp(sum, 0.0, whole);
}

double TileTarget::area_in(const std::vector<Convex>& pieces) const {
  if (outside()) return 0;
  if (inside()) return area(pieces);
  double sum = 0;
  for (const Convex& c : pieces) sum += area_in(c);
  return sum;
}

TargetRows::TargetRows(const Region& region, const Point& origin, double side) {
  edges_.reserve(vertex_count(region));
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = (ring[i] - origin) / side, b = (ring[i + 1 == ring.size() ? 0 : i + 1] - origin) / side;
      edges_.push_back({{a.x(), a.y()}, {b.x(), b.y()}});
      last_row_ = std::max(last_row_, static_cast<std::int64_t>(std::floor(a.y())));
      last_column_ = std::max(last_column_, static_cast<std::int64_t>(std::floor(a.x())));
    }
  });
  std::stable_sort(edges_.begin(), edges_.end(),
                   [](const Edge& l, const Edge& r) { return std::min(l.a.y, l.b.y) < std::min(r.a.y, r.b.y); });
}

void TargetRows::start_row(std::int64_t row) {
  row_ = row;
  const double low = static_cast<double>(row), high = low + 1;
  for (; next_ < edges_.size() && std::min(edges_[next_].a.y, edges_[next_].b.y) <= high; ++next_)
    active_.push_back(next_);
  std::erase_if(active_, [&](std::size_t e) { return std::max(edges_[e].a.y, edges_[e].b.y) < low; });

  in_row_.clear();
  crossings_.clear();
  here_.clear();
  next_in_row_ = next_crossing_ = 0;
  winding_ = 0;
  for (const std::size_t e : active_) add_to_row(e);
  std::sort(in_row_.begin(), in_row_.end(),
            [](const InRow& l, const InRow& r) { return l.first != r.first ? l.first < r.first : l.edge < r.edge; });
  std::sort(crossings_.begin(), crossings_.end(),
            [](const auto& l, const auto& r) { return l.x != r.x ? l.x < r.x : l.sign < r.sign; });
}

/// The edge's columns in the row, and where it crosses the row's lower line.
void TargetRows::add_to_row(std::size_t edge) {
  constexpr double kSpare = 1e-9;  // an extra tile costs little, a missing one would be wrong
  const double low = static_cast<double>(row_), high = low + 1;
  const Vec a = edges_[edge].a, b = edges_[edge].b;
  const double slope = b.y != a.y ? (b.x - a.x) / (b.y - a.y) : 0;
  const double least = std::min(a.x, b.x), most = std::max(a.x, b.x);
  const auto x_at = [&](double y) { return std::clamp(a.x + (y - a.y) * slope, least, most); };
  const auto x_end = [&](Vec p) { return p.y < low ? x_at(low) : p.y > high ? x_at(high) : p.x; };
  const double x0 = x_end(a), x1 = x_end(b);
  in_row_.push_back({static_cast<std::int64_t>(std::floor(std::min(x0, x1) - kSpare)),
                     static_cast<std::int64_t>(std::floor(std::max(x0, x1) + kSpare)), edge});
  if ((a.y < low) != (b.y < low)) crossings_.push_back({x_at(low), a.y < low ? -1 : 1});
}

std::int64_t TargetRows::alike_until(std::int64_t column) const {
  if (!here_.empty()) return column + 1;
  std::int64_t until = std::numeric_limits<std::int64_t>::max();
  if (next_in_row_ < in_row_.size()) until = in_row_[next_in_row_].first;
  if (next_crossing_ < crossings_.size())
    until = std::min(until, static_cast<std::int64_t>(std::floor(crossings_[next_crossing_].x)));
  return std::max(until, column + 1);
}

const TileTarget& TargetRows::tile(std::int64_t column) {
  const double left = static_cast<double>(column), low = static_cast<double>(row_);
  const Vec centre{left + 0.5, low + 0.5};
  for (; next_in_row_ < in_row_.size() && in_row_[next_in_row_].first <= column; ++next_in_row_)
    here_.push_back(in_row_[next_in_row_]);
  std::erase_if(here_, [&](const InRow& e) { return e.last < column; });
  for (; next_crossing_ < crossings_.size() && crossings_[next_crossing_].x < left; ++next_crossing_)
    winding_ += crossings_[next_crossing_].sign;

  tile_.winding_ = winding_;
  tile_.edges_.clear();
  tile_.crossings_.clear();
  for (std::size_t k = next_crossing_; k < crossings_.size() && crossings_[k].x < left + 1; ++k)
    tile_.crossings_.push_back({crossings_[k].x - centre.x, crossings_[k].sign});
  for (const InRow& in : here_) {
    const Vec a = edges_[in.edge].a, b = edges_[in.edge].b;
    if (a.x == b.x) continue;  // its neighbours and the crossings of the lower side account for it
    double ax = a.x, bx = b.x;
    if ((a.y < low) != (b.y < low)) {
      const double x = std::clamp(a.x + (low - a.y) * ((b.x - a.x) / (b.y - a.y)), std::min(ax, bx), std::max(ax, bx));
      (a.y < low ? ax : bx) = x;
    } else if (a.y < low) {
      continue;
    }
    const bool right = b.x > a.x;
    Vec up = right ? Vec{a.y - b.y, b.x - a.x} : Vec{b.y - a.y, a.x - b.x};
    up = (1 / length(up)) * up;
    const Vec p = a - centre;
    tile_.edges_.push_back({std::min(ax, bx) - centre.x, std::max(ax, bx) - centre.x,
                            HalfPlane{Vec{-up.x, -up.y}, -dot(up, p)}, right ? 1 : -1});
  }
  return tile_;
}

}  // namespace oxturn

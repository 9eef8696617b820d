#include "algorithms/drawing/finished_work.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/random.hpp"

namespace oxturn {
namespace {

constexpr double kTouch = 1e-3;  // of the radius: nearer by so little is no crossing, as chords of arcs are

using Span = std::pair<double, double>;

void widen(std::optional<Span>& span, const std::optional<Span>& by) {
  if (!by) return;
  if (!span) span = by;
  span = Span(std::min(span->first, by->first), std::max(span->second, by->second));
}

/// The part of a + t u, 0 <= t <= length, in the disc.
std::optional<Span> in_disc(const Point& a, const Point& u, double length, const Point& centre, double radius) {
  const Point d = centre - a;
  const double middle = d.dot(u), off = cross(u, d), root = radius * radius - off * off;
  if (root <= 0) return std::nullopt;
  const double half = std::sqrt(root), low = std::max(0.0, middle - half), high = std::min(length, middle + half);
  if (low >= high) return std::nullopt;
  return Span(low, high);
}

/// The part of the span on which |offset + t * slope| <= bound, or between `least` and `most`.
std::optional<Span> between(std::optional<Span> span, double offset, double slope, double least, double most) {
  if (!span) return span;
  if (std::abs(slope) < 1e-12) return offset >= least && offset <= most ? span : std::nullopt;
  double low = (least - offset) / slope, high = (most - offset) / slope;
  if (low > high) std::swap(low, high);
  const Span cut(std::max(low, span->first), std::min(high, span->second));
  if (cut.first >= cut.second) return std::nullopt;
  return cut;
}

/// The part of a + t u, 0 <= t <= length, nearer than `radius` to the segment pq.
std::optional<Span> near_segment(const Point& a, const Point& u, double length, const Point& p, const Point& q,
                                 double radius) {
  std::optional<Span> span = in_disc(a, u, length, p, radius);
  widen(span, in_disc(a, u, length, q, radius));
  const double along = distance(p, q);
  if (along > 0) {
    const Point d = (q - p) / along;
    widen(span, between(between(Span(0, length), (a - p).dot(d), u.dot(d), 0, along), cross(d, a - p), cross(d, u),
                        -radius, radius));
  }
  return span;
}

}  // namespace

FinishedWork::FinishedWork(std::vector<DrawnPiece> pieces, double exempt)
    : pieces_(std::move(pieces)), exempt_(exempt), finished_(pieces_.size(), false) {
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    widest_ = std::max(widest_, pieces_[k].half_width);
    const Polyline& line = pieces_[k].points;
    for (std::size_t i = 1; i < line.size(); ++i)
      items_.push_back({line[i - 1], line[i], static_cast<std::uint32_t>(k)});
  }
  grid_ = UniformGrid(items_.size(), [&](std::size_t i) { return std::array{items_[i].a, items_[i].b}; });
}

void FinishedWork::set(std::size_t piece, bool finished) {
  if (finished_[piece] == finished) return;
  finished_[piece] = finished;
  fingerprint_ ^= Rng(piece + 1).bits();
}

std::vector<FinishedWork::Interval> FinishedWork::inside(const Point& a, const Point& b, const Point& from,
                                                         const Point& to, double growth) const {
  std::vector<Interval> found;
  const double length = distance(a, b);
  if (!(length > 0)) return found;
  const Point u = (b - a) / length;
  const auto at_start = in_disc(a, u, length, from, exempt_ + growth),
             at_end = in_disc(a, u, length, to, exempt_ + growth);
  // What the discs leave: three parts at most.
  std::vector<Span> open{{0, length}};
  for (const auto& disc : {at_start, at_end}) {
    if (!disc) continue;
    std::vector<Span> left;
    for (const Span& s : open) {
      if (disc->first > s.first) left.push_back({s.first, std::min(s.second, disc->first)});
      if (disc->second < s.second) left.push_back({std::max(s.first, disc->second), s.second});
    }
    open = std::move(left);
  }
  std::vector<std::uint32_t> near;
  for (const Span& s : open)
    grid_.visit_items(std::array{Point(a + s.first * u), Point(a + s.second * u)}, widest_ + growth,
                      [&](std::uint32_t i) {
                        if (finished_[items_[i].piece]) near.push_back(i);
                        return false;
                      });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const std::uint32_t i : near) {
    const Item& item = items_[i];
    const double radius = (pieces_[item.piece].half_width + growth) * (1 - kTouch);
    const auto span = near_segment(a, u, length, item.a, item.b, radius);
    if (!span) continue;
    for (const Span& s : open)
      if (const Span cut(std::max(s.first, span->first), std::min(s.second, span->second)); cut.first < cut.second)
        found.push_back({cut.first, cut.second, item.piece});
  }
  return found;
}

std::vector<std::size_t> FinishedWork::crossed(const Polyline& line, double keep_off) const {
  std::vector<std::size_t> pieces;
  for (std::size_t i = 1; i < line.size(); ++i) {
    for (const Interval& k : inside(line[i - 1], line[i], line.front(), line.back(), 0)) pieces.push_back(k.piece);
    if (keep_off > 0)
      for (const Interval& k : inside(line[i - 1], line[i], line.front(), line.back(), keep_off))
        pieces.push_back(k.piece);
  }
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  return pieces;
}

bool FinishedWork::clear(const Polyline& line, double keep_off) const {
  for (std::size_t i = 1; i < line.size(); ++i)
    for (const double growth : {keep_off, 0.0})
      if (!inside(line[i - 1], line[i], line.front(), line.back(), growth).empty()) return false;
  return true;
}

double FinishedWork::crossing_m(const Polyline& line) const {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += crossing_m(line[i - 1], line[i], line.front(), line.back());
  return sum;
}

double FinishedWork::crossing_m(const Point& a, const Point& b, const Point& from, const Point& to) const {
  std::vector<Interval> all = inside(a, b, from, to, 0);
  std::sort(all.begin(), all.end(), [](const Interval& x, const Interval& y) { return x.low < y.low; });
  double sum = 0, end = 0;
  for (const Interval& k : all) {
    sum += std::max(0.0, k.high - std::max(k.low, end));
    end = std::max(end, k.high);
  }
  return sum;
}

}  // namespace oxturn

// Decisions  1. The distance of a segment is convex along the direction of sight, so it is greatest at the ends of the
//               part within a slice.
//            2. Within an angle a, the distance of a segment is at least cos(a / 2) times the lesser one at the two
//               sides.
//            3. Directions count as seen up to some tolerances beside an edge: points nearer to the eye than kNear
//               tolerances have no reliable direction.
#include "algorithms/tethered/sight_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostSlices = 64, kSlicesPerEdge = 4;
constexpr double kSlack = 4;        // tolerances
constexpr double kNear = 1000;      // tolerances
constexpr double kRounding = 1e-9;  // radians
constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// The vector turned by up to 0.005 radians, to 3e-14: sine and cosine would take longer than all else.
Point turned_little(const Point& v, double by) {
  const double square = by * by, sine = by * (1 - square / 6), cosine = 1 - square / 2 * (1 - square / 12);
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

}  // namespace

SightRange::SightRange(const Point& eye, double begin, double width, const Ring& seen, double tolerance)
    : begin_(begin),
      width_(width),
      tolerance_(tolerance),
      slices_(std::clamp<std::size_t>(kSlicesPerEdge * seen.size(), 1, kMostSlices), 0.0),
      sure_(slices_.size(), kUnknown) {
  const std::vector<Point> borders = border_directions();
  for (std::size_t i = 0; i < seen.size(); ++i) add_edge(seen[i] - eye, seen[(i + 1) % seen.size()] - eye, borders);
  std::ranges::replace(sure_, kUnknown, 0.0);
  std::ranges::stable_sort(edges_, {}, &Edge::from);
  edges_.shrink_to_fit();
  for (const Edge& edge : edges_) widest_pad_ = std::max(widest_pad_, edge.pad);
}

std::size_t SightRange::slice_of(double angle) const {
  if (!(angle > 0) || !(width_ > 0)) return 0;
  return std::min(static_cast<std::size_t>(angle / width_ * count()), slices_.size() - 1);
}

/// Unit vectors where slices begin, and where the last one ends.
std::vector<Point> SightRange::border_directions() const {
  std::vector<Point> directions;
  for (std::size_t s = 0; s <= slices_.size(); ++s)
    directions.push_back(rotated({1, 0}, begin_ + (s == 0 ? 0 : end_of(s - 1))));
  return directions;
}

/// From the eye: a and b.
void SightRange::add_edge(const Point& a, const Point& b, const std::vector<Point>& borders) {
  const double da = a.norm(), db = b.norm(), near = kNear * tolerance_;
  if (std::max(da, db) <= tolerance_) return;
  if (std::min(da, db) <= near) return add_edge_from_eye(da > db ? a : b, std::min(da, db) <= kSlack * tolerance_);
  const double turn = math::atan2(cross(a, b), a.dot(b)), first = math::atan2(a.y(), a.x()) - begin_;
  add_span(first + std::min(turn, 0.0), first + std::max(turn, 0.0), a, b, borders);
}

/// An edge that passes the eye nearer than kNear tolerances and ends at b: at an angle t from b it is at most
/// near / sin t away. If it begins at the eye itself, it hides nothing beside it.
void SightRange::add_edge_from_eye(const Point& b, bool at_eye) {
  const double most = b.norm(), near = kNear * tolerance_, angle = math::atan2(b.y(), b.x()) - begin_;
  const double pad = kSlack * tolerance_ / most + kRounding;
  reliable_ = reliable_ && at_eye;
  along_walls_.emplace_back(angle - 2 * kPi * std::floor(angle / (2 * kPi)), pad);
  for (std::size_t s = 0; s < slices_.size(); ++s) {
    const double begins = s == 0 ? 0 : end_of(s - 1), ends = end_of(s);
    // From the middle of the slice, less half of it.
    const double from_middle = std::abs(std::remainder(angle - (begins + ends) / 2, 2 * kPi));
    const double off = std::min(from_middle - (ends - begins) / 2 - kRounding, kPi / 2);
    if (!at_eye || off <= pad) limit_sight(s, 0);
    const double range = off > 0 ? std::min(most, near * kPi / (2 * off)) : most;
    slices_[s] = std::max(slices_[s], range * (1 + kRounding) + near);
  }
}

/// The part of the edge ab between two angles, of which either may differ by full turns.
void SightRange::add_span(double from, double to, const Point& a, const Point& b, const std::vector<Point>& borders) {
  const double da = a.norm(), db = b.norm(), most = std::max(da, db);
  const double pad = kSlack * tolerance_ / std::min(da, db) + kRounding;
  const double turns = std::floor(from / (2 * kPi)) * 2 * kPi;
  const double area = cross(a, b);
  const Point along = b - a;
  // The distance of the edge at a border; in doubt that of its farther end.
  const auto distance_at = [&](const Point& border) {
    const double d = area / cross(border, along);
    return d > 0 && d < most ? d : most;
  };
  // The same, from below.
  const bool forwards = area > 0;
  const auto sure_at = [&](double angle, const Point& border) {
    if (angle <= from) return forwards ? da : db;
    if (angle >= to) return forwards ? db : da;
    const double d = area / cross(border, along);
    return d > 0 ? std::min(d, most) : 0;
  };
  const double narrowing = std::max(0.0, math::cos(std::min(width_ / count(), kPi) / 2)) * (1 - kRounding);
  for (const double shift : {-turns - 2 * kPi, -turns, -turns + 2 * kPi}) {
    const double low = from + shift - pad, high = to + shift + pad;
    if (high < 0 || low > width_) continue;
    edges_.push_back({from + shift, to + shift, forwards ? a : b, forwards ? b : a, pad});
    const std::size_t last = slice_of(high);
    for (std::size_t s = slice_of(low); s <= last; ++s) {
      const double begins = s == 0 ? 0 : end_of(s - 1), ends = end_of(s);
      const bool inner = begins > from + shift + pad && ends < to + shift - pad;  // no end of the edge lies within
      const double farthest = inner ? std::max(distance_at(borders[s]), distance_at(borders[s + 1])) : most;
      slices_[s] = std::max(slices_[s], farthest * (1 + kRounding) + kSlack * tolerance_);
      const double sure = std::min(sure_at(begins - shift, borders[s]), sure_at(ends - shift, borders[s + 1]));
      limit_sight(s, narrowing * sure - kSlack * tolerance_);
    }
  }
}

void SightRange::add(double angle, double distance) {
  for (const double beside : {angle - kRounding, angle + kRounding}) {
    double& range = slices_[slice_of(beside)];
    range = std::max(range, distance + kSlack * tolerance_);
  }
}

/// Of an edge, from its pad before an angle to its pad after it.
SightRange::Span SightRange::distances(const Edge& edge, double angle, const Point& direction) {
  const Point along = edge.b - edge.a;
  const double area = cross(edge.a, edge.b), most = std::max(edge.a.norm(), edge.b.norm());
  const auto at = [&](double by) {
    if (angle + by <= edge.from) return edge.a.norm();
    if (angle + by >= edge.to) return edge.b.norm();
    return area / cross(turned_little(direction, by), along);
  };
  const double first = at(-edge.pad), last = at(edge.pad);
  if (!(first > 0 && last > 0)) return {0, most};
  return {std::min(first, last), std::min(std::max(first, last), most)};
}

SightRange::Answer SightRange::look(double angle, const Point& direction, double distance) const {
  if (!reliable_) return Answer::unknown;
  for (const auto& [wall, pad] : along_walls_)
    if (const double off = std::abs(angle - wall); std::min(off, 2 * kPi - off) <= pad) return Answer::unknown;
  Span seen{kUnknown, 0};
  auto edge = std::ranges::upper_bound(edges_, angle + widest_pad_, {}, &Edge::from);
  while (edge != edges_.begin() && (--edge)->to >= angle - 2 * widest_pad_) {
    if (edge->from - edge->pad > angle || edge->to + edge->pad < angle) continue;
    const Span span = distances(*edge, angle, direction);
    seen = {std::min(seen.least, span.least), std::max(seen.most, span.most)};
  }
  const double slack = kSlack * tolerance_ + kRounding * distance;
  if (seen.least == kUnknown) return Answer::unknown;
  return distance < seen.least - slack ? Answer::seen : distance > seen.most + slack ? Answer::hidden : Answer::unknown;
}

double SightRange::sure(double from, double to) const {
  const auto first = sure_.begin() + static_cast<std::ptrdiff_t>(slice_of(from - kRounding));
  return *std::min_element(first, sure_.begin() + static_cast<std::ptrdiff_t>(slice_of(to + kRounding)) + 1);
}

double SightRange::farthest(double from, double to) const {
  const auto first = slices_.begin() + static_cast<std::ptrdiff_t>(slice_of(from - kRounding));
  const auto last = slices_.begin() + static_cast<std::ptrdiff_t>(slice_of(to + kRounding));
  return *std::max_element(first, last + 1);
}

}  // namespace oxturn

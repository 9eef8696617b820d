#include "algorithms/baseline/bumper.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr double kLookAhead = 4;  // tool widths in which walls are searched at a time
// Nearer than this, in gaps, the robot touches the wall, and the direction to its nearest point is mere rounding.
constexpr double kTouching = 16;
// Of the angle between a wall's normal and the direction to its nearest point. Beyond it, that point is the end of an
// edge and belongs to a neighbour's wall; otherwise the end of a wall that turns away beside the robot would be one
// ahead.
constexpr double kLeastCosine = 0.7;

}  // namespace

Bumper::Bumper(const Problem& problem)
    : walls_(problem.walls()),
      tool_width_(problem.robot().tool_width),
      gap_(problem.tolerance() / 4),
      at_(problem.start()),
      path_{problem.start()} {}

Point Bumper::normal(std::size_t edge) const {
  const EdgeIndex::Edge& e = walls_.edges()[edge];
  return perpendicular(e.b - e.a).normalized();  // free space is on the left
}

/// The contact with one wall. Walls that the robot does not drive towards do not count, so it can leave a wall that it
/// touches, or slide along it.
std::optional<Bumper::Hit> Bumper::hit(std::size_t edge, const Point& along, double length) const {
  const Point away = normal(edge);
  const double approach = -along.dot(away);
  if (!(approach > 0)) return std::nullopt;
  const EdgeIndex::Edge& e = walls_.edges()[edge];
  const double off = (at_ - e.a).dot(away);
  if (off < -4 * gap_ || off - approach * length > gap_ / 2) return std::nullopt;
  const Point contact = at_ + std::clamp(off / approach, 0.0, length) * along;
  const double size = distance(e.a, e.b), k = (contact - e.a).dot(e.b - e.a) / size;
  if (k < -gap_ || k > size + gap_) return std::nullopt;
  return Hit{std::max(0.0, (off - gap_) / approach), away};
}

/// A few tool widths at a time: what lies farther away is not looked at if something nearer stops the robot.
std::optional<Bumper::Hit> Bumper::first_hit(const Point& along, double length) const {
  const double step = kLookAhead * tool_width_;
  for (double from = 0; from < length; from += step) {
    const double until = std::min(length, from + step);
    const Point a = at_ + from * along, b = at_ + until * along;
    Box box{a.cwiseMin(b), a.cwiseMax(b)};
    box.grow(4 * gap_);
    std::optional<Hit> first;
    walls_.for_each_near(box, [&](std::size_t edge) {
      const auto here = hit(edge, along, until);
      if (here && (!first || here->distance < first->distance)) first = here;
    });
    if (first) return first;
  }
  return std::nullopt;
}

std::optional<Point> Bumper::drive(const Point& to) {
  const double length = distance(at_, to);
  if (!(length > 0)) return std::nullopt;
  const Point along = (to - at_) / length;
  const auto hit = first_hit(along, length);
  if (!hit) {
    go(to);
    return std::nullopt;
  }
  if (hit->distance > 0) go(at_ + std::min(hit->distance, length) * along);
  return hit->away;
}

std::optional<Bumper::Wall> Bumper::feel(double reach, const Point& towards, double cosine) const {
  Box box{at_, at_};
  box.grow(reach);
  std::optional<Wall> nearest;
  walls_.for_each_near(box, [&](std::size_t edge) {
    const EdgeIndex::Edge& e = walls_.edges()[edge];
    const Point point = nearest_on_segment(at_, e.a, e.b);
    const double off = distance(at_, point);
    if (off >= (nearest ? nearest->distance : reach)) return;
    const Point away = off < kTouching * gap_ ? normal(edge) : Point((at_ - point) / off);
    if (away.dot(normal(edge)) < kLeastCosine) return;
    if (-away.dot(towards) >= cosine) nearest = Wall{off, away};
  });
  return nearest;
}

void Bumper::go(const Point& to) {
  if (to == at_) return;
  driven_ += distance(at_, to);
  at_ = to;
  if (path_.size() > 1) {
    const Point& before = path_[path_.size() - 2];
    const Point on = to - before;
    if (std::abs(cross(heading_, on)) < gap_ / 2 && on.dot(heading_) > (path_.back() - before).dot(heading_)) {
      path_.back() = to;
      return;
    }
  }
  heading_ = (to - path_.back()).normalized();
  path_.push_back(to);
}

}  // namespace oxturn

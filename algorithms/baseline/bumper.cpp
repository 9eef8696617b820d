#include "algorithms/baseline/bumper.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {

Bumper::Bumper(const Problem& problem)
    : walls_(problem.walls()),
      tool_width_(problem.robot().tool_width),
      hair_(problem.tolerance() / 4),
      at_(problem.start()),
      way_{problem.start()} {}

Point Bumper::normal(std::size_t edge) const {
  const EdgeIndex::Edge& e = walls_.edges()[edge];
  return perpendicular(e.b - e.a).normalized();  // free space is to the left
}

// Only walls that the robot drives towards count, so it can leave a wall it touches, or slide along it. Looked for a few
// tool widths at a time: what lies farther on is not looked at if something nearer stops the robot.
std::optional<Bumper::Hit> Bumper::first_hit(const Point& along, double far) const {
  const double piece = 4 * tool_width_;
  for (double from = 0; from < far; from += piece) {
    const double until = std::min(far, from + piece);
    Box box;
    box.add(at_ + from * along);
    box.add(at_ + until * along);
    box.grow(4 * hair_);
    std::optional<Hit> first;
    walls_.for_each_near(box, [&](std::size_t edge) {
      const Point away = normal(edge);
      const double steep = -along.dot(away);
      if (!(steep > 0)) return;
      const EdgeIndex::Edge& e = walls_.edges()[edge];
      const double off = (at_ - e.a).dot(away);
      if (off < -4 * hair_ || off - steep * until > hair_ / 2) return;
      const Point place = at_ + std::clamp(off / steep, 0.0, until) * along;
      const double size = distance(e.a, e.b), k = (place - e.a).dot(e.b - e.a) / size;
      if (k < -hair_ || k > size + hair_) return;
      const double stop = std::max(0.0, (off - hair_) / steep);
      if (!first || stop < first->far) first = Hit{stop, away};
    });
    if (first) return first;
  }
  return std::nullopt;
}

std::optional<Point> Bumper::drive(const Point& to) {
  const double far = distance(at_, to);
  if (!(far > 0)) return std::nullopt;
  const Point along = (to - at_) / far;
  const auto hit = first_hit(along, far);
  if (!hit) {
    go(to);
    return std::nullopt;
  }
  if (hit->far > 0) go(at_ + std::min(hit->far, far) * along);
  return hit->away;
}

std::optional<Bumper::Wall> Bumper::feel(double reach, const Point& towards, double cosine) const {
  Box box;
  box.add(at_);
  box.grow(reach);
  std::optional<Wall> nearest;
  walls_.for_each_near(box, [&](std::size_t edge) {
    const EdgeIndex::Edge& e = walls_.edges()[edge];
    const Point place = nearest_on_segment(at_, e.a, e.b);
    const double off = oxturn::distance(at_, place);
    if (off >= (nearest ? nearest->distance : reach)) return;
    // Touching, the direction to the wall's nearest place is rounding alone.
    const Point away = off < 16 * hair_ ? normal(edge) : Point((at_ - place) / off);
    // What lies past the end of an edge is not its wall but a neighbour's: else the end of a wall that bends away beside
    // the robot would be one ahead.
    if (away.dot(normal(edge)) < 0.7) return;
    if (-away.dot(towards) >= cosine) nearest = Wall{off, away};
  });
  return nearest;
}

void Bumper::go(const Point& to) {
  if (to == at_) return;
  driven_ += distance(at_, to);
  at_ = to;
  if (way_.size() > 1) {
    const Point& corner = way_[way_.size() - 2];
    const Point on = to - corner;
    if (std::abs(cross(heading_, on)) < hair_ / 2 && on.dot(heading_) > (way_.back() - corner).dot(heading_)) {
      way_.back() = to;
      return;
    }
  }
  heading_ = (to - way_.back()).normalized();
  way_.push_back(to);
}

}  // namespace oxturn

#include "algorithms/baseline/habits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algorithms/transit/short_segments.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr int kMostStuck = 1000;      // motions in a row that lead nowhere
constexpr double kNowhere = 1e-6;     // tool widths
constexpr double kStep = 1.0 / 16;    // tool widths, along a wall
constexpr double kChordError = 1e-3;  // tool widths, at most, of a spiral

Point unit(double angle) { return {math::cos(angle), math::sin(angle)}; }

/// One run of follow_wall().
class WallFollowing {
 public:
  WallFollowing(Vacuum& vacuum, double gap, Point& away)
      : vacuum_(vacuum),
        away_(away),
        width_(vacuum.tool_width()),
        step_(kStep * width_),
        keep_(std::max(gap, width_ / 1000)) {}

  void run(double longest) {
    const double begin = vacuum_.driven();
    // A lap ends where it began. But the robot may come upon another wall whose lap does not lead back there; that one
    // ends at a later mark, each of which is twice as far along as the one before.
    const Mark first = here();
    Mark later = first;
    const auto touched = wall_on_right();
    off_ = touched ? touched->distance : 0;
    while (!vacuum_.done() && vacuum_.driven() - begin < longest) {
      step();
      if (is_back_at(first) || is_back_at(later)) return;
      if (vacuum_.driven() - begin > 2 * (later.driven - begin) + 2 * width_) later = here();
    }
  }

 private:
  struct Mark {
    Point at, away;
    double driven;
  };
  Mark here() const { return {vacuum_.at(), away_, vacuum_.driven()}; }
  bool is_back_at(const Mark& m) const {
    return vacuum_.driven() - m.driven > 2 * width_ && distance(vacuum_.at(), m.at) < keep_ + width_ / 8 &&
           away_.dot(m.away) > 0.5;
  }
  /// A wall on the left is the other side of a passage: not one to follow, it only narrows the passage.
  std::optional<Bumper::Wall> wall_on_right() const { return vacuum_.feel(keep_ + 4 * step_, -away_, -0.1); }

  void step() {
    const Point along(away_.y(), -away_.x());
    const auto contact = advance(along);
    if (contact) {
      away_ = *contact;
      off_ = 0;
    } else if (const auto wall = wall_on_right()) {
      away_ = wall->away;
      off_ = wall->distance;
    } else {
      away_ = along;  // the wall has ended: around its corner
      off_ = keep_;
    }
  }

  /// One step along the wall, corrected towards the wanted distance. Returns the contact with a wall ahead.
  std::optional<Point> advance(const Point& along) {
    const Point from = vacuum_.at();
    const auto across = vacuum_.feel(2 * keep_ - off_, away_, 0.5);
    const double aim = across ? (off_ + across->distance) / 2 : keep_;
    const auto contact = vacuum_.drive(from + step_ * along + (aim - off_) * away_);
    if (!contact || contact->dot(away_) >= -0.5) return contact;
    // Contact with the other side of a passage. There is most room to pass with the robot pressed to the wall on the
    // right. If that does not help, it turns around.
    vacuum_.drive(vacuum_.at() - 2 * keep_ * away_);
    vacuum_.drive(vacuum_.at() + step_ * along);
    if ((vacuum_.at() - from).dot(along) > width_ / 10000) return std::nullopt;
    return contact;
  }

  Vacuum& vacuum_;
  Point& away_;
  double width_, step_, keep_;  // keep_: the wanted distance from the wall
  double off_ = 0;              // the present one
};

}  // namespace

Vacuum::Vacuum(const Problem& problem, Context& context, const StopRule& rule)
    : problem_(problem),
      context_(context),
      rule_(rule),
      bumper_(problem),
      swept_(problem.start(), problem.robot().tool_width) {
  swept_.sweep(at(), at());
}

double Vacuum::metres_left() const {
  const double by_passes = rule_.passes * swept_.area() / tool_width() - driven();
  return rule_.length_limit > 0 ? std::min(by_passes, rule_.length_limit - driven()) : by_passes;
}

bool Vacuum::done() const {
  return metres_left() < kNowhere * tool_width() || stuck_ >= kMostStuck || context_.cancelled();
}

std::optional<Point> Vacuum::drive(const Point& to) {
  const Point from = at();
  const double length = distance(from, to), left = std::max(0.0, metres_left());
  const auto contact = bumper_.drive(length > left ? lerp(from, to, left / length) : to);
  swept_.sweep(from, at());
  bumps_ += contact.has_value();
  stuck_ = distance(from, at()) > kNowhere * tool_width() ? 0 : stuck_ + 1;
  return contact;
}

std::optional<Point> Vacuum::drive_on(const Point& heading) {
  while (!done())
    if (const auto contact = drive(at() + metres_left() * heading)) return contact;
  return std::nullopt;
}

void Vacuum::leave_wall(const Point& heading, double farthest) {
  drive(at() + farthest * context_.rng().unit() * heading);
}

Point Vacuum::any_heading() { return unit(2 * kPi * context_.rng().unit()); }

Point Vacuum::heading_off(const Point& away) {
  return unit(math::atan2(away.y(), away.x()) + kPi * (context_.rng().unit() - 0.5));
}

Path Vacuum::finish() {
  context_.record("swept_m2", swept_.area());
  context_.record("bumps", static_cast<double>(bumps_));
  if (bumper_.path().size() < 2)
    throw Infeasible(fmt::format("robot '{}' touches walls on all sides of its start ({:.6g}, {:.6g})",
                                 problem_.robot().name, problem_.start().x(), problem_.start().y()));
  return without_short_segments(Path{{{true, bumper_.path()}}}, problem_);
}

std::optional<Point> spiral(Vacuum& vacuum, double pitch, const Point& heading) {
  const Point centre = vacuum.at();
  const double a = pitch / (2 * kPi), begin = math::atan2(heading.y(), heading.x());
  const double error = 0.8 * vacuum.tool_width() * kChordError;
  for (double turned = 0; !vacuum.done();) {
    // The chord over a small angle errs by angle^2 / 8 * curvature * (length per angle)^2.
    const double bow = a * (2 + turned * turned) / std::sqrt(1 + turned * turned);
    turned += std::min(0.5, std::sqrt(8 * error / bow));
    if (const auto contact = vacuum.drive(centre + a * turned * unit(begin + turned))) return contact;
  }
  return std::nullopt;
}

void follow_wall(Vacuum& vacuum, double gap, double longest, Point& away) {
  WallFollowing(vacuum, gap, away).run(longest);
}

std::optional<Point> snake(Vacuum& vacuum, double pitch, const Point& heading, const Point& side) {
  Point lane = heading;
  while (!vacuum.done()) {
    if (!vacuum.drive_on(lane)) return std::nullopt;
    const Point from = vacuum.at();
    const auto contact = vacuum.drive(from + pitch * side);
    if (contact && distance(from, vacuum.at()) < pitch / 2) return contact;
    lane = -lane;
  }
  return std::nullopt;
}

}  // namespace oxturn

#include "algorithms/baseline/habits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr int kMostStuck = 1000;
constexpr double kStep = 1.0 / 16;  // of the tool's width, along a wall

Point unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

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
  const double worth = rule_.passes * swept_.area() / tool_width() - driven();
  return rule_.length_limit > 0 ? std::min(worth, rule_.length_limit - driven()) : worth;
}

bool Vacuum::done() const {
  return metres_left() < 1e-6 * tool_width() || stuck_ >= kMostStuck || context_.cancelled();
}

std::optional<Point> Vacuum::drive(const Point& to) {
  const Point from = at();
  const double far = distance(from, to), left = std::max(0.0, metres_left());
  const auto contact = bumper_.drive(far > left ? lerp(from, to, left / far) : to);
  swept_.sweep(from, at());
  bumps_ += contact.has_value();
  stuck_ = distance(from, at()) > 1e-6 * tool_width() ? 0 : stuck_ + 1;
  return contact;
}

std::optional<Point> Vacuum::drive_on(const Point& heading) {
  while (!done())
    if (const auto contact = drive(at() + metres_left() * heading)) return contact;
  return std::nullopt;
}

Point Vacuum::any_heading() { return unit(2 * kPi * context_.rng().unit()); }

Point Vacuum::heading_off(const Point& away) {
  return unit(std::atan2(away.y(), away.x()) + kPi * (context_.rng().unit() - 0.5));
}

Path Vacuum::finish() {
  context_.record("swept_m2", swept_.area());
  context_.record("bumps", static_cast<double>(bumps_));
  if (bumper_.way().size() < 2)
    throw Infeasible(fmt::format("robot '{}' touches walls on all sides of its start ({:.6g}, {:.6g})",
                                 problem_.robot().name, problem_.start().x(), problem_.start().y()));
  return Path{{{true, bumper_.way()}}};
}

std::optional<Point> spiral(Vacuum& vacuum, double pitch, const Point& heading) {
  const Point centre = vacuum.at();
  const double a = pitch / (2 * kPi), begin = std::atan2(heading.y(), heading.x());
  const double error = 0.8 * vacuum.tool_width() / 1000;
  for (double turned = 0; !vacuum.done();) {
    // The chord over a small angle errs by angle^2 / 8 * curvature * (length for an angle)^2.
    const double bow = a * (2 + turned * turned) / std::sqrt(1 + turned * turned);
    turned += std::min(0.5, std::sqrt(8 * error / bow));
    if (const auto contact = vacuum.drive(centre + a * turned * unit(begin + turned))) return contact;
  }
  return std::nullopt;
}

void follow(Vacuum& vacuum, double gap, double longest, Point& away) {
  const double w = vacuum.tool_width(), step = kStep * w, keep = std::max(gap, w / 1000), begin = vacuum.driven();
  struct Mark {
    Point at, away;
    double driven;
  };
  const auto here = [&] { return Mark{vacuum.at(), away, vacuum.driven()}; };
  const auto back_at = [&](const Mark& m) {
    return vacuum.driven() - m.driven > 2 * w && distance(vacuum.at(), m.at) < keep + w / 8 && away.dot(m.away) > 0.5;
  };
  // A lap ends where it began. Yet the robot may come upon another wall whose lap does not lead back there; that one ends
  // at a later mark, each twice as far as the last.
  const Mark first = here();
  Mark later = first;
  // What lies to the left is across a passage: no wall to follow, it only narrows the passage.
  const auto at_right = [&] { return vacuum.feel(keep + 4 * step, -away, -0.1); };
  const auto touched = at_right();
  double off = touched ? touched->distance : 0;
  while (!vacuum.done() && vacuum.driven() - begin < longest) {
    const Point along(away.y(), -away.x()), from = vacuum.at();
    const auto across = vacuum.feel(2 * keep - off, away, 0.5);
    const double aim = across ? (off + across->distance) / 2 : keep;
    auto contact = vacuum.drive(from + step * along + (aim - off) * away);
    if (contact && contact->dot(away) < -0.5) {
      // Pressed to the wall at the right there is most room to pass. If that does not help, round and back.
      vacuum.drive(vacuum.at() - 2 * keep * away);
      vacuum.drive(vacuum.at() + step * along);
      if ((vacuum.at() - from).dot(along) > w / 10000) contact.reset();
    }
    if (contact) {
      away = *contact;
      off = 0;
    } else if (const auto wall = at_right()) {
      away = wall->away;
      off = wall->distance;
    } else {
      away = along;  // the wall is gone: round its corner
      off = keep;
    }
    if (back_at(first) || back_at(later)) return;
    if (vacuum.driven() - begin > 2 * (later.driven - begin) + 2 * w) later = here();
  }
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

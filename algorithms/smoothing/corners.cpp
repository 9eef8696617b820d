#include "algorithms/smoothing/corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kThreshold = 1.57;       // inner angle in radians below which Vollprecht drives round outside
constexpr double kLongestStraight = 1e4;  // radii, of his loop
constexpr double kNone = 1e-9;            // radians: no corner
constexpr double kArcError = 0.8;         // chord errors; leaving out a sample near another one takes the rest
constexpr double kRepeated = 1e-9;        // radii

Point unit(const Point& v) { return v / v.norm(); }
double angle_of(const Point& v) { return math::atan2(v.y(), v.x()); }

/// How one corner is driven.
struct Turn {
  std::size_t vertex = 0;
  Point before{1, 0}, after{1, 0};  // headings
  double deflection = 0;            // left positive
  double tangent = 0, deviation = 0;
  bool inside = false;
  std::vector<Leg> loop = {};  // outside
};

class Rounding {
 public:
  Rounding(const Polyline& line, const std::vector<std::size_t>& corners, const CornerOptions& options)
      : line_(line), options_(options) {
    if (options.sharpness >= 0 && options.rule != CornerRule::literal)
      shape_.emplace(options.radius, options.sharpness);
    for (const std::size_t vertex : corners) add(vertex);
    choose_inside();
    for (Turn& turn : turns_)
      if (!turn.inside) choose_loop(turn);
  }

  RoundedLine run() {
    std::size_t next = 0;
    work_ = {line_.front()};
    for (std::size_t i = 1; i < line_.size(); ++i) {
      if (next < turns_.size() && turns_[next].vertex == i) {
        drive(turns_[next++]);
      } else {
        push(line_[i]);
      }
    }
    if (work_.size() == 1) work_.push_back(line_.back());
    work_.back() = line_.back();  // push() may have dropped it
    finish_leg();
    return std::move(result_);
  }

 private:
  void add(std::size_t vertex) {
    const bool inner = vertex > 0 && vertex + 1 < line_.size();
    if (!inner || (!turns_.empty() && turns_.back().vertex >= vertex))
      throw std::invalid_argument(
          fmt::format("corner {} is not an inner vertex of a polyline of {}, or out of order", vertex, line_.size()));
    const Point in = line_[vertex] - line_[vertex - 1], out = line_[vertex + 1] - line_[vertex];
    if (in == Point(0, 0) || out == Point(0, 0))
      throw std::invalid_argument(fmt::format("corner {} repeats a point", to_text(line_[vertex])));
    Turn turn{vertex, unit(in), unit(out)};
    turn.deflection = math::atan2(cross(turn.before, turn.after), turn.before.dot(turn.after));
    if (std::abs(turn.deflection) < kNone) return;
    measure(turn);
    turns_.push_back(std::move(turn));
  }

  void measure(Turn& turn) const {
    const double half = std::abs(turn.deflection) / 2;
    if (half > kPi / 2 - kNone) {
      turn.tangent = turn.deviation = std::numeric_limits<double>::infinity();
    } else if (shape_) {
      turn.tangent = shape_->tangent_length(turn.deflection), turn.deviation = shape_->deviation(turn.deflection);
    } else {
      turn.tangent = options_.radius * math::tan(half), turn.deviation = options_.radius * (1 / math::cos(half) - 1);
    }
  }

  bool wants_inside(const Turn& turn) const {
    if (options_.rule == CornerRule::literal) return kPi - std::abs(turn.deflection) >= kThreshold;
    return options_.rule == CornerRule::inside ||
           (options_.rule == CornerRule::automatic && turn.deviation <= options_.largest_deviation);
  }
  bool wants_outside(const Turn& turn) const {
    if (options_.rule == CornerRule::literal) return !wants_inside(turn);
    return options_.rule == CornerRule::outside || options_.rule == CornerRule::automatic;
  }

  /// Those that need least of their edges first.
  void choose_inside() {
    std::vector<double> room;  // left on the edge that ends in vertex i
    for (std::size_t i = 0; i < line_.size(); ++i) room.push_back(i > 0 ? distance(line_[i - 1], line_[i]) : 0);
    std::vector<std::size_t> order(turns_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return turns_[i].tangent; });
    for (const std::size_t i : order) {
      Turn& turn = turns_[i];
      double &before = room[turn.vertex], &after = room[turn.vertex + 1];
      if (!wants_inside(turn) || turn.tangent > before || turn.tangent > after) continue;
      turn.inside = true;
      before -= turn.tangent, after -= turn.tangent;
    }
  }

  void choose_loop(Turn& turn) const {
    if (!wants_outside(turn)) return;
    const Pose at{line_[turn.vertex], angle_of(turn.before)};
    for (auto& [length, legs] : loops(at, turn)) {
      const bool free =
          !options_.free || std::ranges::all_of(legs, [&](const Leg& leg) { return options_.free(leg.points); });
      if (!free) continue;
      turn.loop = std::move(legs);
      return;
    }
  }
  using Loop = std::pair<double, std::vector<Leg>>;

  /// Shortest first.
  std::vector<Loop> loops(const Pose& at, const Turn& turn) const {
    const double radius = options_.radius;
    std::vector<Loop> found;
    const auto offer = [&](const SmoothCurve& curve) {
      found.emplace_back(length(curve), std::vector<Leg>{{false, sampled(curve, options_.chord_error)}});
    };
    if (options_.rule == CornerRule::literal) {
      const Curve loop = straight_loop(at, turn.deflection, radius);
      if (loop.pieces.front().length <= kLongestStraight * radius) offer(smooth_curve(loop));
      return found;
    }
    const Pose to{at.at, at.heading + turn.deflection};
    if (shape_) {
      for (const auto& word : continuous_dubins_words(at, to, *shape_)) offer({at, to, {word.begin(), word.end()}});
    } else {
      offer(smooth_curve(bulb(at, turn.deflection, radius)));
    }
    if (options_.reverse) {
      const Curve turn_on_the_spot = reeds_shepp_curve(at, to, radius);
      found.emplace_back(turn_on_the_spot.length(), sampled(turn_on_the_spot, kArcError * options_.chord_error, false));
    }
    std::ranges::stable_sort(found, {}, &Loop::first);
    return found;
  }

  void drive(const Turn& turn) {
    const Point& vertex = line_[turn.vertex];
    if (turn.inside) return round_inside(turn);
    push(vertex);
    if (turn.loop.empty()) {
      const bool may_stop = options_.may_stop || options_.rule == CornerRule::stop;
      (may_stop ? result_.stops : result_.failed).push_back(turn.vertex);
      if (!may_stop) return;
    }
    finish_leg();
    for (const Leg& leg : turn.loop) result_.legs.push_back(leg);
    work_ = {vertex};
  }

  void round_inside(const Turn& turn) {
    const Point& vertex = line_[turn.vertex];
    const Pose from{vertex - turn.tangent * turn.before, angle_of(turn.before)};
    const Pose to{vertex + turn.tangent * turn.after, angle_of(turn.before) + turn.deflection};
    SmoothCurve curve{from, to, {}};
    if (shape_) {
      const std::vector<Clothoid> pieces = shape_->corner(from, turn.deflection);
      curve.pieces.assign(pieces.begin(), pieces.end());
    } else {
      const double sense = turn.deflection > 0 ? 1 : -1;
      curve.pieces.push_back(Clothoid{from, sense / options_.radius, 0, options_.radius * std::abs(turn.deflection)});
    }
    for (const Point& p : sampled(curve, options_.chord_error)) push(p);
  }

  void push(const Point& p) {
    if (distance(work_.back(), p) > kRepeated * options_.radius) work_.push_back(p);
  }
  void finish_leg() {
    if (work_.size() > 1) result_.legs.push_back({true, std::move(work_)});
    work_.clear();
  }

  const Polyline& line_;
  const CornerOptions& options_;
  std::optional<TurnShape> shape_;
  std::vector<Turn> turns_;
  Polyline work_;  // the leg that grows
  RoundedLine result_;
};

}  // namespace

RoundedLine rounded_corners(const Polyline& line, const std::vector<std::size_t>& corners,
                            const CornerOptions& options) {
  if (line.size() < 2) throw std::invalid_argument("a polyline to be rounded has fewer than two points");
  if (!(options.radius > 0) || !std::isfinite(options.radius))
    throw std::invalid_argument("rounding corners needs a least turning radius above 0");
  return Rounding(line, corners, options).run();
}

std::vector<std::size_t> corners_of(const Polyline& line, double angle) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Point in = line[i] - line[i - 1], out = line[i + 1] - line[i];
    if (std::abs(math::atan2(cross(in, out), in.dot(out))) > angle) corners.push_back(i);
  }
  return corners;
}

Curve bulb(const Pose& at, double deflection, double radius) {
  const double delta = std::abs(deflection), gamma = math::asin(math::sin(delta / 2) / 2);
  const Steering with = deflection < 0 ? Steering::right : Steering::left;
  const Steering against = deflection < 0 ? Steering::left : Steering::right;
  const double side = radius * (delta / 2 - gamma);
  return {at,
          {at.at, at.heading + deflection},
          radius,
          {{with, side}, {against, radius * (2 * kPi - 2 * gamma)}, {with, side}}};
}

Curve straight_loop(const Pose& at, double deflection, double radius) {
  const double delta = std::abs(deflection), out = radius / math::tan((kPi - delta) / 2);
  const Steering against = deflection < 0 ? Steering::left : Steering::right;
  return {at,
          {at.at, at.heading + deflection},
          radius,
          {{Steering::straight, out}, {against, radius * (2 * kPi - delta)}, {Steering::straight, out}}};
}

}  // namespace oxturn

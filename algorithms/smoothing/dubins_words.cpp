// The six words of Dubins curves in closed form.
//
// Source      Shkel and Lumelsky, Classification of the Dubins set, Robotics and Autonomous Systems 34(4), 2001
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "algorithms/smoothing/curve.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kFullTurn = 2 * kPi;

/// In [0, 2 pi). An angle that rounding has left just below a full turn is none: else aligned poses get a circle more.
double turn(double angle) {
  const double a = angle - kFullTurn * std::floor(angle / kFullTurn);
  return a > kFullTurn - 1e-9 ? 0 : a;
}

/// In the frame where the straight line from the first to the second position is the x axis and the radius is 1.
class Words {
 public:
  Words(const Pose& from, const Pose& to, double radius) : radius_(radius) {
    const Point line = (to.at - from.at) / radius;
    d_ = line.norm();
    const double theta = d_ > 0 ? math::atan2(line.y(), line.x()) : 0;
    a_ = turn(from.heading - theta), b_ = turn(to.heading - theta);
    outer(1), outer(-1), inner(1), inner(-1), loop(1), loop(-1);
  }

  DubinsWords sorted() && {
    std::ranges::stable_sort(found_.words.begin(), found_.words.begin() + found_.count, {}, &Word::length);
    return found_;
  }
  const Word& shortest() const { return *std::ranges::min_element(found_.all(), {}, &Word::length); }

 private:
  /// Mirrored words are the same with both angles negated.
  static Steering side(int sense) { return sense > 0 ? Steering::left : Steering::right; }
  void add(const std::array<Steering, 3>& steering, const std::array<double, 3>& lengths) {
    Word& word = found_.words[found_.count++];
    word.count = steering.size();
    for (std::size_t i = 0; i < word.count; ++i) {
      const double part = radius_ * (steering[i] == Steering::straight ? lengths[i] : turn(lengths[i]));
      word.pieces[i] = {steering[i], part};
      word.length += part;
    }
  }
  /// LSL (sense 1) and RSR.
  void outer(int sense) {
    const double a = sense * a_, b = sense * b_;
    const Point line(d_ + math::sin(a) - math::sin(b), math::cos(b) - math::cos(a));
    const double heading = math::atan2(line.y(), line.x());
    add({side(sense), Steering::straight, side(sense)}, {heading - a, line.norm(), b - heading});
  }
  /// LSR (sense 1) and RSL.
  void inner(int sense) {
    const double a = sense * a_, b = sense * b_;
    const Point centres(d_ + math::sin(a) + math::sin(b), -math::cos(a) - math::cos(b));
    const double squared = centres.squaredNorm() - 4;
    if (squared < 0) return;
    const double length = std::sqrt(squared);
    const double heading = math::atan2(centres.y(), centres.x()) + math::atan2(2, length);
    add({side(sense), Steering::straight, side(-sense)}, {heading - a, length, heading - b});
  }
  /// LRL (sense 1) and RLR.
  void loop(int sense) {
    const double a = sense * a_, b = sense * b_;
    const Point centres(d_ + math::sin(a) - math::sin(b), math::cos(b) - math::cos(a));
    const double apart = centres.norm();
    if (apart > 4) return;
    // Around the first centre until the middle circle touches, on the far side of the line of centres.
    const double heading = math::atan2(centres.y(), centres.x()) + math::acos(apart / 4) + kPi / 2;
    const double middle = turn(kPi + 2 * math::acos(apart / 4));
    add({side(sense), side(-sense), side(sense)}, {heading - a, middle, b - heading + middle});
  }

  double radius_, d_ = 0, a_ = 0, b_ = 0;
  DubinsWords found_;
};

}  // namespace

DubinsWords dubins_words(const Pose& from, const Pose& to, double radius) { return Words(from, to, radius).sorted(); }

Curve dubins_curve(const Pose& from, const Pose& to, double radius) {
  return curve_of(Words(from, to, radius).shortest(), from, to, radius);
}

double dubins_distance(const Pose& from, const Pose& to, double radius) {
  return Words(from, to, radius).shortest().length;
}

}  // namespace oxturn

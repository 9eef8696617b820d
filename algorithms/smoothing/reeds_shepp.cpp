// The shortest Reeds-Shepp curves in closed form, without a state space: the words of section 8 of the source, each in
// its four mirror images and, where it is not symmetric, driven backwards. A word is worked out only if a bound on its
// length without angles (what its straight part and its change of heading take) is less than the best one so far.
//
// Source      Reeds and Shepp, Optimal paths for a car that goes both forwards and backwards, Pacific Journal of
//             Mathematics 145(2), 1990; formula 8.4 with the sign corrected
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "algorithms/smoothing/curve.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kFullTurn = 2 * kPi;
constexpr double kRounding = 1e-9;  // radians and radii; shorter parts are none, longer by less is no shorter curve
constexpr double kSurely = 1e-6;    // radians, far above rounding: what a turn has to be off for its sine to tell

/// In [-pi, pi].
double wrapped(double angle) { return angle - kFullTurn * std::floor(angle / kFullTurn + 0.5); }

/// The angle as a turn in the sense of `sign`, at most pi; false if it is none. Rounding counts for neither sense.
bool turns(int sign, double& angle) {
  double a = sign * wrapped(angle);
  if (a < kRounding - kPi) a += kFullTurn;
  if (a < -kRounding) return false;
  angle = sign * std::max(a, 0.0);
  return true;
}

/// Does the sine of a turn, given times some length, tell that turns() refuses it, whatever the rounding? Most words
/// have a turn in the wrong sense.
bool surely_right(double sine, double length) { return length > kSurely && sine < -kSurely * length; }

/// What a word is tried for: the first pose in the origin, heading along x; radius 1.
struct Target {
  double x, y, heading, sine, cosine;
  double distance;
};

/// A vector in the plane with its length.
struct Centres {
  Centres(double along_x, double along_y) : x(along_x), y(along_y), norm(std::sqrt(x * x + y * y)) {}
  double x, y, norm;
  double angle() const { return math::atan2(y, x); }
};

class ShortestWord {
 public:
  ShortestWord(const Pose& from, const Pose& to, double radius) {
    const double sine = math::sin(from.heading), cosine = math::cos(from.heading);
    const Point line = (to.at - from.at) / radius;
    const double heading = wrapped(to.heading - from.heading);
    const Target target{cosine * line.x() + sine * line.y(),
                        cosine * line.y() - sine * line.x(),
                        heading,
                        math::sin(heading),
                        math::cos(heading),
                        line.norm()};
    // Driven backwards, the curve leads from the last pose to the first one.
    const Target back{target.x * target.cosine + target.y * target.sine,
                      target.x * target.sine - target.y * target.cosine,
                      target.heading,
                      target.sine,
                      target.cosine,
                      target.distance};
    for_images(target, [this](const Target& t) { with_straight_middle(t); });
    for_images(target, [this](const Target& t) { of_arcs(t), of_four_arcs(t), between_cusps(t), with_cusp(t); });
    backwards_ = true;
    for_images(back, [this](const Target& t) { of_arcs(t), with_cusp(t); });
  }

  double length() const { return length_; }
  Word word(double radius) const {
    Word result;
    result.length = radius * length_;
    for (const auto& [steering, part] : parts_)
      if (std::abs(part) > kRounding)
        result.pieces[result.count++] = {steering, std::abs(part) * radius, part > 0 ? Gear::forward : Gear::reverse};
    return result;
  }

 private:
  static constexpr Steering kLeft = Steering::left, kRight = Steering::right, kStraight = Steering::straight;
  using Part = std::pair<Steering, double>;  // negative: in reverse

  /// f(image) for the target as it is, with the gears exchanged, with the sides exchanged, and with both.
  template <class F>
  void for_images(const Target& t, F f) {
    for (const bool sides : {false, true})
      for (const bool gears : {false, true}) {
        gears_ = gears, sides_ = sides;
        const double sign = gears == sides ? 1 : -1;
        f(Target{gears ? -t.x : t.x, sides ? -t.y : t.y, sign * t.heading, sign * t.sine, t.cosine, t.distance});
      }
  }

  bool may_win(double least) const { return least < length_ - kRounding; }

  void offer(std::initializer_list<Part> word) {
    double sum = 0;
    for (const Part& part : word) sum += std::abs(part.second);
    if (!may_win(sum)) return;
    length_ = sum;
    parts_.fill({kStraight, 0.0});
    std::ranges::copy(word, parts_.begin());
    if (backwards_) std::reverse(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(word.size()));
    for (auto& [steering, part] : parts_) {
      if (gears_) part = -part;
      if (sides_ && steering != kStraight) steering = steering == kLeft ? kRight : kLeft;
    }
  }

  /// From the first circle's centre to the last one's, if the last arc turns left, and if it turns right.
  static Centres to_left(const Target& t) { return {t.x - t.sine, t.y - 1 + t.cosine}; }
  static Centres to_right(const Target& t) { return {t.x + t.sine, t.y - 1 - t.cosine}; }

  /// Does a turn from the x axis to the vector, or from there to the last heading, surely lead to the right?
  static bool turns_right(const Target& t, const Centres& c, double size) {
    return surely_right(c.y, size) || surely_right(t.sine * c.x - t.cosine * c.y, size);
  }

  /// 8.1 L+S+L+ and 8.2 L+S+R+.
  void with_straight_middle(const Target& t) {
    const double left_turn = t.heading < -kRounding ? t.heading + kFullTurn : std::max(t.heading, 0.0);
    if (const Centres c = to_left(t); may_win(c.norm + left_turn) && !turns_right(t, c, c.norm)) {
      double first = c.norm > kRounding ? c.angle() : 0, last = t.heading - first;
      if (turns(1, first) && turns(1, last)) offer({{kLeft, first}, {kStraight, c.norm}, {kLeft, last}});
    }
    const Centres c = to_right(t);
    const double squared = c.norm * c.norm - 4;
    if (squared < 0) return;
    const double middle = std::sqrt(squared);
    if (!may_win(middle + std::abs(t.heading))) return;
    const double x = middle * c.x - 2 * c.y, y = middle * c.y + 2 * c.x,
                 size = c.norm * c.norm;  // of the straight part
    if (surely_right(y, size) || surely_right(y * t.cosine - x * t.sine, size)) return;
    double first = c.angle() + math::atan2(2, middle), last = first - t.heading;
    if (turns(1, first) && turns(1, last)) offer({{kLeft, first}, {kStraight, middle}, {kRight, last}});
  }

  /// 8.3 and 8.4 L+R-L.
  void of_arcs(const Target& t) {
    const Centres c = to_left(t);
    if (c.norm > 4 || !may_win(std::max({c.norm / 2, t.distance, std::abs(t.heading)}))) return;
    const double sine = c.norm / 4, cosine = std::sqrt(1 - sine * sine);  // of half the middle arc
    if (surely_right(sine * c.x - cosine * c.y, c.norm)) return;
    const double middle = -2 * math::asin(sine);
    double first = c.angle() + middle / 2 + kPi;
    if (!turns(1, first)) return;
    offer({{kLeft, first}, {kRight, middle}, {kLeft, wrapped(t.heading - first + middle)}});
  }

  /// 8.7 L+R+L-R- and 8.8 L+R-L-R+, the middle arcs equal.
  void of_four_arcs(const Target& t) {
    const Centres c = to_right(t);
    if (!may_win(std::max(t.distance, std::abs(t.heading)))) return;
    if (c.norm <= 2) {
      const double middle = math::acos((2 + c.norm) / 4);
      auto [first, last] = outer_arcs(middle, -middle, c, t.heading);
      if (turns(1, first) && turns(-1, last))
        offer({{kLeft, first}, {kRight, middle}, {kLeft, -middle}, {kRight, last}});
    }
    if (const double cosine = (20 - c.norm * c.norm) / 16; cosine >= 0 && cosine <= 1) {
      const double middle = -math::acos(cosine);
      auto [first, last] = outer_arcs(middle, middle, c, t.heading);
      if (turns(1, first) && turns(1, last)) offer({{kLeft, first}, {kRight, middle}, {kLeft, middle}, {kRight, last}});
    }
  }
  /// tau and omega of the source, for middle arcs u and v.
  static std::pair<double, double> outer_arcs(double u, double v, const Centres& c, double heading) {
    const double delta = u - v;
    const double a = math::sin(u) - math::sin(delta), b = math::cos(u) - math::cos(delta) - 1;
    const double angle = math::atan2(c.y * a - c.x * b, c.x * a + c.y * b);
    const bool opposite = 2 * (math::cos(delta) - math::cos(v) - math::cos(u)) + 3 < 0;
    const double first = wrapped(opposite ? angle + kPi : angle);
    return {first, first - u + v - heading};
  }

  /// 8.9 L+R-S-L- and 8.10 L+R-S-R-, the second arc a right angle.
  void with_cusp(const Target& t) {
    if (const Centres c = to_left(t); c.norm >= 2) {
      const double reach = std::sqrt(c.norm * c.norm - 4), middle = 2 - reach;
      double first = 0, last = 0;
      const double x = -2 * c.x - reach * c.y, y = reach * c.x - 2 * c.y, size = c.norm * c.norm;
      const bool fails = surely_right(y, size) || surely_right(t.cosine * x + t.sine * y, size);
      if (!fails && middle <= kRounding && may_win(kPi / 2 - middle)) {
        first = c.angle() + math::atan2(reach, -2), last = t.heading - kPi / 2 - first;
        if (turns(1, first) && turns(-1, last))
          offer({{kLeft, first}, {kRight, -kPi / 2}, {kStraight, std::min(middle, 0.0)}, {kLeft, last}});
      }
    }
    const Centres c = to_right(t);
    if (c.norm < 2 || !may_win(kPi / 2 + c.norm - 2)) return;
    if (surely_right(c.x, c.norm) || surely_right(t.cosine * c.y - t.sine * c.x, c.norm)) return;
    double first = math::atan2(c.x, -c.y), last = first + kPi / 2 - t.heading;
    if (turns(1, first) && turns(-1, last))
      offer({{kLeft, first}, {kRight, -kPi / 2}, {kStraight, 2 - c.norm}, {kRight, last}});
  }

  /// 8.11 L+R-S-L-R+, both inner arcs right angles.
  void between_cusps(const Target& t) {
    const Centres c = to_right(t);
    if (c.norm < 2) return;
    const double middle = 4 - std::sqrt(c.norm * c.norm - 4);
    if (middle > kRounding || !may_win(kPi - middle + std::abs(t.heading))) return;
    const double x = -2 * c.x + (middle - 4) * c.y, y = (4 - middle) * c.x - 2 * c.y, size = c.norm * c.norm;
    if (surely_right(y, size) || surely_right(y * t.cosine - x * t.sine, size)) return;
    double first = math::atan2(y, x);
    double last = first - t.heading;
    if (turns(1, first) && turns(1, last))
      offer(
          {{kLeft, first}, {kRight, -kPi / 2}, {kStraight, std::min(middle, 0.0)}, {kLeft, -kPi / 2}, {kRight, last}});
  }

  double length_ = std::numeric_limits<double>::infinity();
  std::array<Part, 5> parts_{};
  bool gears_ = false, sides_ = false, backwards_ = false;  // of the image at hand
};

}  // namespace

Word reeds_shepp_word(const Pose& from, const Pose& to, double radius) {
  return ShortestWord(from, to, radius).word(radius);
}

Curve reeds_shepp_curve(const Pose& from, const Pose& to, double radius) {
  return curve_of(reeds_shepp_word(from, to, radius), from, to, radius);
}

double reeds_shepp_distance(const Pose& from, const Pose& to, double radius) {
  return radius * ShortestWord(from, to, radius).length();
}

}  // namespace oxturn

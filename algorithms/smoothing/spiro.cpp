// libspiro gets five to seven points: an end, a point of type ']' a little ahead on its heading, the control points of
// type 'c', and the same mirrored at the other end, with '['. (With '[' first, as Vollprecht has it in his text,
// tangents are lost.) It answers with cubic Bézier curves. It works in a frame where the first end is the origin, the
// second one is on the x axis, and rho is the unit.
#include "algorithms/smoothing/spiro.hpp"

#include <spiroentrypoints.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kHelper = 0.01;     // rho, from an end to the point that fixes its heading
constexpr double kGentle = kPi / 4;  // headings off the chord, and between each other, without control points
constexpr double kStep = kPi / 180;  // by which control points are turned apart
constexpr int kMostSteps = 180;
constexpr double kMostKink = 1e-3;  // radians, between pieces: more is no solution
constexpr double kGrain = 0x1p-30;  // rho: what libspiro answers is rounded to multiples of it

Point turned(const Point& v, double angle) {
  const double c = math::cos(angle), s = math::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

double angle_between(double a, double b) { return std::remainder(a - b, 2 * kPi); }

/// The two control points of connections that are not gentle. Headings are relative to the chord.
class ControlPoints {
 public:
  ControlPoints(const Pose& from, const Pose& to, double rho, double first, double last)
      : from_(from),
        to_(to),
        rho_(rho),
        first_(first),
        last_(last),
        c1_(ahead(from, rho).at),
        c2_(ahead(to, -rho).at) {}

  std::vector<Point> get(SpiroRule rule) {
    // Vollprecht's program leaves near ends alone.
    const bool may_turn = rule == SpiroRule::improved || distance(from_.at, to_.at) > rho_;
    if (may_turn && swings_out()) {
      c1_ = from_.at + turned(c1_ - from_.at, -first_ / 2);
      c2_ = to_.at + turned(c2_ - to_.at, -last_ / 2);
    }
    if (distance(c1_, c2_) < rho_) rule == SpiroRule::literal ? push_apart() : turn_apart();
    return {c1_, c2_};
  }

 private:
  /// Both headings lead away from the other end, to the same side of the chord: between them the curve would be an arc
  /// of any size.
  bool swings_out() const {
    return std::abs(first_) > kPi / 2 && std::abs(last_) > kPi / 2 && math::sin(first_) * -math::sin(last_) > 0;
  }
  void turn_apart() {
    // In the sense that brings them apart sooner.
    for (int k = 1; k <= kMostSteps; ++k)
      for (const double sense : {1.0, -1.0}) {
        const Point a = from_.at + turned(c1_ - from_.at, sense * k * kStep);
        const Point b = to_.at + turned(c2_ - to_.at, -sense * k * kStep);
        if (distance(a, b) < rho_) continue;
        c1_ = a, c2_ = b;
        return;
      }
  }
  /// Along their line; if they coincide, across the chord.
  void push_apart() {
    const Point between = c2_ - c1_, middle = (c1_ + c2_) / 2, chord = to_.at - from_.at;
    const double apart = between.norm(), d = chord.norm();
    const Point along = apart > 1e-9 * rho_ ? Point(between / apart)
                        : d > 0             ? perpendicular(chord / d)
                                            : perpendicular(direction(from_));
    c1_ = middle - rho_ / 2 * along, c2_ = middle + rho_ / 2 * along;
  }

  const Pose &from_, &to_;
  double rho_, first_, last_;
  Point c1_, c2_;
};

/// What libspiro calls back: collects the curves.
struct Collector {
  bezctx base;  // first, so that libspiro's pointer is ours
  Point at{0, 0};
  std::vector<Bezier> curves;

  Collector() : base{move_to, line_to, quad_to, curve_to, mark_knot} {}
  void add(std::vector<Point> points) {
    at = points.back();
    curves.push_back({std::move(points)});
  }
  static Collector& self(bezctx* context) { return *reinterpret_cast<Collector*>(context); }
  static void move_to(bezctx* context, double x, double y, int) { self(context).at = {x, y}; }
  static void line_to(bezctx* context, double x, double y) { self(context).add({self(context).at, {x, y}}); }
  static void quad_to(bezctx* context, double x1, double y1, double x2, double y2) {
    self(context).add({self(context).at, {x1, y1}, {x2, y2}});
  }
  static void curve_to(bezctx* context, double x1, double y1, double x2, double y2, double x3, double y3) {
    self(context).add({self(context).at, {x1, y1}, {x2, y2}, {x3, y3}});
  }
  static void mark_knot(bezctx*, int) {}
};

/// From metres to the frame in which libspiro works, and back.
struct Frame {
  Point origin{0, 0};
  double unit = 1, heading = 0;
  Point to_frame(const Point& p) const { return turned(p - origin, -heading) / unit; }
  Point to_metres(const Point& p) const { return origin + turned(p * unit, heading); }
};

/// libspiro uses the C library's functions, whose last bits are not the same on every machine (base/math.hpp).
Point rounded(const Point& p) { return {std::round(p.x() / kGrain) * kGrain, std::round(p.y() / kGrain) * kGrain}; }

std::vector<Bezier> run_libspiro(std::vector<spiro_cp> points) {
  Collector collector;
  const int done = TaggedSpiroCPsToBezier2(points.data(), 0, &collector.base);
  if (done != 1) return {};
  return std::move(collector.curves);
}

/// Where two pieces meet, their headings differ by some 1e-6 radians: the handles on both sides are put on one line. At
/// the ends of the curve this is the pose's heading.
void align_joints(std::vector<Bezier>& pieces, const Point& first, const Point& last) {
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    std::vector<Point>&before = pieces[i - 1].points, &after = pieces[i].points;
    Point &a = before[before.size() - 2], &b = after[1];
    const Point joint = after.front();
    const double back = distance(a, joint), on = distance(joint, b);
    const Point heading = before.size() == 2 ? first : after.size() == 2 ? last : Point((b - a).normalized());
    if (before.size() > 2) a = joint - back * heading;
    if (after.size() > 2) b = joint + on * heading;
  }
}

}  // namespace

std::vector<Point> spiro_control_points(const Pose& from, const Pose& to, double rho, SpiroRule rule) {
  const Point chord = to.at - from.at;
  const double angle = chord.norm() > 0 ? math::atan2(chord.y(), chord.x()) : from.heading;
  const double first = angle_between(from.heading, angle), last = angle_between(to.heading, angle);
  if (chord.norm() > 2 * kHelper * rho && std::abs(first) < kGentle && std::abs(last) < kGentle &&
      std::abs(first - last) < kGentle)
    return {};
  return ControlPoints(from, to, rho, first, last).get(rule);
}

std::optional<SmoothCurve> spiro_curve(const Pose& from, const Pose& to, const std::vector<Point>& through,
                                       double rho) {
  const Point chord = to.at - from.at;
  const Frame frame{from.at, rho, chord.norm() > 0 ? math::atan2(chord.y(), chord.x()) : 0};
  std::vector<spiro_cp> points;
  const auto add = [&](const Point& p, char type) {
    const Point q = frame.to_frame(p);
    points.push_back({q.x(), q.y(), type});
  };
  add(from.at, SPIRO_OPEN_CONTOUR);
  add(ahead(from, kHelper * rho).at, SPIRO_RIGHT);
  for (const Point& p : through) add(p, SPIRO_G2);
  add(ahead(to, -kHelper * rho).at, SPIRO_LEFT);
  add(to.at, SPIRO_END_OPEN_CONTOUR);
  std::vector<Bezier> pieces = run_libspiro(std::move(points));
  if (pieces.size() < 3) return std::nullopt;
  for (Bezier& piece : pieces)
    for (Point& p : piece.points) p = frame.to_metres(rounded(p));
  pieces.front().points.front() = from.at;  // but for rounding they are
  pieces.back().points.back() = to.at;
  SmoothCurve curve{from, to, {pieces.begin(), pieces.end()}};
  if (!finite(curve) || joint_errors(curve).heading > kMostKink) return std::nullopt;
  align_joints(pieces, direction(from), direction(to));
  curve.pieces.assign(pieces.begin(), pieces.end());
  return curve;
}

}  // namespace oxturn

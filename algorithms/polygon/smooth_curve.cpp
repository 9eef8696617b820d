#include "algorithms/polygon/smooth_curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kBack = 0.04;             // radians off a turn on the spot, which is no arc
constexpr double kFineTurn = 0.15;         // radians from chord to chord; vertices that turn by less are smooth enough
constexpr double kMostTurn = 0.3;          // the same where arcs are small
constexpr double kStraight = 1e-9;         // of the distance between its neighbours, by which a vertex may be off
constexpr std::size_t kUsualVertices = 3;  // of a rounded curve for each of its corners

/// The directions from a point that pass within a distance of each point added.
class Wedge {
 public:
  Wedge(const Point& apex, double tolerance) : apex_(apex), tolerance_(tolerance) {}
  bool holds(const Point& p) const {
    const Point d = p - apex_;
    return !narrowed_ || (d.norm() >= farthest_ - tolerance_ && cross(right_, d) >= 0 && cross(d, left_) >= 0 &&
                          d.dot(right_ + left_) > 0);
  }
  void add(const Point& p) {
    const Point d = p - apex_;
    const double far = d.norm();
    farthest_ = std::max(farthest_, far);
    if (far <= tolerance_) return;
    const double sine = tolerance_ / far;
    const Point along = std::sqrt(1 - sine * sine) * d, across = sine * perpendicular(d);
    const Point right = along - across, left = along + across;
    if (!narrowed_ || cross(right_, right) > 0) right_ = right;
    if (!narrowed_ || cross(left, left_) > 0) left_ = left;
    narrowed_ = true;
  }

 private:
  Point apex_;
  double tolerance_, farthest_ = 0;
  bool narrowed_ = false;
  Point right_{0, 0}, left_{0, 0};
};

/// The chords that replace a corner: equally long, with equal turns at all vertices, the first and the last among them,
/// so that there are as few as possible. Lengths are those of chords that begin and end 1 m from the corner.
struct Bend {
  double turn;    // at each vertex, radians
  int chords;     // at least 1
  double radius;  // of the circle through all vertices
  double chord;   // length of one
  double off;     // from the corner

  Bend(double whole, int vertices) : turn(whole / vertices), chords(vertices - 1) {
    const double spanned = chords * turn / 2;
    radius = math::cos(whole / 2) / math::sin(spanned);
    chord = 2 * radius * math::sin(turn / 2);
    const double middle = chords % 2 == 0 ? 1 : math::cos(turn / 2);  // of the circle's radius
    off = math::sin(whole / 2) - radius * (middle - math::cos(spanned));
  }
};

/// Vertices that turn by `whole` together, so that chords are within `error` of a small arc of the given radius.
int vertices_of(double whole, double radius, double error) {
  const double turn = std::clamp(2 * std::sqrt(2 * error / radius), kFineTurn, kMostTurn);
  return std::max(2, static_cast<int>(std::ceil(whole / turn)));
}

void add_corner(Polyline& line, const Point& a, const Point& b, const Point& c, const Rounding& rounding,
                const Connector& connector) {
  const Point u = (b - a).normalized(), v = (c - b).normalized();
  const double turn = math::atan2(cross(u, v), u.dot(v)), whole = std::abs(turn);
  if (whole < kFineTurn || whole > kPi - kBack) return line.push_back(b);
  const double room = std::min(distance(a, b), distance(b, c)) / 2;
  const double tan_half = std::abs(cross(u, v)) / (1 + u.dot(v)), secant = std::sqrt(1 + tan_half * tan_half);
  // From the corner to the first and the last vertex: at most that of an arc, since chords are farther off.
  const double most = std::min(room, rounding.off / (secant - 1) * tan_half);
  const Bend about(whole, vertices_of(whole, most / tan_half, rounding.chord));
  const Bend bend(whole, vertices_of(whole, most * about.radius, rounding.chord));
  const double tangent = std::min(room, rounding.off / bend.off);
  const std::size_t first = line.size();
  line.push_back(b - tangent * u);
  const Point step = rotated({1, 0}, std::copysign(bend.turn, turn));
  Point chord = tangent * bend.chord * u;
  for (int k = 0; k < bend.chords; ++k) {
    chord = step.x() * chord + step.y() * perpendicular(chord);
    const Point next = line.back() + chord;
    if (!connector.straight(line.back(), next)) {
      line.resize(first);
      return line.push_back(b);
    }
    line.push_back(next);
  }
}

}  // namespace

Polyline with_fewer_vertices(Polyline curve, double tolerance, const Connector& connector) {
  if (curve.size() < 3) return curve;
  std::size_t kept = 1;  // in place of the first ones
  for (std::size_t i = 0; i + 1 < curve.size();) {
    Wedge wedge(curve[i], tolerance);
    std::size_t next = i + 1;
    wedge.add(curve[next]);
    while (next + 1 < curve.size() && wedge.holds(curve[next + 1])) wedge.add(curve[++next]);
    if (next > i + 1 && !connector.straight(curve[i], curve[next])) next = i + 1;
    if (curve[kept - 1] != curve[next]) curve[kept++] = curve[next];
    i = next;
  }
  curve.resize(kept);
  return curve;
}

Polyline without_collinear_vertices(const Polyline& curve) {
  Polyline line;
  for (const Point& p : curve) {
    while (line.size() > 1) {
      const Point &a = line[line.size() - 2], &b = line.back();
      if (distance_to_segment(b, a, p) > kStraight * distance(a, p)) break;
      line.pop_back();
    }
    if (line.empty() || line.back() != p) line.push_back(p);
  }
  return line;
}

Polyline rounded_corners(const Polyline& curve, const Rounding& rounding, const Connector& connector) {
  if (curve.size() < 3) return curve;
  Polyline line;
  line.reserve(kUsualVertices * curve.size());
  line.push_back(curve.front());
  for (std::size_t i = 1; i + 1 < curve.size(); ++i)
    add_corner(line, curve[i - 1], curve[i], curve[i + 1], rounding, connector);
  line.push_back(curve.back());
  return line;
}

}  // namespace oxturn

#include "algorithms/smoothing/clothoid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "algorithms/smoothing/quadrature.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kFullTurn = 2 * kPi;
constexpr double kDefaultSharpness = 2;  // over radius^2: the outer radius is 1.04 radii

/// In [0, 2 pi). An angle that rounding has left just below a full turn is none.
double turn_angle(double angle) {
  const double a = angle - kFullTurn * std::floor(angle / kFullTurn);
  return a > kFullTurn - 1e-9 ? 0 : a;
}

double angle_of(const Point& v) { return math::atan2(v.y(), v.x()); }

Pose end_of(const std::vector<Clothoid>& pieces, const Pose& from) {
  return pieces.empty() ? from : end_of(pieces.back());
}

void append(std::vector<Clothoid>& pieces, const Pose& from, double curvature, double sharpness, double length) {
  if (length > 0) pieces.push_back({end_of(pieces, from), curvature, sharpness, length});
}

void append(std::vector<Clothoid>& pieces, const std::vector<Clothoid>& more) {
  pieces.insert(pieces.end(), more.begin(), more.end());
}

/// Two clothoids that mirror each other.
std::vector<Clothoid> two_clothoids(const Pose& from, double sharpness, double length) {
  std::vector<Clothoid> pieces;
  append(pieces, from, 0, sharpness, length);
  append(pieces, from, sharpness * length, -sharpness, length);
  return pieces;
}

/// All words between two poses. A turn is known by its circle: that of a turn to the left (sense 1) or right (-1) which
/// begins, or ends, in a pose.
class Words {
 public:
  Words(const Pose& from, const Pose& to, const TurnShape& shape)
      : from_(from), to_(to), shape_(shape), xo_(shape.centre().x()), yo_(shape.centre().y()) {}

  std::vector<std::vector<Clothoid>> all() {
    for (const int sense : {1, -1}) outer(sense), inner(sense), loops(sense);
    std::ranges::stable_sort(found_, {}, [](const std::vector<Clothoid>& pieces) { return oxturn::length(pieces); });
    return std::move(found_);
  }

 private:
  Point first_centre(int sense) const { return centre(from_, xo_, sense); }
  Point last_centre(int sense) const { return centre(to_, -xo_, sense); }
  Point centre(const Pose& pose, double forward, int sense) const {
    const Point u = direction(pose);
    return pose.at + forward * u + sense * yo_ * perpendicular(u);
  }

  /// Turns of alternating or equal sense to the given headings, with a line after the first.
  void add(const std::array<int, 3>& senses, const std::array<double, 3>& headings, double line) {
    std::vector<Clothoid> pieces;
    Pose at = from_;
    for (std::size_t i = 0; i < 3; ++i) {
      if (senses[i] != 0) {
        append(pieces, shape_.turn(at, senses[i] * turn_angle(senses[i] * (headings[i] - at.heading))));
      } else if (line > 0) {
        pieces.push_back({at, 0, 0, line});
      }
      at = end_of(pieces, from_);
    }
    found_.push_back(std::move(pieces));
  }

  void outer(int sense) {
    const Point between = last_centre(sense) - first_centre(sense);
    const double line = between.norm() - 2 * xo_;
    if (line >= 0) add({sense, 0, sense}, {angle_of(between), 0, to_.heading}, line);
  }
  void inner(int sense) {
    const Point between = last_centre(-sense) - first_centre(sense);
    const double squared = between.squaredNorm() - 4 * yo_ * yo_;
    const double line = squared > 0 ? std::sqrt(squared) - 2 * xo_ : -1;
    if (line < 0) return;
    const double heading = angle_of(between) + sense * math::atan2(2 * yo_, line + 2 * xo_);
    add({sense, 0, -sense}, {heading, 0, to_.heading}, line);
  }
  /// Neighbouring turns touch in the middle between their centres.
  void loops(int sense) {
    const Point first = first_centre(sense), last = last_centre(sense), between = last - first;
    const double apart = between.norm() / (4 * shape_.outer_radius());
    if (apart > 1) return;
    const double tilt = sense * math::atan2(yo_, xo_);
    for (const int side : {1, -1}) {
      const double angle = angle_of(between) + side * math::acos(apart);
      const Point middle = first + 2 * shape_.outer_radius() * Point(math::cos(angle), math::sin(angle));
      add({sense, -sense, sense}, {angle + tilt, angle_of(last - middle) - tilt, to_.heading}, 0);
    }
  }

  Pose from_, to_;
  const TurnShape& shape_;
  double xo_, yo_;
  std::vector<std::vector<Clothoid>> found_;
};

}  // namespace

Pose pose_at(const Clothoid& piece, double s) {
  const double turned = s * (piece.curvature + piece.sharpness * s / 2);
  if (piece.sharpness == 0) {
    const double half = turned / 2, chord = std::abs(half) > 1e-8 ? s * math::sin(half) / half : s;
    return {ahead({piece.from.at, piece.from.heading + half}, chord).at, piece.from.heading + turned};
  }
  const double most = std::max(std::abs(piece.curvature), std::abs(piece.curvature + piece.sharpness * s));
  const double panels = std::max(1.0, std::ceil(most * std::abs(s)));  // a radian each at most
  Point sum(0, 0);
  for (double i = 0; i < panels; ++i)
    sum += integral(
        [&](double at) {
          const double heading = piece.from.heading + at * (piece.curvature + piece.sharpness * at / 2);
          return Point(math::cos(heading), math::sin(heading));
        },
        s * i / panels, s * (i + 1) / panels);
  return {piece.from.at + sum, piece.from.heading + turned};
}

TurnShape::TurnShape(double radius, double sharpness)
    : radius_(radius), sharpness_(sharpness == 0 ? kDefaultSharpness / (radius * radius) : sharpness) {
  const double least = 1 / (kPi * radius * radius);
  if (!(radius > 0) || !std::isfinite(radius))
    throw std::invalid_argument(fmt::format("turns of continuous curvature: radius is {}, expected above 0", radius));
  if (!(sharpness_ >= least * (1 - 1e-12)) || !std::isfinite(sharpness_))
    throw std::invalid_argument(fmt::format(
        "turns of continuous curvature: sharpness is {:.6g}, expected at least 1 / (pi radius^2) = {:.6g} 1/m^2",
        sharpness_, least));
  end_heading_ = 1 / (2 * sharpness_ * radius * radius);
  const Point end = end_of({{}, 0, sharpness_, 1 / (sharpness_ * radius)}).at;
  centre_ = {end.x() - radius * math::sin(end_heading_), end.y() + radius * math::cos(end_heading_)};
}

std::vector<Clothoid> TurnShape::turn(const Pose& from, double deflection) const {
  const double delta = std::abs(deflection);
  if (delta >= 2 * end_heading_) return corner(from, deflection);
  if (delta == 0) return {{from, 0, 0, 2 * centre_.x()}};
  // Two clothoids whose chord is that of the circle: at first of unit length, then scaled.
  const Point unit = end_of({{}, 0, delta, 1}).at;
  const double along = unit.x() * math::cos(delta / 2) + unit.y() * math::sin(delta / 2);
  const double half_chord = outer_radius() * math::sin(delta / 2 + math::atan2(centre_.x(), centre_.y()));
  const double length = half_chord / along;
  return two_clothoids(from, deflection / (length * length), length);
}

std::vector<Clothoid> TurnShape::corner(const Pose& from, double deflection) const {
  const double delta = std::abs(deflection), sense = deflection < 0 ? -1 : 1;
  if (delta < 2 * end_heading_) return two_clothoids(from, sense * sharpness_, std::sqrt(delta / sharpness_));
  const double ramp = 1 / (sharpness_ * radius_);
  std::vector<Clothoid> pieces;
  append(pieces, from, 0, sense * sharpness_, ramp);
  append(pieces, from, sense / radius_, 0, (delta - 2 * end_heading_) * radius_);
  append(pieces, from, sense / radius_, -sense * sharpness_, ramp);
  return pieces;
}

double TurnShape::tangent_length(double deflection) const {
  const double delta = std::abs(deflection), slope = math::tan(delta / 2);
  if (delta >= 2 * end_heading_) return centre_.x() + centre_.y() * slope;
  const Point middle = end_of({{}, 0, sharpness_, std::sqrt(delta / sharpness_)}).at;
  return middle.x() + middle.y() * slope;
}

double TurnShape::deviation(double deflection) const {
  const double delta = std::abs(deflection);
  if (delta >= 2 * end_heading_) return centre_.y() / math::cos(delta / 2) - radius_;
  return end_of({{}, 0, sharpness_, std::sqrt(delta / sharpness_)}).at.y() / math::cos(delta / 2);
}

std::vector<std::vector<Clothoid>> continuous_dubins_words(const Pose& from, const Pose& to, const TurnShape& shape) {
  return Words(from, to, shape).all();
}

double length(const std::vector<Clothoid>& pieces) {
  double sum = 0;
  for (const Clothoid& piece : pieces) sum += piece.length;
  return sum;
}

}  // namespace oxturn

/// Clothoids, turns of continuous curvature, and the Dubins-like curves made of them.
///
///   const TurnShape shape(0.5, 8.0);                     // radius, sharpness
///   std::vector<Clothoid> turn = shape.turn(pose, kPi / 2);
///   std::vector<std::vector<Clothoid>> words = continuous_dubins_words(from, to, shape);   // shortest first
///
///     curvature   .-----.        A turn: clothoid up to 1 / radius, arc, clothoid down to zero.
///               .'       '.      Small turns: two clothoids of less sharpness that start and end
///     ---------'           '---  on the same circle.
///
/// Source      Fraichard and Scheuer, From Reeds and Shepp's to continuous-curvature paths, IEEE Transactions on
///             Robotics 20(6), 2004. Positions by 12-point Gauss-Legendre quadrature.
/// Guarantee   curvature <= 1 / radius, its derivative by arc length <= sharpness; a curve for any two poses; ends
///             within 1e-9 radii. Not always the shortest such curve.
/// Complexity  a turn a microsecond, the words some 20
#pragma once

#include <optional>
#include <vector>

#include "algorithms/smoothing/curve.hpp"

namespace oxturn {

/// Curvature k(s) = curvature + sharpness s for s in [0, length]. A line: both zero. An arc: sharpness zero.
struct Clothoid {
  Pose from;
  double curvature = 0, sharpness = 0, length = 0;
};

/// After `s` metres.
Pose pose_at(const Clothoid& piece, double s);
inline Pose end_of(const Clothoid& piece) { return pose_at(piece, piece.length); }

/// What all turns of one robot have in common: their begin and end lie on a circle of radius `outer_radius`.
class TurnShape {
 public:
  /// `sharpness` in 1/m^2; 0: the default 2 / radius^2. Throws std::invalid_argument if radius <= 0 or sharpness <
  /// 1 / (pi radius^2), for which small turns would be too sharp.
  explicit TurnShape(double radius, double sharpness = 0);
  double radius() const { return radius_; }
  double sharpness() const { return sharpness_; }
  /// The circle's centre in the frame of a pose that begins a left turn.
  const Point& centre() const { return centre_; }
  double outer_radius() const { return centre_.norm(); }
  /// The turn by `deflection` radians, to the left if positive; |deflection| < 2 pi. It begins and ends on the circle;
  /// by 0 it is a straight line of 2 centre().x().
  std::vector<Clothoid> turn(const Pose& from, double deflection) const;
  /// The turn that rounds a corner, of the greatest sharpness: shorter than turn() for small deflections.
  std::vector<Clothoid> corner(const Pose& from, double deflection) const;
  /// From where it begins to the vertex, and as far from there to its end; |deflection| < pi.
  double tangent_length(double deflection) const;
  /// From the vertex to its middle.
  double deviation(double deflection) const;

 private:
  double radius_, sharpness_;
  double end_heading_;  // of the clothoid up to 1 / radius
  Point centre_{0, 0};
};

/// Curves of two turns with a line between them, or three turns, shortest first; at least one.
std::vector<std::vector<Clothoid>> continuous_dubins_words(const Pose& from, const Pose& to, const TurnShape& shape);
double length(const std::vector<Clothoid>& pieces);

}  // namespace oxturn

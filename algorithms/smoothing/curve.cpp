#include "algorithms/smoothing/curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kNearest = 2e-3;  // radii; samples nearer to each other than that are left out

int sense(const CurvePiece& piece) {
  const int left = piece.steering == Steering::left ? 1 : piece.steering == Steering::right ? -1 : 0;
  return piece.gear == Gear::forward ? left : -left;
}

/// Appends `next` to a leg unless it repeats the point before.
void append(Polyline& points, const Point& next, double nearest) {
  if (distance(points.back(), next) > nearest) points.push_back(next);
}

/// Ends the leg exactly in `end`.
void finish(Polyline& points, const Point& end, double nearest) {
  while (points.size() > 1 && distance(points.back(), end) <= nearest) points.pop_back();
  points.push_back(end);
}

}  // namespace

double Curve::length() const {
  double sum = 0;
  for (const CurvePiece& piece : pieces) sum += piece.length;
  return sum;
}

std::size_t Curve::cusps() const {
  std::size_t count = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) count += pieces[i].gear != pieces[i - 1].gear;
  return count;
}

Pose after(const Pose& from, const CurvePiece& piece, double radius) {
  const double driven = piece.gear == Gear::forward ? piece.length : -piece.length;
  if (piece.steering == Steering::straight) return ahead(from, driven);
  // The chord of an arc: exact also where the arc is short.
  const double turn = sense(piece) * piece.length / radius, half = turn / 2;
  const double chord = 2 * radius * math::sin(std::abs(half)) * (driven < 0 ? -1 : 1);
  return {ahead({from.at, from.heading + half}, chord).at, from.heading + turn};
}

Curve opposite(const Curve& curve) {
  Curve back{turned_round(curve.to), turned_round(curve.from), curve.radius, {}};
  for (auto piece = curve.pieces.rbegin(); piece != curve.pieces.rend(); ++piece) {
    const Steering mirrored = piece->steering == Steering::left    ? Steering::right
                              : piece->steering == Steering::right ? Steering::left
                                                                   : Steering::straight;
    back.pieces.push_back({mirrored, piece->length, piece->gear});
  }
  return back;
}

std::vector<Leg> sampled(const Curve& curve, double chord_error, bool tool) {
  const double nearest = kNearest * curve.radius;
  const double step = 2 * curve.radius * math::acos(std::max(0.0, 1 - chord_error / curve.radius));
  std::vector<Leg> legs;
  Pose at = curve.from;
  for (const CurvePiece& piece : curve.pieces) {
    if (!(piece.length > 0)) continue;
    if (legs.empty() || legs.back().gear != piece.gear) {
      if (!legs.empty()) finish(legs.back().points, at.at, nearest);
      legs.push_back({tool, {at.at}, piece.gear});
    }
    const bool straight = piece.steering == Steering::straight;
    const double parts = straight ? 1 : std::ceil(piece.length / step);
    for (double k = 1; k <= parts; ++k)
      append(legs.back().points, after(at, {piece.steering, piece.length * k / parts, piece.gear}, curve.radius).at,
             nearest);
    at = after(at, piece, curve.radius);
  }
  if (!legs.empty()) finish(legs.back().points, curve.to.at, nearest);
  return legs;
}

}  // namespace oxturn

/// Curves of a vector drawing before they are flattened: lines, Bézier curves, elliptical arcs. Private to maps.
///
///   Subpath circle{.closed = true};
///   circle.segments.push_back(arc({0, 0}, {1, 0}, {0, 1}, 0, kPi));
///   const Flattened line = flattened(transformed(circle, to_canvas), 1e-4);
///
/// Affine images of such curves are such curves, so transforms are exact and flattening comes last.
#pragma once

#include <array>
#include <optional>

#include "geometry/point.hpp"

namespace oxturn::svg {

/// x' = a x + c y + e, y' = b x + d y + f, as in SVG's matrix().
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Point operator()(const Point& p) const { return {a * p.x() + c * p.y() + e, b * p.x() + d * p.y() + f}; }
  Point direction(const Point& v) const { return {a * v.x() + c * v.y(), b * v.x() + d * v.y()}; }
  /// First `inner`, then this.
  Affine operator*(const Affine& inner) const;
  /// By which it enlarges lengths on average: the root of the determinant's size.
  double scale() const { return std::sqrt(std::abs(a * d - b * c)); }
};

struct CurveSegment {
  enum class Kind { line, quadratic, cubic, arc } kind = Kind::line;
  /// Of a line and of Bézier curves: the control points. Of an arc: centre, and two conjugate half-axes u and v; its
  /// points are centre + u cos t + v sin t.
  std::array<Point, 4> p{};
  double from = 0, sweep = 0;  // of an arc: t runs from `from` to `from + sweep`

  Point at(double s) const;  // 0 <= s <= 1
  Point start() const { return at(0); }
  Point end() const { return at(1); }
};
CurveSegment line(const Point& a, const Point& b);
CurveSegment quadratic(const Point& a, const Point& control, const Point& b);
CurveSegment cubic(const Point& a, const Point& control1, const Point& control2, const Point& b);
CurveSegment arc(const Point& centre, const Point& u, const Point& v, double from, double sweep);
/// From a to b on an ellipse with these radii, turned by `rotation` radians; SVG 1.1, F.6: radii that are too small are
/// enlarged, a radius of 0 gives a line.
CurveSegment arc_between(const Point& a, const Point& b, Point radii, double rotation, bool large, bool positive);

/// One connected curve. Closed: its last segment ends where the first begins.
struct Subpath {
  std::vector<CurveSegment> segments;
  bool closed = false;
};
using Outline = std::vector<Subpath>;

Outline transformed(Outline outline, const Affine& by);
/// The smallest box that holds the curves; exact up to rounding.
Box bounding_box(const Outline& outline);
/// The largest size of a coordinate of the points that define the curves; infinite if one is not finite.
double largest_coordinate(const Outline& outline);

/// A flattened curve and where on it the source's nodes and corners are.
struct Flattened {
  Polyline points;
  std::vector<std::size_t> nodes, corners;  // positions in `points`
};
/// Within `tolerance` of the curve; nullopt if that takes more than `most` points.
std::optional<Flattened> flattened(const Subpath& subpath, double tolerance, std::size_t most);

}  // namespace oxturn::svg

#include "maps/drawings/outline.hpp"

#include <algorithm>
#include <limits>

#include "base/math.hpp"

namespace oxturn::svg {
namespace {

constexpr double kCorner = kPi / 180;  // radians between tangents

/// The values s in (0, 1) at which a Bézier curve of degree 3 may be extreme: roots of a quadratic.
void add_roots(std::vector<double>& roots, double a, double b, double c) {
  const double d = b * b - 4 * a * c;
  if (d < 0) return;
  const double q = -0.5 * (b + std::copysign(std::sqrt(d), b));
  if (a != 0) roots.push_back(q / a);
  if (q != 0) roots.push_back(c / q);
}

/// Where one coordinate of a segment may be extreme, as s in [0, 1], ends included.
std::vector<double> extremes(const CurveSegment& g, Eigen::Index k) {
  std::vector<double> at{0, 1};
  const double p0 = g.p[0][k], p1 = g.p[1][k], p2 = g.p[2][k], p3 = g.p[3][k];
  if (g.kind == CurveSegment::Kind::quadratic) add_roots(at, 0, p0 - 2 * p1 + p2, p1 - p0);
  if (g.kind == CurveSegment::Kind::cubic) add_roots(at, p3 - p0 + 3 * (p1 - p2), 2 * (p0 - 2 * p1 + p2), p1 - p0);
  if (g.kind == CurveSegment::Kind::arc && g.sweep != 0)
    for (int turn = -9; turn <= 9; ++turn) at.push_back((math::atan2(p2, p1) + turn * kPi - g.from) / g.sweep);
  std::erase_if(at, [](double s) { return !(s >= 0 && s <= 1); });
  return at;
}

/// How many equal steps of the parameter keep chords within the tolerance.
double steps_of(const CurveSegment& g, double tolerance) {
  const auto second = [&](std::size_t i) { return (g.p[i] - 2 * g.p[i + 1] + g.p[i + 2]).norm(); };
  switch (g.kind) {
    case CurveSegment::Kind::line:
      return 1;
    // The chord error of a curve is at most |second derivative| / 8 per squared step.
    case CurveSegment::Kind::quadratic:
      return std::ceil(std::sqrt(second(0) / (4 * tolerance)));
    case CurveSegment::Kind::cubic:
      return std::ceil(std::sqrt(0.75 * std::max(second(0), second(1)) / tolerance));
    case CurveSegment::Kind::arc:
      break;
  }
  const double radius = std::sqrt(g.p[1].squaredNorm() + g.p[2].squaredNorm());  // at least the larger half-axis
  const double widest = tolerance < radius ? 2 * math::acos(1 - tolerance / radius) : kPi / 2;
  return std::ceil(std::abs(g.sweep) / std::min(widest, kPi / 2));
}

/// The direction in which a segment leaves its start (or, reversed, arrives at its end); zero if it has no length.
Point tangent(const CurveSegment& g, bool at_end) {
  if (g.kind == CurveSegment::Kind::arc) {
    const double t = g.from + (at_end ? g.sweep : 0);
    return std::copysign(1.0, g.sweep) * (g.p[2] * math::cos(t) - g.p[1] * math::sin(t));
  }
  const std::size_t last = g.kind == CurveSegment::Kind::line ? 1 : g.kind == CurveSegment::Kind::quadratic ? 2 : 3;
  for (std::size_t i = 1; i <= last; ++i) {
    const Point d = at_end ? Point(g.p[last] - g.p[last - i]) : Point(g.p[i] - g.p[0]);
    if (d.squaredNorm() > 0) return d;
  }
  return {0, 0};
}

bool is_corner(const CurveSegment& before, const CurveSegment& after) {
  const Point a = tangent(before, true), b = tangent(after, false);
  return std::abs(math::atan2(cross(a, b), a.dot(b))) > kCorner;
}

}  // namespace

Affine Affine::operator*(const Affine& inner) const {
  const Point x = direction({inner.a, inner.b}), y = direction({inner.c, inner.d}), o = (*this)({inner.e, inner.f});
  return {x.x(), x.y(), y.x(), y.y(), o.x(), o.y()};
}

Point CurveSegment::at(double s) const {
  const double r = 1 - s;
  switch (kind) {
    case Kind::line:
      return s == 1 ? p[1] : lerp(p[0], p[1], s);
    case Kind::quadratic:
      return r * r * p[0] + 2 * r * s * p[1] + s * s * p[2];
    case Kind::cubic:
      return r * r * r * p[0] + 3 * r * r * s * p[1] + 3 * r * s * s * p[2] + s * s * s * p[3];
    case Kind::arc:
      break;
  }
  const double t = from + s * sweep;
  return p[0] + math::cos(t) * p[1] + math::sin(t) * p[2];
}

CurveSegment line(const Point& a, const Point& b) { return {CurveSegment::Kind::line, {a, b, b, b}, 0, 0}; }
CurveSegment quadratic(const Point& a, const Point& control, const Point& b) {
  return {CurveSegment::Kind::quadratic, {a, control, b, b}, 0, 0};
}
CurveSegment cubic(const Point& a, const Point& control1, const Point& control2, const Point& b) {
  return {CurveSegment::Kind::cubic, {a, control1, control2, b}, 0, 0};
}
CurveSegment arc(const Point& centre, const Point& u, const Point& v, double from, double sweep) {
  return {CurveSegment::Kind::arc, {centre, u, v, Point(0, 0)}, from, sweep};
}

CurveSegment arc_between(const Point& a, const Point& b, Point radii, double rotation, bool large, bool positive) {
  radii = radii.cwiseAbs();
  if (!(radii.minCoeff() > 0) || a == b) return line(a, b);
  const double cosine = math::cos(rotation), sine = math::sin(rotation);
  const auto turned_back = [&](const Point& v) {
    return Point(cosine * v.x() + sine * v.y(), cosine * v.y() - sine * v.x());
  };
  // On the unit circle, half the chord from a to b is h, and its middle the origin.
  Point h = turned_back((b - a) / 2).cwiseQuotient(radii);
  if (const double size = h.norm(); size > 1) {
    radii *= size;
    h /= size;
  }
  const double away = std::sqrt(std::max(0.0, 1 - h.squaredNorm())) / h.norm();
  const Point centre = (large == positive ? -1 : 1) * away * perpendicular(h);
  const Point from = -h - centre, to = h - centre;
  double sweep = math::atan2(cross(from, to), from.dot(to));
  if (positive && sweep < 0) sweep += 2 * kPi;
  if (!positive && sweep > 0) sweep -= 2 * kPi;
  const auto turned = [&](const Point& v) {
    return Point(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y());
  };
  const Point middle = (a + b) / 2 + turned(centre.cwiseProduct(radii));
  return arc(middle, turned({radii.x(), 0}), turned({0, radii.y()}), math::atan2(from.y(), from.x()), sweep);
}

Outline transformed(Outline outline, const Affine& by) {
  for (Subpath& subpath : outline)
    for (CurveSegment& g : subpath.segments)
      for (std::size_t i = 0; i < g.p.size(); ++i)
        g.p[i] = g.kind == CurveSegment::Kind::arc && i > 0 ? by.direction(g.p[i]) : by(g.p[i]);
  return outline;
}

Box bounding_box(const Outline& outline) {
  Box box;
  for (const Subpath& subpath : outline)
    for (const CurveSegment& g : subpath.segments)
      for (const Eigen::Index k : {0, 1})
        for (const double s : extremes(g, k)) box.add(g.at(s));
  return box;
}

double largest_coordinate(const Outline& outline) {
  double most = 0;
  for (const Subpath& subpath : outline)
    for (const CurveSegment& g : subpath.segments)
      for (const Point& p : g.p) {
        if (!finite(p)) return std::numeric_limits<double>::infinity();
        most = std::max(most, p.cwiseAbs().maxCoeff());
      }
  return most;
}

std::optional<Flattened> flattened(const Subpath& subpath, double tolerance, std::size_t most) {
  Flattened out;
  const auto& all = subpath.segments;
  if (all.empty()) return out;
  out.points.push_back(all.front().start());
  out.nodes.push_back(0);
  if (subpath.closed && is_corner(all.back(), all.front())) out.corners.push_back(0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double steps = std::max(1.0, steps_of(all[i], tolerance));
    if (!(steps + static_cast<double>(out.points.size()) <= static_cast<double>(most))) return std::nullopt;
    for (double k = 1; k <= steps; ++k)
      if (const Point p = all[i].at(k / steps); p != out.points.back()) out.points.push_back(p);
    // A closed curve ends exactly where it began, whatever the rounding.
    if (subpath.closed && i + 1 == all.size() && out.points.size() > 1) out.points.back() = out.points.front();
    const std::size_t here = out.points.size() - 1;
    if (out.nodes.back() != here) out.nodes.push_back(here);
    if (i + 1 < all.size() && is_corner(all[i], all[i + 1]) && here > 0) out.corners.push_back(here);
  }
  return out;
}

}  // namespace oxturn::svg

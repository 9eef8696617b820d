/// Connections of two poses by spiro curves: pieces of clothoids through control points, by libspiro.
///
///   const std::vector<Point> through = spiro_control_points(from, to, 2 * radius, SpiroRule::improved);
///   const std::optional<SmoothCurve> curve = spiro_curve(from, to, through, 2 * radius);
///
/// The curve passes through its control points with continuous curvature, leaves `from` and reaches `to` along their
/// headings, without curvature at its ends. Without control points the curvature may become large, so for all but
/// gentle connections there are two, each at the distance rho = 2 radius along the heading; they are moved where they
/// are too close to each other or where the curve would swing out.
///
/// Source      Levien, From Spiral to Spline, 2009 (libspiro 20221101); control points after Vollprecht 2014
/// Complexity  30 to 50 microseconds
#pragma once

#include <optional>
#include <vector>

#include "algorithms/smoothing/smooth_curve.hpp"

namespace oxturn {

/// How control points are moved. `literal`: as in Vollprecht's program; those too close to each other are pushed apart
/// along their line. `improved`: as in his text; they are turned about the ends in opposite senses.
enum class SpiroRule { literal, improved };

/// None for a gentle connection, else two.
std::vector<Point> spiro_control_points(const Pose& from, const Pose& to, double rho, SpiroRule rule);

/// Through any control points, also those of a person. nullopt: libspiro finds no curve, or one that is not finite or
/// has kinks. The curvature is not limited (largest_curvature() tells it); the ends and their headings are exact.
std::optional<SmoothCurve> spiro_curve(const Pose& from, const Pose& to, const std::vector<Point>& through, double rho);

}  // namespace oxturn

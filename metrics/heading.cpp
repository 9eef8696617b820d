#include "metrics/heading.hpp"

#include <cmath>

#include "base/math.hpp"
#include "geometry/point_count.hpp"

namespace oxturn {
namespace {

constexpr double kStraight = 1e-7;  // radians; less is rounding
// In tool widths; the header explains them.
constexpr double kGentleRadius = 31;
constexpr double kLongChord = 0.5;
constexpr double kMostChordError = 0.0015;

/// Does `next` belong to the same bend as `last`? `gentle`: metres driven so far with only gentle curving.
bool linked(const Turn& last, const Turn& next, double w, double& gentle) {
  const double mean = (std::abs(last.angle) + std::abs(next.angle)) / 2;
  const double between = next.before;
  gentle = mean * kGentleRadius * w < between ? gentle + between : 0;
  if (gentle >= w * kLongChord || between >= w * kLongChord || last.angle * next.angle < 0) return false;
  const bool corner = std::abs(last.angle) > kCorner || std::abs(next.angle) > kCorner;
  return !corner || between * mean / 8 <= kMostChordError * w;
}

}  // namespace

Headings headings(const Problem& problem, const Path& path) {
  const double near = problem.tolerance(), w = problem.robot().tool_width;
  Headings result;
  result.turns.reserve(point_count(path.legs));
  bool any_point = false, any_heading = false;
  Point at(0, 0), heading(0, 0);
  double run = 0, gentle = 0;
  for (const Leg& leg : path.legs) {
    for (const Point& p : leg.points) {
      if (!any_point) {
        at = p;
        any_point = true;
        continue;
      }
      const Point step = leg.gear == Gear::forward ? Point(p - at) : Point(at - p);
      const double length = step.norm();
      if (length <= near) continue;
      if (any_heading) {
        const double angle = math::atan2(cross(heading, step), heading.dot(step));
        if (std::abs(angle) > kStraight) {
          Turn turn{angle, run, false};
          if (!result.turns.empty()) turn.linked = linked(result.turns.back(), turn, w, gentle);
          result.turns.push_back(turn);
          run = 0;
        }
      }
      any_heading = true;
      heading = step;
      run += length;
      at = p;
    }
  }
  result.after = run;
  return result;
}

}  // namespace oxturn

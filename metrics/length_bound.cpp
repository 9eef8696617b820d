#include "metrics/length_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/minkowski.hpp"
#include "geometry/tether/geodesic_field.hpp"
#include "metrics/arm_bound.hpp"
#include "metrics/disc_area.hpp"
#include "metrics/level_cells.hpp"
#include "metrics/spill.hpp"
#include "metrics/tour_bound.hpp"

namespace oxturn {
namespace {

constexpr double kRounding = 1e-9;    // tool widths squared
constexpr double kLeastShare = 1e-6;  // of the covered area: less is nothing
// Tool widths: distance of samples of where something can be covered, and by how much rounding may be wrong there.
constexpr double kSample = 0.1, kTooSmall = 0.01, kChordError = 1e-3;

/// How a path begins. Of paths that are not valid nothing is known: the whole disc may lie in the target.
struct Beginning {
  double approach = 0;  // metres that it drives at least before its tool reaches the target
  double area;          // of the target under the tool's disc at the start at most
};

/// Length of the shortest path to where something of the target can be covered, at least; 0: at the start itself.
double approach(const Problem& problem) {
  const double w = problem.robot().tool_width;
  const auto hit = EdgeIndex(problem.target()).nearest(problem.start());
  if (contains(problem.target(), problem.start()) || !hit || hit->distance <= (0.5 + kTooSmall) * w) return 0;
  const double straight = hit->distance - (0.5 + kTooSmall) * w;
  const Region space = wide_space(problem);
  if (space.empty()) return straight;
  const GeodesicField field(space, problem.start(), {}, problem.tolerance());
  double least = std::numeric_limits<double>::infinity();
  const Region near = intersect(dilate(problem.target(), w / 2, kChordError * w, Bound::outside), space);
  for_each_edge(near, [&](const Point& a, const Point& b) {
    const int steps = static_cast<int>(std::ceil(distance(a, b) / (kSample * w)));
    for (int k = 0; k < steps; ++k) {
      const double away = field.distance(lerp(a, b, static_cast<double>(k) / steps));
      least = std::min(least, std::isfinite(away) ? away : 0);
    }
  });
  return std::max(straight, std::isfinite(least) ? least - (kSample / 2 + kTooSmall) * w : 0);
}

Beginning beginning(const Problem& problem, bool valid) {
  const double w = problem.robot().tool_width;
  Beginning result{0, kPi * w * w / 4};
  if (!valid) return result;
  DiscArea under(problem.start(), w / 2);
  for_each_edge(problem.target(), [&](const Point& a, const Point& b) { under.add(a, b); });
  const double inside = under.area();
  result.area = std::clamp(inside + 4 * w * problem.tolerance(), 0.0, result.area);
  if (problem.map().target_area && inside < kLeastShare * w * w) result.approach = approach(problem);
  if (result.approach > 0) result.area = 0;
  return result;
}

/// Can the tool leave the target, and is all of it used everywhere?
bool may_spill(const Problem& problem, const Path& path) {
  const Robot& robot = problem.robot();
  return std::ranges::all_of(path.legs, [](const Leg& leg) { return leg.width == 0; }) &&
         (problem.map().target_area || robot.tool_width / 2 > robot.radius);
}

}  // namespace

std::optional<LengthBound> length_bound(const Problem& problem, const Path& path, const SweptArea& swept, bool valid) {
  const double w = problem.robot().tool_width, uncovered = std::max(0.0, area(problem.target()) - swept.covered_m2);
  const Beginning begin = beginning(problem, valid);
  const auto metres = [&](double area) -> double { return begin.approach + (area - begin.area) / w; };
  LengthBound best{LengthBound::Kind::area, metres(swept.covered_m2)};
  const auto offer = [&](LengthBound::Kind kind, double bound) {
    if (bound > best.metres + kLeastShare * swept.covered_m2 / w) best = {kind, bound};
  };
  if (may_spill(problem, path)) {
    // The first disc that reaches the target is not known unless it is at the start: it may lie wherever it spills.
    const bool known = valid && begin.approach == 0;
    const double spill =
        least_spill(problem.target(), w, uncovered, known ? std::optional(problem.start()) : std::nullopt);
    offer(LengthBound::Kind::spill,
          metres(swept.covered_m2 + (begin.approach > 0 ? std::max(0.0, spill - kPi * w * w / 4) : spill)));
  }
  if (valid) offer(LengthBound::Kind::tour, tour_bound(problem.target(), w, uncovered, problem.start()));
  if (valid)
    if (const auto arms = arm_bound(problem, uncovered, begin.area)) offer(LengthBound::Kind::arms, *arms);
  if (best.metres <= kRounding * w) return std::nullopt;
  return best;
}

}  // namespace oxturn

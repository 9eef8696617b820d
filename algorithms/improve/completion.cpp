#include "algorithms/improve/completion.hpp"

#include <algorithm>
#include <utility>

#include "algorithms/improve/stops.hpp"
#include "algorithms/lanes/inner_space.hpp"
#include "algorithms/lanes/repair.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"

namespace oxturn {
namespace {

// In tool widths, or squares of it.
constexpr double kReach = 0.5 - 1e-3;              // from which a stop covers, with that error
constexpr double kNegligible = 1e-6;               // pieces of less area
constexpr double kMostSlack = 2e-5, kSlack = 0.2;  // shares of the target, and of what may stay uncovered
constexpr int kPasses = 2;                         // of stops
constexpr int kRepairs = 4;                        // until the share is reached, at most

}  // namespace

Polyline vertices_of(const Path& path, const Point& start) {
  Polyline points{start};
  for (const Leg& leg : path.legs) points.insert(points.end(), leg.points.begin() + 1, leg.points.end());
  return points;
}

Path driven(const Polyline& points) {
  PathBuilder path(points.front());
  path.drive(points, true);
  return path.take();
}

Completion::Completion(const Problem& problem, double coverage)
    : problem_(problem),
      connector_(problem),
      width_(problem.robot().tool_width),
      coverage_(coverage),
      target_(reachable_target(problem, 0, kChord)) {}

double Completion::allowed() const {
  const double share = 1 - coverage_;
  return (share - std::min(kMostSlack, kSlack * share)) * area(problem_.target());
}

Region Completion::uncovered(const Polyline& points) const {
  return subtract(target_, swath_parts({points}, width_ / 2, kChord * width_, Bound::inside));
}

/// Without the smallest pieces, as far as the coverage allows.
Region Completion::needed(Region uncovered) const {
  std::vector<Polygon>& pieces = uncovered.polygons;
  std::ranges::stable_sort(pieces, {}, [](const Polygon& p) { return area(p); });
  double left = allowed();
  const auto first = std::ranges::find_if(pieces, [&](const Polygon& p) {
    left -= area(p);
    return left < 0 && area(p) > kNegligible * width_ * width_;
  });
  pieces.erase(pieces.begin(), first);
  return uncovered;
}

Polyline Completion::completed(Polyline points, Context& context) const {
  Region left = needed(uncovered(points));
  for (int pass = 0; pass < kPasses && !left.empty(); ++pass) {
    points = with_stops(points, left.polygons, kReach * width_, problem_.walls());
    left = needed(uncovered(points));
  }
  const auto repair = [&](Region pieces) {
    points = vertices_of(repaired(problem_, driven(points), std::move(pieces), connector_, context), problem_.start());
  };
  if (coverage_ >= 1) {
    if (!left.empty() && !context.cancelled()) repair(std::move(left));
    return points;
  }
  // Wider and wider, because repaired() ignores seams: they may be ignored only where everything is asked for.
  double margin = covered_seam(problem_.robot());
  for (int round = 0; round < kRepairs && !left.empty() && !context.cancelled(); ++round, margin *= 2) {
    repair(intersect(target_, dilate(left, margin, kChord * width_, Bound::outside)));
    left = needed(uncovered(points));
  }
  return points;
}

}  // namespace oxturn

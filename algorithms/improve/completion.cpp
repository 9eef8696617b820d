#include "algorithms/improve/completion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/improve/detours.hpp"
#include "algorithms/lanes/covered_cells.hpp"
#include "algorithms/lanes/inner_space.hpp"
#include "algorithms/lanes/repair.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"

namespace oxturn {
namespace {

// In tool widths, or squares of it.
constexpr double kReach = 0.5 - 1e-3;  // from which a stop covers, with that error
constexpr double kNegligible = 1e-6;   // pieces of less area
// What who judges the path takes for uncovered besides, less the target's own error: at most a share of the target, and
// of what may stay uncovered, of which the last share is used in any case.
constexpr double kMostJudged = 1.5e-4, kJudged = 0.45, kLeastUsed = 0.15;
constexpr double kShortestPart = 0.05;  // of a piece
constexpr double kLongestPiece = 1;     // to be covered at once
constexpr double kNoticed = 1e-3;       // smaller pieces, of what may stay uncovered, get no strokes
constexpr int kPasses = 3;              // of detours
constexpr double kShort = 1.02;         // times the path's length: no other detours are tried
constexpr int kRepairs = 4;             // until the share is reached, at most

/// The piece cut in halves until none is longer than `most`.
void add_parts(const Polygon& piece, double most, std::vector<Polygon>& to) {
  const Box box = bounding_box(piece.outer);
  const Point size = box.size();
  const int side = size.x() > size.y() ? 0 : 1;
  if (size[side] <= most) return to.push_back(piece);
  for (const bool upper : {false, true}) {
    Point low = box.low, high = box.high;
    (upper ? low : high)[side] = box.centre()[side];
    for (const Polygon& half : intersect(Region{{piece}}, box_region(low, high)).polygons) add_parts(half, most, to);
  }
}

/// Of a thin piece of thickness t, a position shifted towards it by 2 t covers about 2 sqrt(t w): the shortest detours
/// for its length are that far apart.
double part_length(const Polygon& piece, double width) {
  const double thickness = 2 * area(piece) / perimeter(Region{{piece}});
  return std::max(2 * std::sqrt(thickness * width), kShortestPart * width);
}

/// Long pieces in parts, and each of them in smaller ones.
std::vector<ToCover> in_parts(const Region& uncovered, double width) {
  std::vector<Polygon> pieces;
  for (const Polygon& piece : uncovered.polygons) add_parts(piece, kLongestPiece * width, pieces);
  std::vector<ToCover> all;
  for (const Polygon& piece : pieces) {
    all.push_back({piece, {}});
    add_parts(piece, part_length(piece, width), all.back().parts);
  }
  return all;
}
std::vector<ToCover> as_they_are(const Region& uncovered) {
  std::vector<ToCover> all;
  for (const Polygon& piece : uncovered.polygons) all.push_back({piece, {piece}});
  return all;
}

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

Completion::Completion(const Problem& problem, double coverage, AnnealingPart without)
    : problem_(problem),
      connector_(problem),
      width_(problem.robot().tool_width),
      coverage_(coverage),
      without_(without),
      target_(reachable_target(problem, 0, kChord)) {}

double Completion::allowed() const {
  const double share = 1 - coverage_, whole = area(problem_.target());
  const double judged = std::min(kMostJudged, kJudged * share) * whole;
  return std::max(share * whole - judged - problem_.target_excess(), kLeastUsed * share * whole);
}

/// Of a path of many short segments, only the cells that it does not certainly cover are looked at.
Region Completion::uncovered(const Polyline& points) const {
  const std::vector<Polyline> whole{points};
  const auto open = in_open_cells(target_, {{whole, width_ / 2, 0}});
  return left_of(open ? open->region : target_, open ? open->near[0] : whole);
}

Region Completion::left_of(const Region& region, const std::vector<Polyline>& lines) const {
  return subtract(region, swath_parts(lines, width_ / 2, kChord * width_, Bound::inside));
}

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

Polyline Completion::completed(Polyline points, Region left, Context& context) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  // Where everything is asked for, strokes would be made along seams, which repaired() ignores.
  Polyline whole = detoured(
      points, left, coverage_ < 1 && without_ != AnnealingPart::strokes ? kNoticed * allowed() : kNone, context);
  const bool short_enough = length(whole) <= kShort * length(points);
  if (coverage_ >= 1 || short_enough || context.cancelled()) return whole;
  Polyline other = detoured(std::move(points), std::move(left), kNone, context);
  return context.cancelled() || length(whole) <= length(other) ? whole : other;
}

/// `noticed`: pieces of less area get no strokes.
Polyline Completion::detoured(Polyline points, Region left, double noticed, Context& context) const {
  Region rest = needed(left);
  for (int pass = 0; pass < kPasses && !rest.empty() && without_ != AnnealingPart::detours; ++pass) {
    const double enough = coverage_ >= 1 ? std::numeric_limits<double>::infinity() : area(left) - allowed();
    WithDetours longer = with_detours(points, coverage_ < 1 ? in_parts(left, width_) : as_they_are(left), enough,
                                      noticed, kReach * width_, connector_, problem_.walls());
    points = std::move(longer.path);
    if (longer.detours.empty()) break;
    left = left_of(left, longer.detours);
    rest = needed(left);
  }
  if (rest.empty() || context.cancelled()) return points;
  const auto repair = [&](Region pieces) {
    points = vertices_of(repaired(problem_, driven(points), std::move(pieces), connector_, context), problem_.start());
  };
  if (coverage_ >= 1) {
    repair(std::move(rest));
    return points;
  }
  // Wider and wider, because repaired() ignores seams: they may be ignored only where everything is asked for.
  double margin = covered_seam(problem_.robot());
  for (int round = 0; round < kRepairs && !rest.empty() && !context.cancelled(); ++round, margin *= 2) {
    repair(intersect(target_, dilate(rest, margin, kChord * width_, Bound::outside)));
    rest = needed(uncovered(points));
  }
  return points;
}

}  // namespace oxturn

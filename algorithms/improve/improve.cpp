#include "algorithms/improve/improve.hpp"

#include <algorithm>

#include "algorithms/improve/annealing.hpp"
#include "algorithms/lanes/repair.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"

namespace oxturn {
namespace {

// In tool widths.
constexpr double kHot = 0.05, kWarm = 0.005, kCool = 0.002, kCold = 1e-4;
constexpr double kCoarseCell = 1.0 / 20, kFineCell = 1.0 / 80;
constexpr double kMargin = 0.002;         // by which the tool is narrower on the fine raster
constexpr double kPrice = 4;              // of uncovered area to begin with: 1 / w
constexpr double kStraight = 0.005;       // vertices nearer to their chord are dropped at the beginning
constexpr double kChord = 1e-3;           // error of arcs where coverage is measured
constexpr double kLeastUncovered = 1e-4;  // share of the target that annealing leaves uncovered at least
constexpr double kAtLength = 0.7;         // share of the moves of the first round
constexpr int kRounds = 3;                // of closing
// Moves for each square of the tool's width, and in all at most, if the user names no number.
constexpr double kMovesEach = 4000, kMostMoves = 2e6;

Polyline vertices(const Path& path, const Point& start) {
  Polyline points{start};
  for (const Leg& leg : path.legs) points.insert(points.end(), leg.points.begin() + 1, leg.points.end());
  return points;
}

Path driven(const Polyline& points) {
  PathBuilder path(points.front());
  path.drive(points, true);
  return path.take();
}

/// Without vertices that lie on the chord of their neighbours, as those of finely sampled arcs.
Polyline straightened(const Polyline& points, double tolerance, const EdgeIndex& walls) {
  Polyline kept{points.front()};
  std::size_t from = 0;  // of the last one kept
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const auto near = [&](const Point& p) { return distance_to_segment(p, kept.back(), points[i + 1]) <= tolerance; };
    const auto at = [&](std::size_t k) { return points.begin() + static_cast<std::ptrdiff_t>(k); };
    if (std::all_of(at(from + 1), at(i + 1), near) && walls.contains(kept.back(), points[i + 1])) continue;
    kept.push_back(points[i]);
    from = i;
  }
  if (points.size() > 1) kept.push_back(points.back());
  return kept;
}

/// What can be covered from configuration space: where that was restricted, not all of the target.
Region reachable_target(const Problem& problem) {
  if (!problem.limited()) return problem.target();
  const double width = problem.robot().tool_width;
  return intersect(problem.target(), dilate(problem.configuration_space(), width / 2, kChord * width, Bound::inside));
}

class Improver {
 public:
  Improver(const Problem& problem, const Improvement& how, Context& context)
      : problem_(problem),
        how_(how),
        context_(context),
        connector_(problem),
        width_(problem.robot().tool_width),
        target_(reachable_target(problem)),
        price_(kPrice / width_) {}

  Path run(const Path& path) {
    offer(path);
    Polyline points = straightened(vertices(path, problem_.start()), kStraight * width_, problem_.walls());
    const double moves =
        how_.moves > 0 ? how_.moves : std::min(kMostMoves, kMovesEach * area(target_) / (width_ * width_));
    points = annealed(points, kCoarseCell, 0, {static_cast<long>(kAtLength * moves), kHot * width_, kWarm * width_});
    for (int round = 0; round < kRounds && !context_.cancelled(); ++round) {
      const long part = static_cast<long>((1 - kAtLength) / kRounds * moves);
      points = annealed(points, kFineCell, kMargin, {part, kCool * width_, kCold * width_});
      points = vertices(offer(driven(points)), problem_.start());
    }
    return std::move(best_);
  }

 private:
  Polyline annealed(const Polyline& points, double cell, double margin, const Annealing::Schedule& schedule) {
    Annealing annealing(problem_, target_, points,
                        {.cell = cell * width_,
                         .radius = (0.5 - margin) * width_,
                         .uncovered = std::max(1 - how_.coverage, kLeastUncovered) * area(target_),
                         .price = price_});
    annealing.run(schedule, context_.rng(), context_);
    price_ = annealing.price();
    return annealing.points();
  }

  /// With detours, such that it covers as much as is asked for; all but seams, if that is everything.
  Path completed(const Path& path) {
    std::vector<Polyline> lines;
    for (const Leg& leg : path.legs)
      if (leg.tool) lines.push_back(leg.points);
    const bool all = how_.coverage >= 1;
    const double error = all ? covered_seam(problem_.robot()) : kChord * width_;
    Region left = subtract(target_, swath_parts(lines, width_ / 2, error, all ? Bound::outside : Bound::inside));
    std::ranges::sort(left.polygons, {}, [](const Polygon& p) { return area(p); });
    double allowed = (1 - how_.coverage) * area(problem_.target());
    const auto needed = std::ranges::find_if(left.polygons, [&](const Polygon& p) {
      allowed -= area(p);
      return allowed < 0;
    });
    left.polygons.erase(left.polygons.begin(), needed);
    return left.empty() ? path : repaired(problem_, path, std::move(left), connector_, context_);
  }

  /// Completed; it is kept if it is the shortest one so far.
  Path offer(const Path& path) {
    Path complete = completed(path);
    const bool first = best_.legs.empty();
    if (first || (!context_.cancelled() && complete.length() < best_.length())) {
      best_ = complete;
      context_.publish(best_);
    }
    return complete;
  }

  const Problem& problem_;
  const Improvement& how_;
  Context& context_;
  const Connector connector_;
  double width_;
  const Region target_;
  double price_;
  Path best_;
};

}  // namespace

const std::vector<Parameter<Improvement>>& improvement_parameters() {
  static const std::vector<Parameter<Improvement>> all{
      {"coverage", &Improvement::coverage, Range{0, 1}, "share of the target that is to be covered"},
      {"moves", &Improvement::moves, Range{0, 1e9},
       "moves of annealing; 0: 4000 for each square of the tool's width in the target, at most 2e6"}};
  return all;
}

bool covers_all(const Settings& settings) {
  const auto coverage = settings.find("coverage");
  if (coverage == settings.end()) return true;
  const double* share = std::get_if<double>(&coverage->second);
  return share == nullptr || *share >= 1;  // else it is a whole number: 1
}

Path improved(const Problem& problem, const Path& path, const Improvement& how, Context& context) {
  return Improver(problem, how, context).run(path);
}

}  // namespace oxturn

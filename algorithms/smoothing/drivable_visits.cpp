#include "algorithms/smoothing/drivable_visits.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/lanes/uncovered.hpp"
#include "algorithms/smoothing/covering_strokes.hpp"
#include "algorithms/smoothing/reinserted_strokes.hpp"

namespace oxturn {
namespace {

constexpr int kRounds = 10;
constexpr double kNoticed = 1e-4;     // squares of the tool's width: smaller pieces are not visited
constexpr double kSlack = 0.97;       // of what may stay uncovered: others measure with errors of their own
constexpr double kLeastGain = 0.02;   // of a piece, or
constexpr double kLeastArea = 2e-3;   // squares of the tool's width: what a visit is worth
constexpr std::size_t kFeasible = 2;  // strokes that can be inserted, of which the better one is
constexpr std::size_t kFailures = 4;  // points of a piece that no stroke gets to, before it is left alone
constexpr double kSamePoint = 0.06;   // tool widths: nearer to a point that failed, others fail too

class Visits {
 public:
  /// `strokes`: of the path, for the effort.
  Visits(const Problem& problem, double allowed, const CarSpace& space, std::size_t strokes, Context& context)
      : problem_(problem),
        width_(problem.robot().tool_width),
        allowed_(kSlack * allowed),
        space_(space),
        context_(context),
        effort_(strokes) {}

  std::vector<LinkedStroke> run(std::vector<LinkedStroke> driven, const std::vector<Polyline>& left_out) {
    UncoveredPoints points = uncovered_by(driven);
    cover_by_links(driven, points);
    if (!left_out.empty()) driven = with_strokes(std::move(driven), left_out, space_, width_, effort_, context_);
    for (int round = 0; round < kRounds && !context_.cancelled(); ++round) {
      points = uncovered_by(driven);
      if (points.area() <= allowed_) break;
      InsertedStrokes inserted(driven, space_, width_, effort_, context_);
      if (!visit_pieces(points, inserted)) break;
      driven = inserted.take();
      context_.publish(path_of(driven, problem_.start(), space_.chord_error()));
    }
    return driven;
  }

 private:
  UncoveredPoints uncovered_by(const std::vector<LinkedStroke>& driven) const {
    const Path path = path_of(driven, problem_.start(), space_.chord_error());
    return {uncovered(problem_.target(), path, problem_.robot()), width_, kNoticed * width_ * width_};
  }

  void cover_by_links(std::vector<LinkedStroke>& driven, UncoveredPoints& points) const {
    for (LinkedStroke& s : driven) {
      if (s.link.pieces.empty()) continue;
      const Polyline line = points_of(s.link, space_.chord_error());
      if (!points.covers_any(line)) continue;
      points.cover(line);
      s.covers = true;
    }
  }

  /// True if any got a stroke.
  bool visit_pieces(UncoveredPoints& points, InsertedStrokes& inserted) {
    bool any = false;
    for (const std::vector<std::size_t>& piece : points.pieces()) {
      std::size_t failures = 0;
      for (const std::size_t k : piece) {
        if (points.area() <= allowed_ || context_.cancelled()) return any;
        if (points.covered(k) || failed_before(points.at(k))) continue;
        if (visit(points, k, piece, inserted)) {
          any = true;
          continue;
        }
        failed_.push_back(points.at(k));
        if (++failures >= kFailures) break;
      }
    }
    return any;
  }

  bool failed_before(const Point& p) const {
    return std::ranges::any_of(failed_, [&](const Point& q) { return distance(p, q) < kSamePoint * width_; });
  }

  bool visit(UncoveredPoints& points, std::size_t k, const std::vector<std::size_t>& piece, InsertedStrokes& inserted) {
    double whole = 0;
    for (const std::size_t i : piece) whole += points.share(i);
    const double least = std::min(kLeastGain * whole, kLeastArea * width_ * width_);
    std::optional<InsertedStrokes::Insertion> best;
    double most = 0;
    std::size_t feasible = 0;
    std::vector<CoveringStroke> strokes = covering_strokes(points, k, space_, width_);
    std::erase_if(strokes, [&](const CoveringStroke& s) { return s.gain < least; });
    for (const CoveringStroke& s : strokes) {
      auto insertion = inserted.insertion_of(s.points, false);
      if (!insertion) continue;
      const double worth = s.gain / std::max(insertion->cost, width_);
      if (!best || worth > most) most = worth, best = std::move(insertion);
      if (++feasible == kFeasible) break;
    }
    if (!best && !strokes.empty()) best = inserted.insertion_of(strokes.front().points, true);
    if (!best) return false;
    points.cover(points_of(best->to, space_.chord_error()));
    points.cover(best->stroke);
    if (best->back) points.cover(points_of(*best->back, space_.chord_error()));
    inserted.insert(std::move(*best));
    return true;
  }

  const Problem& problem_;
  double width_, allowed_;
  const CarSpace& space_;
  Context& context_;
  DetourEffort effort_;
  std::vector<Point> failed_;  // points that no stroke gets to
};

}  // namespace

std::vector<LinkedStroke> with_visits(const Problem& problem, std::vector<LinkedStroke> driven,
                                      const std::vector<Polyline>& left_out, double allowed, const CarSpace& space,
                                      Context& context) {
  if (driven.empty() || context.cancelled()) return driven;
  Visits visits(problem, allowed, space, driven.size() + left_out.size(), context);
  return visits.run(std::move(driven), left_out);
}

}  // namespace oxturn

#include "algorithms/improve/improve.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <thread>

#include "algorithms/improve/annealing.hpp"
#include "algorithms/improve/completion.hpp"
#include "algorithms/lanes/inner_space.hpp"

namespace oxturn {
namespace {

// In tool widths.
constexpr double kWarm = 0.005, kCold = 1e-4;  // temperatures after the first one
constexpr double kCoarseCell = 1.0 / 20, kFineCell = 1.0 / 60;
constexpr double kMargin = 0.002;    // by which the tool is narrower on the fine raster
constexpr double kStraight = 0.005;  // vertices nearer to their chord are dropped at the beginning
// The price of uncovered area is 1 / w times kPrice at an uncovered share of kPriceAt, and grows with a power of that.
constexpr double kPrice = 5, kPriceAt = 0.01, kPricePower = -0.4;
constexpr double kFineBelow = 1e-3;       // uncovered share below which the fine raster is needed
constexpr double kLeastUncovered = 1e-4;  // share of the target that annealing leaves uncovered at least
// Shares of the moves: of each short run of several, and of closing, in rounds.
constexpr double kBrief = 0.06, kClosing = 0.25;
constexpr double kLeastShift = 0.001, kMostShift = 0.1;  // of vertices in closing
constexpr int kRounds = 3;
constexpr double kShortDetours = 1.03;  // times the path's length, of a path with detours that is worth going on with
// Moves for each square of the tool's width, and in all at most, if the user names no number.
constexpr double kMovesEach = 4000, kMostMoves = 2e6;

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

/// Vertices near a wall moved to it where the edges stay inside: a hot path is slightly off the walls, and covers all
/// but a seam along them.
Polyline along_walls(Polyline points, bool fixed_end, double width, const EdgeIndex& walls) {
  for (std::size_t i = 1; i + (fixed_end ? 1 : 0) < points.size(); ++i)
    for (const bool vertex : {true, false}) {
      const auto at = on_wall(points[i], walls, width, vertex);
      if (!at || !walls.contains(points[i - 1], *at)) continue;
      if (i + 1 < points.size() && !walls.contains(*at, points[i + 1])) continue;
      points[i] = *at;
      break;
    }
  return points;
}

class Improver {
 public:
  Improver(const Problem& problem, const Improvement& how, Context& context)
      : problem_(problem),
        how_(how),
        context_(context),
        completion_(problem, how.coverage),
        width_(problem.robot().tool_width),
        share_(std::max(completion_.allowed() / area(problem.target()), kLeastUncovered)),
        narrow_(share_ < kFineBelow ? reachable_target(problem, kMargin * width_, Completion::kChord) : Region{}) {}

  Path run(const std::vector<Path>& starts) {
    std::vector<Polyline> lines;
    for (const Path& path : starts) {
      if (context_.cancelled() && !best_.empty()) break;
      Polyline points = vertices_of(path, problem_.start());
      if (how_.return_home) {
        const Polyline home = Connector(problem_).path(points.back(), problem_.start());
        points.insert(points.end(), home.begin() + 1, home.end());
      }
      offer(points);
      lines.push_back(straightened(points, kStraight * width_, problem_.walls()));
    }
    if (context_.cancelled()) return driven(best_);
    const Polyline best = lines.size() > 1 ? best_of(lines) : lines.front();
    const double used = lines.size() > 1 ? kBrief * static_cast<double>(lines.size()) : 0;
    const double at_length = 1 - used - kClosing;
    Annealing::Options options = raster(kCoarseCell, 0);
    const double allowed = options.uncovered;
    Annealed now =
        annealed(best, options, {moves(at_length), how_.temperature * width_, kWarm * width_}, context_.rng());
    for (int round = 0; round < kRounds; ++round) {
      if (context_.cancelled()) break;
      const double missed = close(now);
      if (share_ < kFineBelow) options = raster(kFineCell, kMargin);
      options.price = now.price;
      options.least_shift = kLeastShift;
      options.most_shift = kMostShift;
      options.uncovered = std::max(allowed / 2, allowed - std::max(0.0, missed - now.uncovered));
      if (share_ < kFineBelow)
        now.points = along_walls(std::move(now.points), how_.return_home, width_, problem_.walls());
      now = annealed(now.points, options, {moves(kClosing / kRounds), kWarm * width_, kCold * width_}, context_.rng());
    }
    if (!context_.cancelled()) close(now);
    return driven(best_);
  }

 private:
  struct Annealed {
    Polyline points;
    double energy, price, uncovered;
  };
  long moves(double share) const {
    const double all =
        how_.moves > 0 ? how_.moves : std::min(kMostMoves, kMovesEach * area(completion_.target()) / (width_ * width_));
    return static_cast<long>(share * all);
  }
  Annealing::Options raster(double cell, double margin) const {
    return {.cell = cell * width_,
            .radius = (0.5 - margin) * width_,
            .uncovered = share_ * area(completion_.target()),
            .price = kPrice / width_ * std::pow(share_ / kPriceAt, kPricePower),
            .fixed_end = how_.return_home};
  }
  Annealed annealed(const Polyline& points, const Annealing::Options& options, const Annealing::Schedule& schedule,
                    Rng& rng) const {
    const bool fine = options.cell < kCoarseCell * width_;
    Annealing annealing(problem_, fine ? narrow_ : completion_.target(), points, options);
    if (fine) annealing.focus(focus_);
    annealing.run(schedule, rng, context_);
    const double excess = std::max(0.0, annealing.uncovered() - options.uncovered);
    return {annealing.points(), length(annealing.points()) + options.price * excess, annealing.price(),
            annealing.uncovered()};
  }

  /// Offers the path. What it leaves uncovered, square metres; it goes on with its detours if these are short.
  double close(Annealed& path) {
    const Region uncovered = completion_.uncovered(path.points);
    focus_.clear();
    for (const Polygon& piece : uncovered.polygons) focus_.push_back(bounding_box(piece.outer).centre());
    Polyline whole = offer(path.points);
    if (length(whole) < kShortDetours * length(path.points)) path.points = std::move(whole);
    return area(uncovered);
  }

  /// Each annealed briefly, by all threads.
  Polyline best_of(const std::vector<Polyline>& lines) {
    std::vector<Annealed> results(lines.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
      for (std::size_t k = next++; k < lines.size(); k = next++) {
        Rng rng(mix(context_.seed(), "start " + std::to_string(k)));
        results[k] =
            annealed(lines[k], raster(kCoarseCell, 0), {moves(kBrief), how_.temperature * width_, kWarm * width_}, rng);
      }
    };
    problem_.walls();  // made before threads share it
    std::vector<std::jthread> others;
    for (int k = 1; k < how_.threads; ++k) others.emplace_back(work);
    work();
    others.clear();
    return std::ranges::min_element(results, {}, &Annealed::energy)->points;
  }

  /// The path completed, or as it is if cancelled. It is kept if it is the best one so far.
  Polyline offer(const Polyline& points) {
    Polyline whole = context_.cancelled() ? points : completion_.completed(points, context_);
    if (best_.empty() || (!context_.cancelled() && length(whole) < length(best_))) {
      best_ = whole;
      context_.publish(driven(best_));
    }
    return whole;
  }

  const Problem& problem_;
  const Improvement& how_;
  Context& context_;
  const Completion completion_;
  double width_;
  double share_;              // of the target that annealing may leave uncovered
  const Region narrow_;       // what the narrower tool of the fine raster can cover
  std::vector<Point> focus_;  // what the last path that was completed left uncovered
  Polyline best_;
};

}  // namespace

const std::vector<Parameter<Improvement>>& improvement_parameters() {
  static const std::vector<Parameter<Improvement>> all{
      {"coverage", &Improvement::coverage, Range{0, 1, true}, "share of the target that is to be covered"},
      {"moves", &Improvement::moves, Range{0, 1e9},
       "moves of annealing; 0: 4000 for each square of the tool's width in the target, at most 2e6"},
      {"return_home", &Improvement::return_home, "end where the path starts"},
      {"temperature", &Improvement::temperature, Range{1e-6, 10}, "of annealing, to begin with, in tool widths"},
      {"threads", &Improvement::threads, Range{1, 256}, "that work at a time; they do not change the path"}};
  return all;
}

bool covers_all(const Settings& settings) {
  const auto coverage = settings.find("coverage");
  if (coverage == settings.end()) return true;
  const double* share = std::get_if<double>(&coverage->second);
  return share == nullptr || *share >= 1;  // else it is a whole number: 1
}

Path improved(const Problem& problem, const std::vector<Path>& starts, const Improvement& how, Context& context) {
  Path path = Improver(problem, how, context).run(starts);
  if (path.legs.empty() && !context.cancelled()) throw Infeasible("from its start the robot reaches nothing to cover");
  return path;
}

}  // namespace oxturn

#include "algorithms/improve/improve.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "algorithms/improve/completion.hpp"
#include "algorithms/improve/wall_following.hpp"
#include "algorithms/improve/windows.hpp"
#include "algorithms/lanes/inner_space.hpp"
#include "base/math.hpp"
#include "base/parallel.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

// In tool widths.
// The first one if the user names none: in proportion to the moves for each square of the tool's width, but no less
// than the least, kHeat from kMovesOfHeat to kMovesOfMoreHeat, and no more than the most. With few moves, heat spoils
// more than they mend.
constexpr double kLeastHeat = 0.006, kHeat = 0.01, kMostHeat = 0.05, kMovesOfHeat = 600, kMovesOfMoreHeat = 2000;
constexpr double kWarm = 0.01, kCool = 0.005, kCold = 1e-4;  // temperatures after the first one, at most
// The second one where coverage is nearly full: what three swaths leave between them has about a hundredth of the
// square of the tool's width, which the first one does not see.
constexpr double kCoarseCell = 1.0 / 10, kLessCoarseCell = 1.0 / 20;
constexpr double kMiddleCell = 1.0 / 40, kFineCell = 1.0 / 80, kFinestCell = 1.0 / 120;
constexpr double kNarrowChord = 1e-3;   // error of arcs where witnesses are no finer than kMiddleCell
constexpr double kMargin = 0.003;       // by which the tool is narrower at first, so that lanes can be moved afterwards
constexpr double kFineMargin = 0.0015;  // in closing: what is thinner than the raster's cells
constexpr double kBesideWall = 0.02;    // edges nearer to a wall are moved to it
constexpr double kStraight = 0.005;     // vertices nearer to their chord are dropped at the beginning
constexpr double kOnChord = 1e-6;       // the same before each round of closing
constexpr double kNoTurn = 0.03;        // the same where turns are counted: a robot rounds off what is smaller
// The price of uncovered area is 1 / w times kPrice at an uncovered share of kPriceAt, and grows with a power of that.
// Where closing begins, it is kMostPrice times as much at most: at high prices no lane moves any more. The first run at
// length begins with kHotPrice times as much, about where the price settles for what that run leaves uncovered.
constexpr double kPrice = 5, kPriceAt = 0.01, kPricePower = -0.4, kMostPrice = 2.5, kHotPrice = 0.7;
// Radii. What a wider tool covers on one side of a small obstacle it may cover from the other side, so that loops
// around it can go. With narrower ones looking for these loops takes moves that others make more of.
constexpr double kWideTool = 8;
constexpr double kNearlyAll = 1e-3;  // uncovered share below which coverage is nearly full
// Share of the target that annealing leaves uncovered at least; of the whole target that is asked for.
constexpr double kLeastUncovered = 4e-5, kLeastOfWhole = 3e-6;
// The same of the first run at length: lanes move little where nothing may be left.
constexpr double kLeastHot = 5e-3;
// Shares of the moves: of each short run of several, of the second run at length, and of closing, in rounds. The first
// run at length has the others.
struct Shares {
  double brief, warming, closing;
};
constexpr Shares kOfMost{0.06, 0.184, 0.3}, kOfNearlyAll{0.02, 0.1, 0.4}, kOfWhole{0.04, 0.17, 0.4};
// Uncovered pieces that are smaller, of what is allowed in all, get no extra moves.
constexpr double kNoticed = 1e-3;
// What closing may leave uncovered on the raster, of what is allowed: it misses what is thinner than its cells.
constexpr double kFirstFactor = 1, kFirstOfStart = 0.5, kLeastFactor = 0.02;
constexpr double kLeastShift = 0.001, kMostShift = 0.1;  // of vertices in closing
constexpr int kMostRounds = 10;
// Temperatures above which larger targets are annealed as a whole: all but those of closing. Where coverage is nearly
// full, lanes move little: windows, with a steady price, make shorter paths of the same moves, from so many on for each
// square of the tool's width.
constexpr double kHot = 0.0055, kHotOfNearlyAll = 0.011, kMovesOfWindows = 100;
// The same for starts without their detours: with fewer moves, annealing does not cover what these have covered.
constexpr double kMovesOfUnrepaired = 250;
// Of a round; for each vertex of the path, because what that leaves uncovered is found in the time of some moves a
// vertex; and one for so many points of the finest raster.
constexpr long kLeastMoves = 5000, kLeastMovesEach = 15;
constexpr double kPointsEach = 20000;
// There are more than kFewRounds only if each vertex gets so many moves in a round: others mend no more than their heat
// spoils. The second round is the first that knows what the raster misses.
constexpr int kFewRounds = 2;
constexpr long kMovesEachOfMore = 40;
constexpr double kShortDetours = 1.3;  // times the path's length, of a path with detours that is worth going on with
// Moves for each square of the tool's width in the target, and in all at most, if the user names no number: half a
// minute, however large the target is.
constexpr double kMovesEach = 4000, kMostMoves = 2e6;
// With fewer for each square where all of the target is asked for, they gain less than a thousandth, and finding what
// the path covers takes as long again: none are made.
constexpr double kFewestMoves = 10;

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

/// Adds points of the outline, at most `spacing` apart, and at least one.
void add_samples(const Polyline& outline, double spacing, std::vector<Point>& to) {
  double since = spacing;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (i > 0) since += distance(outline[i - 1], outline[i]);
    if (since < spacing) continue;
    to.push_back(outline[i]);
    since = 0;
  }
}

/// With more vertices on the edges that pass near one of the targets, so that parts of these edges can be moved.
Polyline divided(const Polyline& points, const std::vector<Point>& targets, double width) {
  const UniformGrid grid(targets.size(), [&](std::size_t k) { return std::array{targets[k]}; });
  Polyline all{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &a = points[i - 1], &b = points[i];
    const auto near = [&](std::uint32_t k) { return distance_to_segment(targets[k], a, b) < width; };
    const bool any = grid.visit_items(std::array{a, b}, width, near);
    const int parts = any ? static_cast<int>(distance(a, b) / width) + 1 : 1;
    for (int k = 1; k < parts; ++k) all.push_back(lerp(a, b, static_cast<double>(k) / parts));
    all.push_back(b);
  }
  return all;
}

double weight_of_time(const Improvement& how) {
  if (how.objective == "weighted") return how.time_weight;
  return how.objective == "time" ? 1 : 0;
}

class Improver {
 public:
  Improver(const Problem& problem, const Improvement& how, Context& context)
      : problem_(problem),
        how_(how),
        context_(context),
        without_(part_named(how.without)),
        completion_(problem, how.coverage, without_),
        walls_(problem.walls()),
        width_(problem.robot().tool_width),
        moves_(moves_in_all(how, problem)),
        turn_(weight_of_time(how) * problem.robot().speed / problem.robot().turn_rate),
        share_(std::max(completion_.allowed() / area(problem.target()),
                        completion_.whole() ? kLeastOfWhole : kLeastUncovered)) {}

  Path run(const std::vector<PathToImprove>& starts) {
    improve(starts);
    context_.record("annealing_moves", effort_.moves);
    context_.record("raster_points", effort_.raster_points);
    context_.record("measured_vertices", effort_.vertices);
    return driven(best_);
  }

 private:
  void improve(const std::vector<PathToImprove>& starts) {
    const bool annealing = !completion_.whole() || moves_each() >= kFewestMoves;
    std::vector<Polyline> lines, whole;
    for (const PathToImprove& start : starts) {
      if (context_.cancelled() && !whole.empty()) break;
      whole.push_back(points_of(start.path));
      if (annealing) lines.push_back(straight(whole.back()));
    }
    // The shortest first: detours make none shorter, and so mostly one has to be completed.
    std::ranges::stable_sort(whole, {}, [this](const Polyline& points) { return cost(points); });
    if (!annealing && std::ranges::all_of(starts, &PathToImprove::complete)) return keep(std::move(whole.front()));
    for (const Polyline& points : whole)
      if (best_.empty() || (!context_.cancelled() && cost(points) < cost(best_)))
        offer(points, context_.cancelled() ? Region{} : uncovered(points));
    if (context_.cancelled() || !annealing) return;
    narrow_ = with_margin(kMargin, kNarrowChord);
    less_narrow_ = with_margin(kFineMargin, Completion::kChord);
    const Polyline best = to_anneal(starts, lines);
    const double used = lines.size() > 1 ? shares().brief * static_cast<double>(lines.size()) : 0;
    const double hot = 1 - used - shares().warming - (without_ == AnnealingPart::closing ? 0 : shares().closing);
    Rng& rng = context_.rng();
    const Annealed now = annealed(best, coarse(), {moves(hot), heat(), warm()}, rng);
    Annealing::Options options = middle();
    options.price = now.price;
    close_in_rounds(annealed(now.points, options, {moves(shares().warming), warm(), kCool * width_}, rng));
  }

  /// What is annealed at length: the best start without its detours, if there is one, or what its brief run has made.
  Polyline to_anneal(const std::vector<PathToImprove>& starts, const std::vector<Polyline>& lines) {
    auto [best, chosen] = lines.size() > 1 ? best_of(lines) : std::pair(lines.front(), std::size_t{0});
    const std::optional<Path>& unrepaired = starts[chosen].unrepaired;
    if (!unrepaired || unrepaired->legs.empty()) return std::move(best);
    return straight(points_of(*unrepaired));
  }
  Polyline straight(const Polyline& points) const { return straightened(points, kStraight * width_, problem_.walls()); }
  /// From the problem's start, and back to it if it is to return.
  Polyline points_of(const Path& path) const {
    Polyline points = vertices_of(path, problem_.start());
    if (how_.return_home) {
      const Polyline home = Connector(problem_).path(points.back(), problem_.start());
      points.insert(points.end(), home.begin() + 1, home.end());
    }
    return points;
  }

  /// Each round allows as much to be uncovered on the raster as leaves what is allowed uncovered in truth. Where hot
  /// annealing has made a good start longer, as it does with lanes that fit their field, the start is annealed cold.
  void close_in_rounds(Annealed now) {
    const bool cold_start = energy(now) >= cost(best_);
    if (cold_start) now = {straight(best_), 0, price(share_)};
    const double margin = cold_start ? 0 : kFineMargin;  // a start's lanes are as far apart as the tool is wide
    const int rounds = without_ == AnnealingPart::closing ? 0 : rounds_of(now);
    double factor = cold_start ? kFirstOfStart : kFirstFactor;
    for (int round = 0; !context_.cancelled(); ++round) {
      now.points = straightened(now.points, kOnChord * width_, problem_.walls());
      if (nearly_all() && without_ != AnnealingPart::walls)
        now.points = walls_.snapped(now.points, kBesideWall * width_);
      // What is uncovered at first is more than detours are good for: annealing covers most of it on less length.
      const bool first = nearly_all() && !cold_start && round == 0 && rounds > 0;
      const double missed = close(now, first ? Detours::left_out : Detours::taken);
      if (round == rounds) return;
      Annealing::Options options = nearly_all() ? raster(fine_cell(), margin) : middle();
      if (round > 0) factor = std::clamp(factor * options.uncovered / missed, kLeastFactor, 1.0);
      options.price = std::min(now.price, kMostPrice * options.price);
      options.uncovered *= factor;
      options.least_shift = kLeastShift;
      options.most_shift = kMostShift;
      const double cold = kCool * math::pow(kCold / kCool, (round + 1.0) / rounds);
      now.points = divided(now.points, focus_, width_);
      now = annealed(now.points, options, {moves(shares().closing / rounds), kCool * width_, cold * width_},
                     context_.rng());
    }
  }
  /// Of closing: a round has at least as many moves as take the time to see what the path leaves uncovered.
  int rounds_of(const Annealed& path) const {
    const double points = area(completion_.target()) / math::pow(fine_cell() * width_, 2);
    const auto rounds = [&](long each) {
      const long least = std::max(
          {kLeastMoves, each * static_cast<long>(path.points.size()), static_cast<long>(points / kPointsEach)});
      return 1 + static_cast<int>(moves(shares().closing) / least);
    };
    return std::min(kMostRounds, std::max(std::min(kFewRounds, rounds(kLeastMovesEach)), rounds(kMovesEachOfMore)));
  }
  double cost(const Polyline& points) const {
    if (turn_ <= 0) return length(points);
    return length(points) + turn_ * turning(straightened(points, kNoTurn * width_, problem_.walls()));
  }
  /// The cost, and what it takes to cover what is uncovered beyond what may be: its price grows as less is left.
  double energy(const Annealed& path) const {
    const double whole = area(completion_.target());
    return cost(path.points) +
           whole * (price_down_to(share_) - price_down_to(std::max(share_, path.uncovered / whole)));
  }
  const Shares& shares() const { return completion_.whole() ? kOfWhole : nearly_all() ? kOfNearlyAll : kOfMost; }
  /// Where everything is asked for, what is too small for the raster needs many detours.
  double fine_cell() const { return completion_.whole() ? kFinestCell : kFineCell; }
  bool nearly_all() const { return share_ < kNearlyAll; }
  /// The first temperature, metres.
  double heat() const {
    if (how_.temperature > 0) return how_.temperature * width_;
    const double times = std::max(std::min(moves_each() / kMovesOfHeat, 1.0), moves_each() / kMovesOfMoreHeat);
    return std::clamp(kHeat * times, kLeastHeat, kMostHeat) * width_;
  }
  /// For each square of the tool's width.
  double moves_each() const { return moves_ * width_ * width_ / area(completion_.target()); }
  double warm() const { return std::clamp(heat(), kCool * width_, kWarm * width_); }
  long moves(double share) const { return static_cast<long>(share * moves_); }
  Annealing::Options coarse() const {
    if (!nearly_all()) return raster(kCoarseCell, 0);
    Annealing::Options options = raster(kLessCoarseCell, kMargin);
    const double left = std::max(kLeastHot, share_);
    options.uncovered = left * area(completion_.target());
    options.price = kHotPrice * price(left);
    return options;
  }
  Annealing::Options middle() const { return raster(kMiddleCell, nearly_all() ? kMargin : 0); }
  Annealing::Options raster(double cell, double margin) const {
    return {.cell = cell * width_,
            .radius = (0.5 - margin) * width_,
            .uncovered = share_ * area(completion_.target()),
            .price = price(share_),
            .turn = turn_,
            .fixed_end = how_.return_home,
            .cut_short = is_wide_tool(problem_.robot()),
            .hot = nearly_all() && moves_each() >= kMovesOfWindows ? kHotOfNearlyAll : kHot,
            .without = without_};
  }
  /// Of uncovered area, where that share of the target stays uncovered.
  double price(double share) const { return kPrice / width_ * math::pow(share / kPriceAt, kPricePower); }
  /// Of all area beyond that share of the target, for each square metre of the target: the integral of price(), less a
  /// constant.
  double price_down_to(double share) const { return -share * price(share) / (1 + kPricePower); }
  Region with_margin(double margin, double chord) const {
    return nearly_all() ? reachable_target(problem_, margin * width_, chord) : Region{};
  }
  const Region& target_of(double radius) const {
    if (radius >= 0.5 * width_) return completion_.target();
    return radius > (0.5 - kMargin) * width_ ? less_narrow_ : narrow_;
  }
  Annealed annealed(const Polyline& points, const Annealing::Options& options, const Annealing::Schedule& schedule,
                    Rng& rng) {
    Annealed now = oxturn::annealed(problem_, target_of(options.radius), points, options, schedule, focus_,
                                    how_.threads, rng, context_);
    effort_ += now.effort;
    return now;
  }
  Region uncovered(const Polyline& points) {
    effort_.vertices += static_cast<double>(points.size());
    return completion_.uncovered(points);
  }

  /// Offers the path. What it leaves uncovered, square metres; it goes on with its detours if `taken` and short.
  enum class Detours { taken, left_out };
  double close(Annealed& path, Detours detours) {
    Region left = uncovered(path.points);
    const double noticed = kNoticed * completion_.allowed(), missed = area(left);
    focus_.clear();
    for (const Polygon& piece : left.polygons)
      if (area(piece) > noticed && without_ != AnnealingPart::focus) add_samples(piece.outer, width_, focus_);
    Polyline whole = offer(path.points, std::move(left));
    if (detours == Detours::taken && length(whole) < kShortDetours * length(path.points))
      path.points = std::move(whole);
    return missed;
  }

  /// Each annealed briefly, by all threads: the best one, and which it is.
  std::pair<Polyline, std::size_t> best_of(const std::vector<Polyline>& lines) {
    std::vector<Annealed> results(lines.size());
    problem_.walls();  // made before threads share it
    const int each = std::max(1, how_.threads / static_cast<int>(lines.size()));
    in_parallel(how_.threads, lines.size(), [&](std::size_t k) {
      Rng rng(mix(context_.seed(), "start " + std::to_string(k)));
      results[k] = oxturn::annealed(problem_, target_of(coarse().radius), lines[k], coarse(),
                                    {moves(shares().brief), heat(), warm()}, focus_, each, rng, context_);
    });
    for (const Annealed& result : results) effort_ += result.effort;
    const auto best = std::ranges::min_element(results, {}, [this](const Annealed& a) { return energy(a); });
    return {std::move(best->points), static_cast<std::size_t>(best - results.begin())};
  }

  /// The path completed, or as it is if cancelled. It is kept if it is the best one so far.
  Polyline offer(const Polyline& points, Region uncovered) {
    Polyline whole = context_.cancelled() ? points : completion_.completed(points, std::move(uncovered), context_);
    if (best_.empty() || (!context_.cancelled() && cost(whole) < cost(best_))) keep(whole);
    return whole;
  }
  void keep(Polyline points) {
    best_ = std::move(points);
    context_.publish(driven(best_));
  }

  const Problem& problem_;
  const Improvement& how_;
  Context& context_;
  const AnnealingPart without_;
  const Completion completion_;
  const WallFollowing walls_;
  double width_, moves_;
  double turn_;                  // metres that a turn by a radian counts
  double share_;                 // of the target that annealing may leave uncovered
  Region narrow_, less_narrow_;  // what the narrower tools can cover
  std::vector<Point> focus_;     // what the last path that was completed left uncovered
  Polyline best_;
  Effort effort_;
};

}  // namespace

const std::vector<Parameter<Improvement>>& improvement_parameters() {
  static const std::vector<Parameter<Improvement>> all{
      {"coverage", &Improvement::coverage, Range{0, 1, true}, "share of the target that is to be covered"},
      {"moves", &Improvement::moves, Range{0, 1e9},
       "moves of annealing; 0: 4000 for each square of the tool's width in the target, 2000000 at most"},
      {"return_home", &Improvement::return_home, "end where the path starts"},
      {"temperature", &Improvement::temperature, Range{0, 10},
       "of annealing, to begin with, in tool widths; 0: 0.006 up to 360 moves for each square of the tool's width, "
       "0.01 from 600 to 2000, and else in proportion to the moves, up to 0.05"},
      {"objective", &Improvement::objective, Choices{"length", "time", "weighted"},
       "what is made least; time: turns count, at the robot's turn rate and speed; weighted: a sum of both"},
      {"time_weight", &Improvement::time_weight, Range{0, 1},
       "of the time's distance at full speed, in the weighted sum; the length counts the rest to 1"},
      {"without", &Improvement::without, Choices(part_names()),
       "a part that is left out, to measure what it is worth: docs/ablation.md"},
      {"threads", &Improvement::threads, Range{1, 256}, "that work at a time; they do not change the path"}};
  return all;
}

PlannerInfo improving_planner(const std::string& name, const std::string& title, const std::string& guarantee) {
  PlannerInfo info;
  info.name = name;
  info.family = "polygon";
  info.title = title;
  info.citation = "oxturn";
  info.capabilities = {Capability::holes, Capability::footprint};
  info.guarantee = guarantee;
  info.promise = Promise::target;
  info.parameters = infos_of(improvement_parameters());
  info.promises_with = [](const Settings& settings) {
    const auto coverage = settings.find("coverage");
    if (coverage == settings.end()) return true;
    const double* share = std::get_if<double>(&coverage->second);
    return share == nullptr || *share >= 1;  // else it is a whole number: 1
  };
  return info;
}

bool is_wide_tool(const Robot& robot) { return robot.tool_width > kWideTool * robot.radius; }

double moves_in_all(const Improvement& how, const Problem& problem) {
  if (how.moves > 0) return how.moves;
  const double width = problem.robot().tool_width;
  return std::min(kMovesEach * area(problem.target()) / (width * width), kMostMoves);
}

bool enough_for_unrepaired(const Improvement& how, const Problem& problem) {
  const double width = problem.robot().tool_width;
  return moves_in_all(how, problem) * width * width >= kMovesOfUnrepaired * area(problem.target());
}

Path improved(const Problem& problem, const std::vector<PathToImprove>& starts, const Improvement& how,
              Context& context) {
  Path path = Improver(problem, how, context).run(starts);
  if (path.legs.empty() && !context.cancelled()) throw Infeasible("from its start the robot reaches nothing to cover");
  return path;
}

}  // namespace oxturn

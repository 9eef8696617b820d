#include "algorithms/smoothing/drivable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "algorithms/drivable_planner.hpp"
#include "algorithms/lanes/uncovered.hpp"
#include "algorithms/smoothing/drivable_visits.hpp"
#include "algorithms/smoothing/link_tour.hpp"

namespace oxturn {
namespace {

constexpr double kMostLeftOut = 0.1;    // of the strokes' length, and if so
constexpr double kMostUncovered = 0.1;  // of the target, more than the planner leaves
constexpr double kNeedless = 5e-4;      // of the target: what may stay uncovered in any case, half of what 0.999 allows
// When time is up: if less of the strokes' length was published, so many links are tried, in about half a second.
constexpr double kFewPublished = 0.5;
constexpr std::size_t kTriedAtLast = 300;
constexpr const char* kDetour = "detour";

double total_length(const std::vector<Stroke>& strokes) {
  double sum = 0;
  for (const Stroke& stroke : strokes) sum += length(stroke.points);
  return sum;
}

/// Strokes left out because the robot does not get there.
class LeftOut {
 public:
  explicit LeftOut(double all) : all_(all) {}
  void add(const Polyline& stroke) {
    if (strokes_.empty()) first_ = stroke.front();
    metres_ += length(stroke);
    strokes_.push_back(stroke);
  }
  double metres() const { return metres_; }
  bool too_many() const { return metres_ > kMostLeftOut * all_; }
  const std::vector<Polyline>& strokes() const { return strokes_; }
  /// `exhausted`: searches ended early.
  Infeasible reason(bool exhausted) const {
    return Infeasible(fmt::format(
        "no drivable connection with a lane at ({:.6g}, {:.6g}){}; take a smaller min_turn_radius, or a robot "
        "that can reverse",
        first_.x(), first_.y(), exhausted ? " found within the effort for detours" : ""));
  }

 private:
  double all_, metres_ = 0;
  Point first_{0, 0};
  std::vector<Polyline> strokes_;
};

/// The strokes of which `link_to(the one before, this one)` is known, and these links; the others go to `left_out`.
template <class LinkTo, class LeftOut>
std::vector<LinkedStroke> assembled(const std::vector<DrivenStroke>& order, LinkTo link_to, LeftOut left_out) {
  std::vector<LinkedStroke> driven;
  const DrivenStroke* last = nullptr;
  for (const DrivenStroke& stroke : order) {
    const std::optional<Curve> link = link_to(last, stroke);
    if (!link) {
      left_out(stroke);
      continue;
    }
    driven.push_back({*link, stroke.points, false});
    last = &stroke;
  }
  return driven;
}

double uncovered_area(const Problem& problem, const Path& path) {
  return area(uncovered(problem.target(), path, problem.robot()));
}

/// Publishes what can be driven so far, if more of the strokes than before, and keeps it: a later order of the strokes
/// may begin with links that are not known yet.
class Progress {
 public:
  /// All references must outlive it.
  Progress(LinkTour& tour, const Problem& problem, const CarSpace& space, Context& context) {
    tour.on_progress([this, &tour, &problem, &space, &context](const std::vector<DrivenStroke>& order) {
      const auto known = [&](const DrivenStroke* last, const DrivenStroke& s) { return tour.known_link(last, s); };
      Path path = path_of(assembled(order, known, [](const DrivenStroke&) {}), problem.start(), space.chord_error());
      const double metres = path.length(true);
      if (metres <= metres_) return;
      context.publish(path);
      best_ = std::move(path);
      metres_ = metres;
    });
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Of strokes, on the best path published.
  double metres() const { return metres_; }
  /// That path, or the other one if it drives as much of the strokes.
  Path best_or(Path other) const { return metres_ > other.length(true) ? best_ : std::move(other); }

 private:
  Path best_;
  double metres_ = 0;
};

void trace_strokes(const std::vector<Stroke>& strokes, Context& context) {
  if (!context.wants_traces()) return;
  std::vector<Polyline> lines;
  for (const Stroke& stroke : strokes) lines.push_back(stroke.points);
  context.trace("strokes", std::move(lines));
}

class Drivable final : public CoveragePlanner {
 public:
  Drivable(std::unique_ptr<CoveragePlanner> inner, DetourSearch search) : inner_(std::move(inner)), search_(search) {}

  Path plan(const Problem& problem, Context& context) const override {
    if (!(problem.robot().min_turn_radius > 0)) return inner_->plan(problem, context);
    Context::Sinks sinks = context.without_promise();
    sinks.publish = {};  // its paths cannot be driven
    Context inner(context.seed(), context.seconds_left(), std::move(sinks));
    return drivable(problem, inner_->plan(problem.turning_on_the_spot(), inner), context, search_);
  }

 private:
  std::unique_ptr<CoveragePlanner> inner_;
  DetourSearch search_;
};

}  // namespace

Path drivable(const Problem& problem, const Path& path, Context& context, DetourSearch search) {
  const CarSpace space(problem, search);
  std::vector<Stroke> strokes = strokes_of(path, problem, space);
  const double all = total_length(strokes);
  LeftOut left_out(all);
  const std::vector<Stroke> whole = strokes;
  shorten_dead_ends(strokes, problem, space);
  for (std::size_t s = 0; s < strokes.size(); ++s)
    if (strokes[s].points.empty()) left_out.add(whole[s].points);
  std::erase_if(strokes, [](const Stroke& stroke) { return stroke.points.empty(); });
  trace_strokes(strokes, context);

  LinkTour tour(strokes, space, problem.start(), context);
  Progress progress(tour, problem, space, context);
  const std::vector<DrivenStroke> order = tour.order();
  // When time is up, strokes behind a link that is not known are lost unless they are reached without a search.
  std::size_t tried = 0;
  const auto link = [&](const DrivenStroke* last, const DrivenStroke& stroke) -> std::optional<Curve> {
    if (!context.cancelled()) return tour.link(last, stroke);
    if (auto known = tour.known_link(last, stroke)) return known;
    if (progress.metres() > kFewPublished * all || tried++ >= kTriedAtLast) return std::nullopt;
    return last ? space.simple_link(last_pose(last->points), first_pose(stroke.points)) : tour.link(last, stroke);
  };
  std::vector<LinkedStroke> driven =
      assembled(order, link, [&](const DrivenStroke& stroke) { left_out.add(stroke.points); });
  if (left_out.metres() > 0) context.record("lanes_left_out_m", left_out.metres());
  if (context.cancelled()) return progress.best_or(path_of(driven, problem.start(), space.chord_error()));
  if (driven.empty() && left_out.too_many()) throw left_out.reason(tour.exhausted());
  if (driven.empty())
    throw Infeasible(fmt::format("no lane that the robot can drive from the start ({:.6g}, {:.6g})",
                                 problem.start().x(), problem.start().y()));
  const double target = area(problem.target());
  const double allowed = std::max(uncovered_area(problem, path), kNeedless * target);
  driven = with_visits(problem, std::move(driven), left_out.strokes(), {.allowed = allowed}, space, context);
  Path result = path_of(driven, problem.start(), space.chord_error());
  if (left_out.too_many() && !context.cancelled() &&
      uncovered_area(problem, result) > allowed + kMostUncovered * target)
    throw left_out.reason(tour.exhausted());
  return result;
}

PlannerInfo drivable_planner(PlannerInfo info) {
  const std::string help = "of a car-like robot where a link is blocked: hybrid A*, or OMPL's random trees";
  info.capabilities.push_back(Capability::curvature);
  // A planner that runs another one has the parameter of that one.
  const bool own = !info.more_parameters;
  if (own) info.parameters.push_back({kDetour, std::string("lattice"), {}, {"lattice", "ompl"}, help});
  const auto rest = [own](Settings settings) {
    if (own) settings.erase(kDetour);
    return settings;
  };
  info.make = [owner = "planner '" + info.name + "'", make = std::move(info.make), own, all = info.parameters, rest](
                  const Settings& settings, const Planners& planners) {
    if (own) checked(owner, all, settings);  // to name all parameters where one is unknown
    auto inner = make(rest(settings), planners);
    const auto search = settings.find(kDetour);
    const bool ompl = search != settings.end() && search->second == Value(std::string("ompl"));
    return std::make_unique<Drivable>(std::move(inner), ompl ? DetourSearch::ompl : DetourSearch::lattice);
  };
  if (info.promises_with)
    info.promises_with = [holds = std::move(info.promises_with), rest](const Settings& settings) {
      return holds(rest(settings));
    };
  return info;
}

}  // namespace oxturn

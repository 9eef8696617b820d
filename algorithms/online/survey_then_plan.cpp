#include "algorithms/online/survey_then_plan.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "algorithms/online/believed_paths.hpp"
#include "algorithms/online/explore.hpp"
#include "algorithms/online/leftover.hpp"

namespace oxturn {
namespace {

constexpr int kMostRefusals = 3;    // motions in a row that cannot even begin
constexpr int kMostSurveys = 3;     // driving the plan may open new rooms
constexpr int kMostHomings = 50;    // attempts to return to the start before planning
constexpr int kMostRepairs = 2000;  // of a planned path that was stopped

/// What a run records.
struct Figures {
  std::optional<double> survey_m, plan_end_m;  // metres driven when the plan was made, and when it had been driven
};

/// One run.
class SurveyThenPlan {
 public:
  SurveyThenPlan(const OfflinePlan& plan, OnlineRobot& robot, Context& context, Figures& figures)
      : plan_(plan), robot_(robot), context_(context), figures_(figures) {}

  void run() {
    drive_along_tether();
    survey();
    if (!return_home() || !make_plan()) return;
    drive_plan();
    cover_leftover();
  }

 private:
  const View& view() const { return robot_.view(); }
  /// False once the run is cancelled, or motion after motion cannot even begin.
  bool active() const { return refusals_ < kMostRefusals && !context_.cancelled(); }
  bool go(const Motion& motion) {
    const double before = view().driven;
    const bool arrived = robot_.go(motion);
    refusals_ = view().driven > before ? 0 : refusals_ + 1;
    return arrived;
  }

  /// There and back. Until the corridor of the tether has been seen, it might seem to lie in another one.
  void drive_along_tether() {
    const Polyline& there = view().path_along_tether;
    if (there.empty() || !active()) return;
    Polyline there_and_back = there;
    there_and_back.insert(there_and_back.end(), there.rbegin() + 1, there.rend());
    go({std::move(there_and_back), true});
  }

  void survey() {
    while (active()) {
      const auto motion = explorer_.next(view());
      if (!motion) return;
      go(*motion);
    }
  }

  bool return_home() {
    for (int homings = 0; active() && !is_home(); ++homings) {
      if (homings == kMostHomings) return false;
      go(homewards());
    }
    return active();
  }

  void drive_plan() {
    for (int surveys = 1; active();) {
      if (!legs_.empty()) {
        Motion leg = std::move(legs_.front());
        legs_.pop_front();
        if (!go(leg) && active()) repair(std::move(leg));
        continue;
      }
      const auto motion = surveys++ < kMostSurveys ? explorer_.next(view()) : std::nullopt;
      if (!motion) break;
      go(*motion);
    }
    figures_.plan_end_m = view().driven;
  }

  void cover_leftover() {
    bool left_home = false;
    while (active()) {
      if (const auto motion = leftover_.next(view())) {
        left_home = true;
        go(*motion);
      } else if (left_home && !is_home()) {
        left_home = false;
        go(homewards());
      } else {
        return;
      }
    }
  }

  /// A robot without a tether is at home everywhere.
  bool is_home() const { return !view().robot.tether || view().pose == view().start; }

  /// Home by the driven path pulled taut, if that is believed free all along; else by the driven path itself. In the
  /// finest world first, because that one contains the driven path.
  Motion homewards() const {
    const Robot& robot = view().robot;
    const double radius = std::max(0.0, robot.radius - 2e-6 * robot.tool_width);  // touching a wall is allowed
    const auto is_free = [&](const Polyline& line) {
      for (std::size_t k = 1; k < line.size(); ++k)
        if (!view().belief.free_for(line[k - 1], line[k], radius)) return false;
      return true;
    };
    for (const int level : {0, 1, Belief::kCoarsest}) {
      const auto believed = believed_problem(view(), view().start, level);
      if (!believed) continue;
      const BelievedPaths paths(*believed, view().path_from_start());
      if (auto path = paths.home(); path && is_free(*path)) return Motion{std::move(*path), true};
    }
    Polyline back = view().path_from_start();
    std::reverse(back.begin(), back.end());
    return Motion{std::move(back), true};
  }

  /// False if the robot does not fit into what is believed.
  bool make_plan() {
    const auto believed = believed_problem(view(), view().base(), 0);
    if (!believed) return false;
    // A context of its own: what it publishes is a plan, not what has been driven.
    Context inner(context_.rng().bits(), context_.seconds_left(), context_.traces_only());
    const Path path = plan_(*believed, inner);
    leftover_.planned(*believed, path);
    if (believed->start() != view().pose) legs_.push_back({{view().pose, believed->start()}, true});
    for (const Leg& leg : path.legs) legs_.push_back({leg.points, leg.tool});
    context_.trace("belief", believed->map().free);
    figures_.survey_m = view().driven;
    return true;
  }

  /// A leg was stopped: replaces the legs by what is free of the rest of it and of the others. With a tether that does
  /// not allow that, nothing is left.
  void repair(Motion stopped) {
    std::deque<Motion> left = std::exchange(legs_, {});
    if (++repairs_ > kMostRepairs) return;
    const auto believed = believed_problem(view(), view().base(), 0);
    if (!believed) return;
    stopped.points.erase(stopped.points.begin(), stopped.points.begin() + static_cast<std::ptrdiff_t>(view().reached));
    left.push_front(std::move(stopped));
    Point from = view().pose;
    Polyline whole;
    for (const Motion& motion : left) {
      Motion part = free_part(*believed, motion, from);
      if (part.points.size() < 2) continue;
      whole.insert(whole.end(), part.points.begin(), part.points.end());
      legs_.push_back(std::move(part));
    }
    const BelievedPaths paths(*believed, view().path_from_base());
    if (!paths.within_tether(whole)) legs_.clear();
  }

  /// The points of the motion that are free, connected by shortest paths. Begins at `from`, which becomes its end.
  static Motion free_part(const Problem& believed, const Motion& motion, Point& from) {
    const EdgeIndex& walls = believed.walls();
    Motion part{{from}, motion.tool};
    for (const Point& to : motion.points) {
      if (walls.contains(from, to)) {
        part.points.push_back(to);
      } else if (walls.contains(to)) {
        const auto path = believed.transit().path(walls.contains(from) ? from : believed.start(), to);
        if (!path) continue;
        part.points.insert(part.points.end(), path->begin(), path->end());
      } else {
        continue;
      }
      from = to;
    }
    return part;
  }

  const OfflinePlan& plan_;
  OnlineRobot& robot_;
  Context& context_;
  Figures& figures_;
  Explorer explorer_;
  Leftover leftover_;
  std::deque<Motion> legs_;  // of the plan, not yet driven
  int refusals_ = 0, repairs_ = 0;
};

/// A planner that gets what has been explored in place of the true problem.
class Surveyed final : public CoveragePlanner {
 public:
  explicit Surveyed(std::unique_ptr<CoveragePlanner> planner) : planner_(std::move(planner)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return plan_online(problem, context,
                       [&](const Problem& believed, Context& inner) { return planner_->plan(believed, inner); });
  }

 private:
  std::unique_ptr<CoveragePlanner> planner_;
};

}  // namespace

Path plan_online(const Problem& truth, Context& context, const OfflinePlan& plan) {
  Figures figures;
  const auto program = [&](OnlineRobot& robot, Context& inner) { SurveyThenPlan(plan, robot, inner, figures).run(); };
  Path path = drive_online(truth, program, context);
  context.record("survey_m", figures.survey_m.value_or(path.length()));
  context.record("leftover_m", figures.plan_end_m ? path.length() - *figures.plan_end_m : 0);
  return path;
}

PlannerInfo with_sensing(PlannerInfo planner) {
  const ParameterInfo sensing{"sensing",
                              std::string("map"),
                              {},
                              {"map", "lidar"},
                              "map: known beforehand; lidar: explored first by the robot's lidar"};
  planner.capabilities.push_back(Capability::online);
  planner.parameters.push_back(sensing);
  planner.make = [make = std::move(planner.make), owner = "planner '" + planner.name + "'", sensing](
                     Settings settings, const Planners& planners) -> std::unique_ptr<CoveragePlanner> {
    const auto given = settings.extract("sensing");
    const bool lidar = given && std::get<std::string>(checked(owner, sensing, given.mapped())) == "lidar";
    auto offline = make(settings, planners);
    if (!lidar) return offline;
    return std::make_unique<Surveyed>(std::move(offline));
  };
  return planner;
}

}  // namespace oxturn

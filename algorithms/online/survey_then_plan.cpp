#include "algorithms/online/survey_then_plan.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "algorithms/online/believed_paths.hpp"
#include "algorithms/online/explore.hpp"
#include "algorithms/online/leftover.hpp"
#include "geometry/trace.hpp"

namespace oxturn {
namespace {

constexpr int kMostSurveys = 3;     // driving the plan may open new rooms
constexpr int kMostHomings = 50;    // attempts to return to the start before planning
constexpr int kMostRepairs = 2000;  // of a planned path that was stopped

/// Each stage hands out motions until it is over, and then sets the next one.
class SurveyThenPlan final : public Policy {
 public:
  explicit SurveyThenPlan(const OfflinePlan& plan) : plan_(plan) {}

  std::optional<Motion> next(const View& view, Context& context) override {
    while (stage_ != Stage::over && !context.cancelled())
      if (auto motion = motion_of_stage(view, context)) return motion;
    return std::nullopt;
  }

  /// Records how long the survey was (with the return to the start), and what came after the plan.
  void record_figures(Context& context, double driven) const {
    context.record("survey_m", planned_ ? survey_m_ : driven);
    context.record("leftover_m", plan_end_m_ ? driven - *plan_end_m_ : 0);
  }

 private:
  enum class Stage { tether, survey, home, plan, drive, leftover, over };

  /// nullopt: the stage is over, and the next one is set.
  std::optional<Motion> motion_of_stage(const View& view, Context& context) {
    switch (stage_) {
      case Stage::tether:
        return along_tether(view);
      case Stage::survey:
        return survey(view);
      case Stage::home:
        return return_home(view);
      case Stage::plan:
        make_plan(view, context);
        return std::nullopt;
      case Stage::drive:
        return drive_plan(view);
      case Stage::leftover:
        return cover_leftover(view);
      case Stage::over:
        break;
    }
    return std::nullopt;
  }
  std::nullopt_t change_to(Stage stage) {
    stage_ = stage;
    return std::nullopt;
  }

  /// There and back. Until the corridor of the tether has been seen, it might seem to lie in another one.
  std::optional<Motion> along_tether(const View& view) {
    stage_ = Stage::survey;
    const Polyline& there = view.path_along_tether();
    if (there.empty()) return std::nullopt;
    Polyline there_and_back = there;
    there_and_back.insert(there_and_back.end(), there.rbegin() + 1, there.rend());
    return Motion{std::move(there_and_back), true};
  }

  std::optional<Motion> survey(const View& view) {
    if (auto motion = explorer_.next(view)) return motion;
    return change_to(Stage::home);
  }

  std::optional<Motion> return_home(const View& view) {
    if (is_home(view)) return change_to(Stage::plan);
    if (++homings_ > kMostHomings) return change_to(Stage::over);
    return homewards(view);
  }

  std::optional<Motion> drive_plan(const View& view) {
    if (view.stopped() && driving_plan_) repair(view);
    driving_plan_ = !legs_.empty();
    if (driving_plan_) {
      current_ = std::move(legs_.front());
      legs_.pop_front();
      return current_;
    }
    if (++surveys_ < kMostSurveys)
      if (auto motion = explorer_.next(view)) return motion;
    plan_end_m_ = view.driven();
    return change_to(Stage::leftover);
  }

  std::optional<Motion> cover_leftover(const View& view) {
    if (auto motion = leftover_.next(view)) {
      left_home_ = true;
      return motion;
    }
    if (!left_home_ || is_home(view)) return change_to(Stage::over);
    left_home_ = false;
    return homewards(view);
  }

  /// A robot without a tether is at home everywhere.
  static bool is_home(const View& view) { return !view.robot().tether || view.pose() == view.start(); }

  /// Home by the driven path pulled taut, if that is believed free all along; else by the driven path itself. In the
  /// finest world first, because that one contains the driven path.
  static Motion homewards(const View& view) {
    const Robot& robot = view.robot();
    const double radius = std::max(0.0, robot.radius - 2e-6 * robot.tool_width);  // touching a wall is allowed
    const auto is_free = [&](const Polyline& line) {
      for (std::size_t k = 1; k < line.size(); ++k)
        if (!view.belief().free_for(line[k - 1], line[k], radius)) return false;
      return true;
    };
    for (const int level : {0, 1, Belief::kCoarsest}) {
      const auto believed = believed_problem(view, view.start(), level);
      if (!believed) continue;
      const BelievedPaths paths(*believed, view.path_from_start());
      if (auto path = paths.home(); path && is_free(*path)) return Motion{std::move(*path), true};
    }
    Polyline back = view.path_from_start();
    std::reverse(back.begin(), back.end());
    return Motion{std::move(back), true};
  }

  void make_plan(const View& view, Context& context) {
    const auto believed = believed_problem(view, view.base(), 0);
    if (!believed) {
      stage_ = Stage::over;
      return;
    }
    // A context of its own: what it publishes is a plan, not what has been driven.
    Context inner(context.rng().bits(), context.seconds_left(), context.traces_only());
    const Path path = plan_(*believed, inner);
    leftover_.planned(*believed, path);
    if (believed->start() != view.pose()) legs_.push_back({{view.pose(), believed->start()}, true});
    for (const Leg& leg : path.legs) legs_.push_back({leg.points, leg.tool});
    context.trace("belief", believed->map().free);
    planned_ = true;
    survey_m_ = view.driven();
    stage_ = Stage::drive;
  }

  /// The last motion was stopped: replaces the legs by what is free of the rest of it and of the legs. With a tether
  /// that does not allow that, nothing is left.
  void repair(const View& view) {
    std::deque<Motion> left{std::move(current_)};
    for (Motion& leg : legs_) left.push_back(std::move(leg));
    legs_.clear();
    if (++repairs_ > kMostRepairs) return;
    const auto believed = believed_problem(view, view.base(), 0);
    if (!believed) return;
    Polyline& stopped = left.front().points;
    stopped.erase(stopped.begin(), stopped.begin() + static_cast<std::ptrdiff_t>(view.reached()));
    Point from = view.pose();
    Polyline whole;
    for (const Motion& motion : left) {
      Motion part = free_part(*believed, motion, from);
      if (part.points.size() < 2) continue;
      whole.insert(whole.end(), part.points.begin(), part.points.end());
      legs_.push_back(std::move(part));
    }
    const BelievedPaths paths(*believed, view.path_from_base());
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
  Explorer explorer_;
  Leftover leftover_;
  Stage stage_ = Stage::tether;
  std::deque<Motion> legs_;  // of the plan, not yet driven
  Motion current_;           // the leg that is being driven
  bool planned_ = false;
  bool driving_plan_ = false;  // the last motion was a leg of the plan
  bool left_home_ = false;     // for what was left over
  double survey_m_ = 0;
  std::optional<double> plan_end_m_;  // metres driven when the plan had been driven
  int surveys_ = 0, homings_ = 0, repairs_ = 0;
};

}  // namespace

Path plan_online(const Problem& truth, Context& context, const OfflinePlan& plan, const OnlineSettings& settings) {
  SurveyThenPlan policy(plan);
  Path path = drive_online(truth, policy, context, settings);
  policy.record_figures(context, path.length());
  return path;
}

}  // namespace oxturn

#include "algorithms/online/survey_then_plan.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "algorithms/online/explore.hpp"
#include "algorithms/online/leftover.hpp"
#include "algorithms/online/believed_paths.hpp"
#include "geometry/trace.hpp"

namespace oxturn {
namespace {

constexpr int kMostSurveys = 3;    // a sweep may open new rooms
constexpr int kMostMended = 2000;  // times that a planned path is joined anew

class SurveyThenPlan final : public Policy {
 public:
  explicit SurveyThenPlan(const OfflinePlan& plan) : plan_(plan) {}

  std::optional<Motion> next(const View& view, Context& context) override {
    for (;;) {
      if (context.cancelled()) return std::nullopt;
      switch (stage_) {
        case Stage::line:
          // Until its line's corridor has been seen, another one may seem to be the way that the string takes.
          stage_ = Stage::survey;
          if (!view.line().empty()) {
            Polyline there_and_back = view.line();
            there_and_back.insert(there_and_back.end(), view.line().rbegin() + 1, view.line().rend());
            return Motion{std::move(there_and_back), true};
          }
          break;
        case Stage::survey:
          if (auto motion = explorer_.next(view)) return motion;
          stage_ = Stage::home;
          break;
        case Stage::home:
          if (!view.robot().tether || view.pose() == view.start()) {
            stage_ = planned_ ? Stage::leftover : Stage::plan;
            break;
          }
          if (++homings_ > 50) return std::nullopt;
          if (auto motion = homewards(view)) return motion;
          return std::nullopt;
        case Stage::plan:
          if (!plan(view, context)) return std::nullopt;
          planned_ = true;
          survey_m_ = view.driven();
          stage_ = Stage::sweep;
          break;
        case Stage::sweep:
          if (view.stopped() && sweeping_) mend(view);
          sweeping_ = !legs_.empty();
          if (!legs_.empty()) {
            Motion motion = std::move(legs_.front());
            legs_.pop_front();
            rest_ = motion;
            return motion;
          }
          if (++surveys_ < kMostSurveys) {
            if (auto motion = explorer_.next(view)) return motion;
          }
          stage_ = Stage::leftover;
          swept_m_ = view.driven();
          break;
        case Stage::leftover:
          if (auto motion = leftover_.next(view)) {
            left_home_ = true;
            return motion;
          }
          if (!left_home_ || !view.robot().tether || view.pose() == view.start()) return std::nullopt;
          left_home_ = false;
          if (auto motion = homewards(view)) return motion;
          return std::nullopt;
      }
    }
  }

  /// Figures of the run: how long the survey was (with the way home), and what came after the plan.
  void report(Context& context, double driven) const {
    context.record("survey_m", planned_ ? survey_m_ : driven);
    context.record("leftover_m", swept_m_ < 0 ? 0 : driven - swept_m_);
  }

 private:
  enum class Stage { line, survey, home, plan, sweep, leftover };

  // Pulled taut if that is free all along; else back by the way that was driven. Finest world first: it holds the way.
  std::optional<Motion> homewards(const View& view) const {
    const Robot& robot = view.robot();
    const double radius = std::max(0.0, robot.radius - 2e-6 * robot.tool_width);
    const auto is_free = [&](const Polyline& line) {
      for (std::size_t k = 1; k < line.size(); ++k)
        if (!view.belief().free_for(line[k - 1], line[k], radius)) return false;
      return true;
    };
    for (const int level : {0, 1, Belief::kCoarsest}) {
      const auto believed = believed_problem(view, view.start(), level);
      if (!believed) continue;
      const BelievedPaths ways(*believed, view.way());
      if (auto way = ways.home(); way && is_free(*way)) return Motion{std::move(*way), true};
    }
    Polyline back = view.way();
    std::reverse(back.begin(), back.end());
    return Motion{std::move(back), true};
  }

  bool plan(const View& view, Context& context) {
    const Point start = view.robot().tether ? view.start() : view.pose();
    const auto believed = believed_problem(view, start, 0);
    if (!believed) return false;
    // Its own context: what it publishes is a plan, not what has been driven.
    Context::Sinks sinks;
    if (context.wants_traces()) sinks.trace = [&](const Trace& trace) { context.trace(trace.name, trace.lines); };
    Context inside(context.rng().bits(), context.seconds_left(), sinks);
    const Path path = plan_(*believed, inside);
    leftover_.planned(*believed, path);
    if (believed->start() != view.pose()) legs_.push_back({{view.pose(), believed->start()}, true});
    for (const Leg& leg : path.legs) legs_.push_back({leg.points, leg.tool});
    context.trace("belief", believed->map().free);
    return true;
  }

  // The last motion was stopped: what is left of it and of the legs, as far as it is free.
  void mend(const View& view) {
    std::deque<Motion> left{std::move(rest_)};
    for (Motion& leg : legs_) left.push_back(std::move(leg));
    legs_.clear();
    if (++mended_ > kMostMended) return;
    const auto believed = believed_problem(view, view.robot().tether ? view.start() : view.pose(), 0);
    if (!believed) return;
    const BelievedPaths ways(*believed, view.robot().tether ? view.way() : Polyline{view.pose()});
    const EdgeIndex& walls = believed->walls();
    Polyline& stopped = left.front().points;
    stopped.erase(stopped.begin(), stopped.begin() + static_cast<std::ptrdiff_t>(view.reached()));
    Point from = view.pose();
    Polyline whole;
    for (const Motion& motion : left) {
      Motion part{{from}, motion.tool};
      for (const Point& to : motion.points) {
        if (walls.contains(from, to)) {
          part.points.push_back(to);
        } else if (walls.contains(to)) {
          const auto way = believed->transit().path(walls.contains(from) ? from : believed->start(), to);
          if (!way) continue;
          part.points.insert(part.points.end(), way->begin(), way->end());
        } else {
          continue;
        }
        from = to;
      }
      if (part.points.size() < 2) continue;
      whole.insert(whole.end(), part.points.begin(), part.points.end());
      legs_.push_back(std::move(part));
    }
    if (!ways.holds(whole)) legs_.clear();
  }

  const OfflinePlan& plan_;
  Explorer explorer_;
  Leftover leftover_;
  Stage stage_ = Stage::line;
  std::deque<Motion> legs_;
  Motion rest_;
  bool planned_ = false, sweeping_ = false, left_home_ = false;
  double survey_m_ = 0, swept_m_ = -1;
  int surveys_ = 0, homings_ = 0, mended_ = 0;
};

}  // namespace

Path plan_online(const Problem& truth, Context& context, const OfflinePlan& plan, const OnlineSettings& settings) {
  SurveyThenPlan policy(plan);
  Path path = drive_online(truth, policy, context, settings);
  policy.report(context, path.length());
  return path;
}

}  // namespace oxturn

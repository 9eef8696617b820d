#include "bench/check/subject.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "bench/verdict.hpp"
#include "metrics/score.hpp"

namespace oxturn {
namespace {

/// The least share of what it promises that a planner must cover: walls are traced by polygons.
constexpr double kKept = 0.99;

/// A planner that does in its process what the check wants.
class Staged final : public CoveragePlanner {
 public:
  Staged(std::unique_ptr<CoveragePlanner> planner, const PlanRequest& request)
      : planner_(std::move(planner)), request_(request) {}
  Path plan(const Problem& problem, Context& context) const override {
    return request_.how(*planner_, problem, context);
  }

 private:
  std::unique_ptr<CoveragePlanner> planner_;
  const PlanRequest& request_;
};

}  // namespace

Robot check_robot(double scale) {
  Robot robot;
  robot.radius = 0.2 * scale;
  robot.tool_width = 0.4 * scale;
  return robot;
}

bool same_path(const Path& a, const Path& b) {
  const auto same = [](const Leg& x, const Leg& y) {
    return x.tool == y.tool && x.gear == y.gear && x.points == y.points;
  };
  return std::equal(a.legs.begin(), a.legs.end(), b.legs.begin(), b.legs.end(), same);
}

const Problem& CheckSubject::problem(const std::string& name) { return take(problems_.get(name, tethered())); }

const Problem& CheckSubject::take(const Problem& problem) {
  last_ = problem;
  if (const std::string missing = missing_capability(planner_, problem); !missing.empty()) throw CheckSkipped(missing);
  return *last_;
}

Planned CheckSubject::plan(const Problem& problem, const PlanRequest& request) const {
  IsolationOptions options;
  options.limits.wall_s = request.wall_s > 0 ? request.wall_s : options_.wall_s;
  options.seed = request.seed;
  options.traces = request.traces;
  const auto make = [&]() -> std::unique_ptr<CoveragePlanner> {
    auto planner = planner_.make(request.settings, registry_.planners);
    if (!request.how) return planner;
    return std::make_unique<Staged>(std::move(planner), request);
  };
  return plan_isolated(make, problem, options);
}

std::string CheckSubject::must_be_valid(const Problem& problem, const Planned& planned) const {
  const std::string on = fmt::format("on '{}': ", problem.map().name);
  if (planned.outcome == Outcome::infeasible)
    return planner_.promise == Promise::target
               ? fmt::format("{}says infeasible ({}), but it promises to cover the target", on, planned.reason)
               : "";
  if (planned.outcome != Outcome::ok) return fmt::format("{}{}: {}", on, to_text(planned.outcome), planned.reason);
  // Whether the tether is long enough is a check of its own.
  const std::string flaw = find_flaw(problem, *planned.path, {.tether_counts = false});
  return flaw.empty() ? "" : fmt::format("{}invalid: {}", on, flaw);
}

std::string CheckSubject::must_keep_promise(const Problem& problem, const Planned& planned) const {
  if (std::string wrong = must_be_valid(problem, planned); !wrong.empty() || !planned.path) return wrong;
  ScoreOptions options = score_options(planned, planner_.promised({}), false);
  if (options.promise == Promise::nothing) return "";
  const auto kept = score(problem, *planned.path, options).value("promise_coverage");
  if (!kept || *kept >= kKept) return "";
  return fmt::format("on '{}': covers {:.4f} of what it promises ({})", problem.map().name, *kept,
                     to_text(options.promise));
}

}  // namespace oxturn

// Deadline and cancel are obeyed, refusals are honest.
#include <fmt/format.h>

#include "bench/check/subject.hpp"

namespace oxturn {
namespace {

// Coarse, so that a busy machine does not matter: planners that poll end within milliseconds.
constexpr double kDeadline = 3;  // seconds
constexpr double kSoon = 0.6;    // of the deadline

const Problem& large(CheckSubject& subject) {
  return subject.problem(subject.planner().has(Capability::holes) ? "rooms:2" : "symmetries");
}

/// Whether the runner had to end it: only a plan() that comes back is timed.
bool goes_on(const Planned& planned) { return planned.outcome == Outcome::timeout && planned.wall_s == 0; }

std::string deadline(CheckSubject& subject) {
  const Problem& problem = large(subject);
  const Planned planned = subject.plan(problem, {.wall_s = kDeadline});
  if (goes_on(planned))
    return fmt::format("on '{}': goes on after its deadline ({})", problem.map().name, planned.reason);
  if (planned.outcome == Outcome::timeout) return "";  // it came back in time and said that it has no path
  return subject.must_be_valid(problem, planned);
}

std::string cancel(CheckSubject& subject) {
  if (subject.is_program()) throw CheckSkipped("a program is not told; it is ended");
  const Problem& problem = large(subject);
  const auto cancelled = [](const CoveragePlanner& planner, const Problem& given, Context& context) {
    context.cancel();
    return planner.plan(given, context);
  };
  const Planned planned = subject.plan(problem, {.wall_s = kDeadline, .how = cancelled});
  if (goes_on(planned) || planned.wall_s > kSoon * kDeadline)
    return fmt::format("on '{}': goes on after it was cancelled", problem.map().name);
  const bool has_none = planned.outcome == Outcome::infeasible || planned.outcome == Outcome::timeout;
  if (has_none) return "";  // so far
  return subject.must_be_valid(problem, planned);
}

/// A room that every planner can enter. (Maps in which no robot fits never reach a planner.)
std::string honest_refusal(CheckSubject& subject) {
  const Problem& problem = subject.problem("room");
  const Planned planned = subject.plan(problem);
  if (planned.outcome == Outcome::infeasible)
    return fmt::format("says infeasible on a plain room: {}", planned.reason.empty() ? "no reason" : planned.reason);
  if (planned.outcome == Outcome::unsupported)
    return fmt::format("says unsupported on a plain room: {}", planned.reason.empty() ? "no reason" : planned.reason);
  return subject.must_be_valid(problem, planned);
}

/// Where the robot can hardly move, a planner drives or says that it cannot; it returns nothing empty or invalid.
std::string infeasible(CheckSubject& subject) {
  const Problem& problem = subject.problem("no room to move");
  const Planned planned = subject.plan(problem);
  if (planned.outcome != Outcome::infeasible) return subject.must_be_valid(problem, planned);
  return planned.reason.empty() ? "says infeasible without a reason" : "";
}

}  // namespace

PlannerChecks limit_checks() {
  return {{"deadline", "ends by its deadline", deadline},
          {"cancel", "ends soon after it was cancelled, with a valid path, a refusal or nothing", cancel},
          {"refusal", "does not refuse a plain room", honest_refusal},
          {"infeasible", "says infeasible where it can do nothing", infeasible}};
}

}  // namespace oxturn

/// What a check is given: the planner, problems, and a process for each plan. Internal to bench/check.
///
///   std::string same_seed(CheckSubject& subject) {
///     const Problem& problem = subject.problem("rooms");
///     return subject.must_be_valid(problem, subject.plan(problem));       // "": passed
///   }
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/check/check.hpp"
#include "bench/isolate.hpp"

namespace oxturn {

/// Thrown by a check that does not apply; says why.
struct CheckSkipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One plan, other than by the default.
struct PlanRequest {
  Settings settings = {};
  std::uint64_t seed = 1;
  double wall_s = 0;  // 0: the limit of the checks
  bool traces = false;
  /// What is done in the planner's process; by default planner.plan(problem, context).
  std::function<Path(const CoveragePlanner& planner, const Problem& problem, Context& context)> how = {};
};

/// Problems by name, built when they are asked for the first time.
class CheckProblems {
 public:
  explicit CheckProblems(const Generators& generators) : generators_(generators) {}
  const Problem& get(const std::string& name, bool tether);

 private:
  const Generators& generators_;
  std::map<std::string, Problem> built_;
};

class CheckSubject {
 public:
  CheckSubject(const PlannerInfo& planner, const Registry& registry, const CheckOptions& options,
               CheckProblems& problems)
      : planner_(planner), registry_(registry), options_(options), problems_(problems) {}

  const PlannerInfo& planner() const { return planner_; }
  const Registry& registry() const { return registry_; }
  double wall_s() const { return options_.wall_s; }
  bool is_program() const { return planner_.is_program; }
  /// A planner that plans for tethers is checked with one.
  bool tethered() const { return planner_.has(Capability::tether); }
  /// Of check_problems(). Throws CheckSkipped if the planner lacks a capability that it needs.
  const Problem& problem(const std::string& name);
  /// The same for a problem that a check has made itself.
  const Problem& take(const Problem& problem);
  /// The problem that was taken last: the one that a failure is about.
  const std::optional<Problem>& last_problem() const { return last_; }

  Planned plan(const Problem& problem, const PlanRequest& request = {}) const;
  /// Why this is neither a valid path nor a refusal that the planner may give; "" if it is. Whoever promises to cover
  /// the target may not refuse, since each of the problems can be solved.
  std::string must_be_valid(const Problem& problem, const Planned& planned) const;
  /// The same, and what was promised is covered.
  std::string must_keep_promise(const Problem& problem, const Planned& planned) const;

 private:
  const PlannerInfo& planner_;
  const Registry& registry_;
  const CheckOptions& options_;
  CheckProblems& problems_;
  std::optional<Problem> last_;
};

/// Equal to the last bit.
bool same_path(const Path& a, const Path& b);
/// The robot of most problems: radius 0.2 m and tool 0.4 m, times `scale`.
Robot check_robot(double scale = 1);

/// One entry of the list of checks.
struct PlannerCheck {
  std::string name, title;
  std::function<std::string(CheckSubject&)> run;  // why it failed, or ""; throws CheckSkipped
};
using PlannerChecks = std::vector<PlannerCheck>;

// One file each.
PlannerChecks hostile_checks();   // a valid path on each problem of the corpus
PlannerChecks repeat_checks();    // same bytes whatever else happens
PlannerChecks symmetry_checks();  // what it declares of transformed problems
PlannerChecks limit_checks();     // deadline, cancel, refusals
PlannerChecks effect_checks();    // nothing printed, written or disturbed
PlannerChecks ability_checks();   // declared capabilities, parameters, promise
PlannerChecks all_checks();

}  // namespace oxturn

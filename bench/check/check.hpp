/// The conformance checks: what every planner must do, and what this one says that it does.
///
///   PlannerChecker checker(registry);
///   for (const CheckResult& result : checker.check(registry.planners.find("stc")))
///     fmt::print("{} {}: {}\n", to_text(result.status), result.check, result.reason);
///
/// Every plan is made in a process of its own under limits, as in a suite. A planner that takes milliseconds is checked
/// in a second or two.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/registry.hpp"

namespace oxturn {

/// A check that a planner is known to fail, and why. It counts as a failure when it starts to pass.
struct ExpectedFailure {
  std::string planner, check, reason;
};
/// Those of the planners that come with oxturn.
const std::vector<ExpectedFailure>& built_in_expected_failures();

struct CheckOptions {
  double wall_s = 20;                          // limit of each plan
  std::vector<std::string> only;               // names of checks; empty: all
  std::vector<ExpectedFailure> expected = {};  // besides the built-in ones
  std::string problems_folder = {};            // takes the problem of each failed check, CHECK.geojson; empty: none
};

enum class CheckStatus { passed, failed, skipped, expected_failure };
std::string to_text(CheckStatus status);

struct CheckResult {
  std::string check, title;  // "same-seed", "same seed, same bytes"
  CheckStatus status = CheckStatus::passed;
  std::string reason;  // one sentence; empty if passed
};

/// The names of all checks, in their order.
std::vector<std::string> check_names();

/// Keeps the problems, so that checking many planners builds each once. `registry` must outlive it.
class PlannerChecker {
 public:
  explicit PlannerChecker(const Registry& registry, CheckOptions options = {});
  ~PlannerChecker();
  PlannerChecker(const PlannerChecker&) = delete;
  /// One result for each check, in the order of the list. The planner is one of the registry. Throws
  /// std::invalid_argument for a name in `only` or `expected` that is no check. The caller must be single-threaded.
  std::vector<CheckResult> check(const PlannerInfo& planner);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace oxturn

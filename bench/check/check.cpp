#include "bench/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/files.hpp"
#include "base/text.hpp"
#include "bench/check/subject.hpp"
#include "maps/formats.hpp"

namespace oxturn {

PlannerChecks all_checks() {
  PlannerChecks all;
  for (const auto& part :
       {repeat_checks(), hostile_checks(), symmetry_checks(), limit_checks(), effect_checks(), ability_checks()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const PlannerCheck& check : all_checks()) names.push_back(check.name);
  return names;
}

std::string to_text(CheckStatus status) {
  switch (status) {
    case CheckStatus::passed:
      return "passed";
    case CheckStatus::failed:
      return "failed";
    case CheckStatus::skipped:
      return "skipped";
    case CheckStatus::expected_failure:
      return "expected failure";
  }
  throw std::logic_error("a status without a name");
}

const std::vector<ExpectedFailure>& built_in_expected_failures() {
  static const std::vector<ExpectedFailure> all{
      {"beachbot", "parameters", "as published it connects elements without regard to walls"}};
  return all;
}

struct PlannerChecker::Impl {
  const Registry& registry;
  CheckOptions options;
  PlannerChecks checks;
  CheckProblems problems{registry.generators};

  const ExpectedFailure* expected(const std::string& planner, const std::string& check) const {
    for (const auto* list : {&options.expected, &built_in_expected_failures()})
      for (const ExpectedFailure& failure : *list)
        if (failure.planner == planner && failure.check == check) return &failure;
    return nullptr;
  }

  CheckResult run(const PlannerCheck& check, CheckSubject& subject) const {
    CheckResult result{check.name, check.title, CheckStatus::passed, ""};
    try {
      result.reason = check.run(subject);
      if (!result.reason.empty()) result.status = CheckStatus::failed;
    } catch (const CheckSkipped& e) {
      result.status = CheckStatus::skipped;
      result.reason = e.what();
    }
    return result;
  }

  /// An expected failure is none; one that does not come is.
  void compare(const ExpectedFailure& failure, CheckResult& result) const {
    if (result.status == CheckStatus::failed) {
      result.status = CheckStatus::expected_failure;
      result.reason = fmt::format("{} ({})", failure.reason, result.reason);
    } else if (result.status == CheckStatus::passed) {
      result.status = CheckStatus::failed;
      result.reason =
          fmt::format("passed, but is listed as an expected failure: {}; remove it from the list", failure.reason);
    }
  }

  void keep_problem(const std::string& check, const CheckSubject& subject) const {
    if (options.problems_folder.empty() || !subject.last_problem()) return;
    write_file(fmt::format("{}/{}.geojson", options.problems_folder, check), to_geojson(*subject.last_problem()));
  }
};

PlannerChecker::PlannerChecker(const Registry& registry, CheckOptions options)
    : impl_(new Impl{registry, std::move(options), all_checks()}) {
  const auto known = check_names();
  const auto require_known = [&](const std::string& name) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw std::invalid_argument(unknown_name("check", name, known));
  };
  for (const std::string& name : impl_->options.only) require_known(name);
  for (const ExpectedFailure& failure : impl_->options.expected) require_known(failure.check);
}

PlannerChecker::~PlannerChecker() = default;

std::vector<CheckResult> PlannerChecker::check(const PlannerInfo& planner) {
  const auto& only = impl_->options.only;
  std::vector<CheckResult> results;
  for (const PlannerCheck& check : impl_->checks) {
    if (!only.empty() && std::find(only.begin(), only.end(), check.name) == only.end()) continue;
    CheckSubject subject(planner, impl_->registry, impl_->options, impl_->problems);
    CheckResult result = impl_->run(check, subject);
    if (const ExpectedFailure* failure = impl_->expected(planner.name, check.name)) impl_->compare(*failure, result);
    if (result.status == CheckStatus::failed) impl_->keep_problem(check.name, subject);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace oxturn

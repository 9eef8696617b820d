// The conformance checks find what is planted, and nothing in the planners that come with oxturn.
#include "bench/check/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

#include "bench/process_info.hpp"
#include "faulty_planners.hpp"
#include "reports/built_in_registry.hpp"
#include "tests/support/brief_planners.hpp"

namespace oxturn {
namespace {

using testing::faulty_registry;
using ::testing::HasSubstr;
using testing::planted_faults;
using ::testing::ThrowsMessage;

std::vector<CheckResult> checked_with(const std::string& planner, CheckOptions options, double wall_s = 60) {
  options.wall_s = wall_s;
  return PlannerChecker(faulty_registry(), std::move(options)).check(faulty_registry().planners.find(planner));
}

TEST(Check, EachPlantedFaultIsFoundAndNamed) {
  for (const auto& [planner, check] : planted_faults()) {
    SCOPED_TRACE(planner);
    const auto results = checked_with(planner, {.only = {check}}, 5);
    ASSERT_EQ(results.size(), 1u);
    EXPECT_EQ(to_text(results[0].status), "failed") << check << ": " << results[0].reason;
    EXPECT_NE(results[0].reason, "");
  }
  EXPECT_TRUE(children_of(::getpid()).empty());
}

// As one test for each check, so that a fault is not found by a check that finds everything.
TEST(Check, TheSamePlannerWithoutAFaultPasses) {
  std::set<std::string> planted;
  for (const auto& fault : planted_faults()) planted.insert(fault.check);
  for (const CheckResult& result : checked_with("good", {})) {
    EXPECT_TRUE(result.status == CheckStatus::passed || result.status == CheckStatus::skipped)
        << result.check << ": " << result.reason;
    EXPECT_TRUE(planted.count(result.check) > 0) << "no fault for " << result.check;
  }
}

TEST(Check, AnExpectedFailureIsNoneUntilItPasses) {
  const auto prints = checked_with("prints", {.only = {"no-output"}, .expected = {{"prints", "no-output", "verbose"}}});
  EXPECT_EQ(prints[0].status, CheckStatus::expected_failure);
  EXPECT_THAT(prints[0].reason, HasSubstr("verbose (on 'pillar': prints 13 bytes"));
  const auto good = checked_with("good", {.only = {"no-output"}, .expected = {{"good", "no-output", "verbose"}}});
  EXPECT_EQ(good[0].status, CheckStatus::failed);
  EXPECT_THAT(good[0].reason, HasSubstr("passed, but is listed as an expected failure: verbose"));
}

TEST(Check, UnknownChecksAreRefused) {
  EXPECT_THAT([] { checked_with("good", {.only = {"same-sed"}}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("did you mean 'same-seed'?")));
}

// --- all that come with oxturn -------------------------------------------------------------------------------

constexpr std::size_t kGroups = 4;
class BuiltInCheck : public ::testing::TestWithParam<std::size_t> {};

TEST_P(BuiltInCheck, HasNoFailure) {
  const Registry registry = built_in_registry();
  PlannerChecker checker(registry, {.wall_s = 60, .only = {}});  // of a machine that does other work, too
  for (std::size_t i = GetParam(); i < registry.planners.size(); i += kGroups) {
    SCOPED_TRACE(registry.planners[i].name);
    for (const CheckResult& result : checker.check(brief(registry.planners[i])))
      EXPECT_NE(result.status, CheckStatus::failed) << result.check << ": " << result.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Groups, BuiltInCheck, ::testing::Range(std::size_t{0}, kGroups));

}  // namespace
}  // namespace oxturn

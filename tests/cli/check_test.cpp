// oxturn check: table, JSON, exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kLanes = "check --exec 'python3 " OXTURN_SOURCE_DIR "/docs/planners/lanes.py' ";

TEST(CheckCommand, AProgramIsCheckedAsBuiltInPlannersAre) {
  const Said said = oxturn(kLanes + "zigzag --only same-seed --only tether");
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, AllOf(HasSubstr("zigzag\n  same-seed  passed"), HasSubstr("lanes\n  same-seed  passed"),
                              HasSubstr("tether     skipped           it does not declare this"),
                              HasSubstr("1 passed, 0 failed, 1 skipped, 0 expected failures")));
}

TEST(CheckCommand, AFailureIsExitCodeOneAndItsProblemCanBePlanned) {
  const Folder folder;
  const Said said =
      oxturn(kLanes + "--only one-cell --expect one-cell='too small' --json --problems '" + (folder / "failed") + "'");
  EXPECT_EQ(said.code, 1) << said.err;
  const auto checks = nlohmann::json::parse(said.out).at(0).at("checks");
  EXPECT_EQ(checks.at(0).at("status"), "failed");
  EXPECT_THAT(checks.at(0).at("reason").get<std::string>(), HasSubstr("listed as an expected failure: too small"));
  EXPECT_EQ(oxturn("plan zigzag '" + (folder / "failed/one-cell.geojson") + "'").code, 0);
}

TEST(CheckCommand, ACrashIsAFailureWithItsCause) {
  const Said said = oxturn("check --exec 'python3 " OXTURN_SOURCE_DIR "/tests/cli/dies.py' --only refusal");
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, HasSubstr("it printed last 'ZeroDivisionError"));
}

TEST(CheckCommand, BadArgumentsAreOneSentence) {
  for (const auto& [arguments, sentence] :
       {std::pair("check", "no planner to check"),
        {"check stcc", "no planner 'stcc'; did you mean 'stc'?"},
        {"check stc --only same-sed", "no check 'same-sed'; did you mean 'same-seed'?"},
        {"check stc --problems /proc/none", "--problems: cannot make '/proc/none': No such file or directory"},
        {"check stc --expect same-seed", "--expect 'same-seed': expected name=value"}}) {
    const Said said = oxturn(arguments);
    EXPECT_EQ(said.code, 2) << arguments;
    EXPECT_EQ(said.err_lines(), 1) << said.err;
    EXPECT_THAT(said.err, HasSubstr(sentence));
  }
}

}  // namespace
}  // namespace oxturn

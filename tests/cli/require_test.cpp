// oxturn run --require: exit codes for continuous integration.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;

/// Exit code of a suite of one run, with `--require REQUIRED` (nothing if it is empty).
Said run_of(const std::string& suite_keys, const std::string& robot_keys, const std::string& required) {
  const Folder out;
  const std::string suite = out.write(
      "s.toml", "schema = 1\nname = \"s\"\n" + suite_keys + "[robots.disc]\nradius = 0.2\ntool_width = 0.4\n" +
                    robot_keys + "[[maps]]\ngenerator = \"rectangle\"\n[[planners]]\nname = \"zigzag\"\n");
  return oxturn("run " + suite + " -q --no-pictures -o " + (out / "r") +
                (required.empty() ? "" : " --require " + required));
}

TEST(Require, TheWorstOutcomeSetsTheExitCode) {
  const std::string tether = "tether = { length = 3.0 }\n";  // which zigzag cannot mind
  struct Case {
    std::string suite, robot, outcome;
    int any, partial, ok;
  };
  for (const Case& c : {Case{"", "", "ok", 0, 0, 0}, Case{"target_coverage = 1\n", "", "partial", 0, 0, 1},
                        Case{"", tether, "unsupported", 0, 1, 1}}) {
    SCOPED_TRACE(c.outcome);
    EXPECT_EQ(run_of(c.suite, c.robot, "").code, c.any);
    EXPECT_EQ(run_of(c.suite, c.robot, "partial").code, c.partial);
    const Said ok = run_of(c.suite, c.robot, "ok");
    EXPECT_EQ(ok.code, c.ok);
    const std::string sentence = c.ok == 1 ? "oxturn: zigzag on rectangle-1: " + c.outcome + ": " : "";
    EXPECT_THAT(ok.err, HasSubstr(sentence));
    EXPECT_THAT(ok.err, HasSubstr(c.ok == 1 ? "oxturn: 1 of 1 runs are not ok\n" : ""));
  }
}

TEST(Require, AnythingElseIsRefused) { EXPECT_EQ(run_of("", "", "perfect").code, 2); }

}  // namespace
}  // namespace oxturn

// Planners that are programs, on the command line. Those of docs/planners are run as they stand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "base/csv.hpp"
#include "bench/results.hpp"
#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kLanes = "--exec 'python3 " OXTURN_SOURCE_DIR "/docs/planners/lanes.py' ";
const std::string kWalk = "--exec " OXTURN_WALK " ";

TEST(Exec, TheProgramIsThePlannerOfAPlan) {
  for (const char* map : {"rooms:2", "clutter:3", "cave:1"}) {
    for (const std::string& exec : {kLanes, kWalk}) {
      const Said said = oxturn("plan " + exec + map + " --json");
      SCOPED_TRACE(exec + map + said.err);
      ASSERT_EQ(said.code, 0) << said.out;  // a valid path
      EXPECT_GT(nlohmann::json::parse(said.out).at("metrics").at("coverage").get<double>(), 0.8);
    }
  }
}

TEST(Exec, SettingsAreThoseThatItDescribes) {
  const Said said = oxturn("plan " + kLanes + "rectangle --set spacing=0.5 --set walls=no");
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("lanes[spacing=0.5;walls=false]"));
  const Said refused = oxturn("plan " + kLanes + "rectangle --set spacing=5");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("parameter 'spacing' of planner 'lanes' is 5, expected a number from 0.1 to 1"));
}

TEST(Exec, AnotherPlannerCanRunIt) {
  const Said said = oxturn("plan leashed rooms:7 " + kLanes + "--set planner=lanes --robot tether=20 --wall 300");
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("leashed[planner=lanes"));
}

TEST(Exec, WhatItPrintsIsShown) {
  const Said said = oxturn("plan --exec 'python3 " OXTURN_SOURCE_DIR "/tests/cli/dies.py' rectangle");
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.err, AllOf(HasSubstr("Traceback"), HasSubstr("ZeroDivisionError")));
  EXPECT_THAT(said.out + said.err, HasSubstr("exited with code 1; it printed last 'ZeroDivisionError"));
}

TEST(Exec, BadCommandsAreOneSentence) {
  for (const char* command : {"plan --exec no-such-program rectangle", "list planners --exec no-such-program",
                              "run quick -o out --exec no-such-program"}) {
    const Said said = oxturn(command);
    EXPECT_EQ(said.code, 2) << command;
    EXPECT_EQ(said.err_lines(), 1) << said.err;
    EXPECT_THAT(said.err, HasSubstr("`no-such-program --describe` exited with code 127; it printed last"));
  }
  EXPECT_THAT(oxturn("plan stc").err, HasSubstr("MAP is missing. See `oxturn plan --help`"));
  EXPECT_THAT(oxturn("plan").err, HasSubstr("PLANNER is missing"));
}

// Whoever presses Ctrl-C while a program plans leaves nothing behind.
TEST(Exec, AnInterruptEndsTheProgram) {
  const std::string mark = "interrupted-" + std::to_string(::getpid());
  const std::string program = "python3 " OXTURN_SOURCE_DIR "/tests/cli/waits.py " + mark;
  const std::string command =
      std::string("timeout -s INT 2 '") + OXTURN_PROGRAM + "' plan --exec '" + program + "' rectangle >/dev/null 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_NE(std::system(("pgrep -f '[i]" + mark.substr(1) + "' >/dev/null").c_str()), 0);
}

TEST(Exec, ListsShowItBesideTheOthers) {
  const Said said = oxturn("list planners " + kLanes + kWalk + "--json");
  EXPECT_EQ(said.code, 0) << said.err;
  const auto all = nlohmann::json::parse(said.out);
  EXPECT_EQ(all.at(all.size() - 2).at("name"), "lanes");
  EXPECT_EQ(all.back().at("name"), "walk");
  EXPECT_EQ(all.back().at("origin"), OXTURN_WALK);
  EXPECT_EQ(all.back().at("family"), "external");
}

TEST(Exec, RunsStandBesideTheOthers) {
  const Folder folder;
  const std::string suite = folder.write("mine.toml", R"(schema = 1
name = "mine"
[robots.disc]
radius = 0.2
tool_width = 0.4
[[maps]]
generator = "rooms"
seeds = [1, 2]
[[planners]]
name = "zigzag"
[[planners]]
name = "lanes"
spacing = 0.8
)");
  const Said said = oxturn("run '" + suite + "' -o '" + (folder / "out") + "' -q -j 2 " + kLanes + kWalk);
  ASSERT_EQ(said.code, 0) << said.err;
  const Results results = read_results(folder / "out");
  std::vector<std::string> variants;
  for (const Row& row : results.rows) {
    variants.push_back(row.get("variant"));
    EXPECT_THAT(row.get("outcome"), ::testing::AnyOf("ok", "partial")) << row.get("reason");
    EXPECT_GT(row.number("plan_cpu_s").value_or(0), 0);
  }
  const std::vector<std::string> expected{"zigzag", "lanes[spacing=0.8]", "walk",
                                          "zigzag", "lanes[spacing=0.8]", "walk"};
  EXPECT_EQ(variants, expected);
  EXPECT_THAT(content(folder / "out/session.json"), AllOf(HasSubstr("lanes.py"), HasSubstr("\"identity\"")));
  EXPECT_THAT(content(folder / "out/metrics.csv"), HasSubstr("lanes"));
}

}  // namespace
}  // namespace oxturn

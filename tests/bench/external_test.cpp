// External planners: a good conversation, and every bad one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "base/files.hpp"
#include "bench/external_conversation.hpp"
#include "bench/external_planner.hpp"
#include "bench/isolate.hpp"
#include "bench/process_info.hpp"
#include "bench/run_id.hpp"
#include "bench/run_suite.hpp"
#include "bench/verdict.hpp"
#include "reports/built_in_registry.hpp"
#include "test_planners.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using testing::Folder;
using ::testing::HasSubstr;
using testing::small_problem;
using ::testing::ThrowsMessage;

const std::string kZoo = "python3 " OXTURN_SOURCE_DIR "/tests/bench/external_zoo.py ";

IsolationOptions limits(double wall_s = 60) {
  IsolationOptions options;
  options.limits = {.wall_s = wall_s, .cpu_s = 0, .memory_mb = 600};
  options.seed = 17;
  return options;
}

Planned converse(const std::string& command, const IsolationOptions& options = limits()) {
  static const Problem problem = small_problem();
  return plan_isolated(
      [&] {
        return converse_with({command}, {{"speed", 2.5}, {"name", std::string("x")}});
      },
      problem, options);
}

Planned zoo(const std::string& mode, const IsolationOptions& options = limits()) {
  const Planned planned = converse(kZoo + mode, options);
  EXPECT_TRUE(children_of(::getpid()).empty()) << mode << " left something running";
  return planned;
}

/// With more and more time, until there is enough of it for the program's start on this machine.
template <class Enough>
Planned zoo_until(const std::string& mode, Enough enough) {
  Planned planned;
  for (double wall_s = 0.5; wall_s <= 32; wall_s *= 2) {
    planned = zoo(mode, limits(wall_s));
    if (enough(planned)) break;
  }
  return planned;
}

double figure(const Planned& planned, const std::string& name) {
  for (const auto& [known, value] : planned.records)
    if (known == name) return value;
  ADD_FAILURE() << "no figure " << name;
  return 0;
}

TEST(External, TheGoodOneIsScored) {
  const Planned planned = zoo("good");
  EXPECT_EQ(planned.outcome, Outcome::ok) << planned.reason;
  const Score scored = score(small_problem(), *planned.path, built_in_registry().metrics, {});
  EXPECT_EQ(judge(scored, 0.98).outcome, Outcome::ok) << judge(scored, 0.98).reason;
  EXPECT_GT(planned.wall_s, 0);
}

TEST(External, ThePlannerIsToldEverythingAndIsHeard) {
  IsolationOptions options = limits(40);
  options.traces = true;
  const Planned planned = zoo("echo", options);
  EXPECT_EQ(planned.outcome, Outcome::ok) << planned.reason;
  EXPECT_EQ(figure(planned, "seed"), 17);
  EXPECT_EQ(figure(planned, "wall_s"), 38);  // the deadline that built-in planners have, too
  EXPECT_EQ(figure(planned, "settings"), 2);
  EXPECT_EQ(figure(planned, "robot_radius"), 0.2);
  EXPECT_EQ(figure(planned, "start_x"), 0.21);
  EXPECT_NEAR(figure(planned, "configuration_space_x"), 2.8, 1e-6);
  EXPECT_NEAR(figure(planned, "target_x"), 3, 1e-6);
  ASSERT_EQ(planned.traces.size(), 1u);
  EXPECT_EQ(planned.traces[0].name, "lanes");
  ASSERT_TRUE(planned.promised);
  EXPECT_NEAR(area(*planned.promised), area(small_problem().target()), 1e-6);
}

/// What becomes of a mode: its outcome, and a regular expression for the reason.
struct Expected {
  const char *mode, *outcome, *reason;
};
constexpr Expected kEnding[] = {
    {"exit_at_once", "error", "^`python3 .*` ended without an answer$"},
    {"no_ready", "error", "^line 1 of `python3 .*` is not .\"ready\": true.; it begins '.\"path\": "},
    {"chatty", "error", "^line 1 of `.*` is not JSON; it begins 'Loading the model \\.\\.\\.'$"},
    {"traceback", "error", "exited with code 1; it printed last 'KeyError: 'robot''$"},
    {"close_input", "ok", "^$"},
    {"garbage", "error", "^line 2 of `.*` is not JSON; it begins 'my path is ready'$"},
    {"nan", "error", "^line 2 of `.*` is not JSON; it begins"},
    {"infinite", "error", "^line 2 of `.*` is not JSON; it begins"},
    {"list", "error", "^line 2 of `.*` has none of the members path, error, publish.*; it begins '\\[1, 2\\]'$"},
    {"unknown_member", "error", "has none of the members path, error, publish"},
    {"two_members", "error", "^line 2 of `.*` has more than one member; it begins"},
    {"wrong_type", "error",
     "^line 2 of `.*`: path: type is \"LineString\", expected FeatureCollection; the line begins"},
    {"one_point", "error",
     "path: feature 1, coordinates is .*, expected a list of at least two points; the line begins"},
    {"no_tool", "error", "path: feature 1, properties has no tool, expected true or false"},
    {"null_path", "error", "^line 2 of `.*`: path is null, expected"},
    {"text_coordinates", "error", "path: feature 1, point 1 is \\[\"a\",\"b\"\\], expected"},
    {"deep", "error", "is not JSON; it begins '\\[\\[\\["},
    {"bytes", "error", "^line 2 of `.*` is not JSON; it begins"},
    {"bad_record", "error", "^line 2 of `.*`: a recorded figure is named 'My Figure'"},
    {"record_text", "error", "record, rounds is \"many\", expected a finite number"},
    {"progress_over", "error", "progress is 50, expected a number from 0 to 1"},
    {"bad_trace", "error", "trace, lines, line 1, point 1 is 0, expected"},
    {"bad_publish", "error", "^line 2 of `.*`: publish is \\[\\], expected an object"},
    {"bad_promise", "error", "^line 2 of `.*`: promise is a Point, expected a Polygon or MultiPolygon"},
    {"infeasible", "infeasible", "^the door is too narrow$"},
    {"unsupported", "unsupported", "^no rectangles$"},
    {"failed", "error", "^`.*` failed: no licence$"},
    {"no_reason", "infeasible", "^it gave no reason$"},
    {"bad_error", "error", "error is \"oops\", expected one of: infeasible, unsupported, failed; the line begins"},
    {"empty_path", "ok", "^$"},  // judged by its score: invalid
    {"through_wall", "ok", "^$"},
    {"no_end", "error", "ended without an answer; its last line has no end and begins '.\"path\""},
    {"half_line", "error", "ended without an answer; its last line has no end and begins '.\"path\""},
    {"publish_then_die", "crash", "^`.*` was killed by SIGSEGV \\(segmentation fault\\)"},
    {"publish_then_exit", "error", "^`.*` exited with code 3; it printed last 'out of ideas'$"},
    {"allocate", "out_of_memory", "needs more than 600 MB"},
    {"endless_line", "error|out_of_memory",
     "^line 2 of `.*` is longer than 256 MB; it begins 'xxx|needs more than 600 MB"},
    {"long_reason", "error", "failed: x+"},
    {"children", "ok", "^$"},
    {"child_holds_output", "error", "ended without an answer"},
    {"lingers", "ok", "^$"},
    {"talks_on", "ok", "^$"},
};

TEST(External, EachBadPlannerCostsOneRowWithItsOutcome) {
  for (const Expected& expected : kEnding) {
    SCOPED_TRACE(expected.mode);
    const Planned planned = zoo(expected.mode);
    EXPECT_THAT(to_text(planned.outcome), ContainsRegex(std::string("^(") + expected.outcome + ")$")) << planned.reason;
    EXPECT_THAT(planned.reason, ContainsRegex(expected.reason));
    EXPECT_EQ(planned.path.has_value(), planned.outcome == Outcome::ok);
  }
}

TEST(External, ThoseThatNeverEndTimeOut) {
  for (const char* mode : {"no_answer", "spin", "endless_lines", "endless_errors"}) {
    SCOPED_TRACE(mode);
    const Planned planned = zoo_until(mode, [](const Planned& p) { return p.reason.starts_with("no result"); });
    EXPECT_EQ(planned.outcome, Outcome::timeout);
    EXPECT_FALSE(planned.path);
  }
  // 95 % of the time: the rest must be enough to answer on this machine.
  const std::string sentence = "did not print {\"ready\": true} within ";
  const Planned silent =
      zoo_until("silent", [&](const Planned& p) { return p.reason.find(sentence) != std::string::npos; });
  EXPECT_EQ(silent.outcome, Outcome::timeout);
  EXPECT_THAT(silent.reason, HasSubstr(sentence));
}

// Without a shell that holds the output open.
TEST(External, OneThatClosesItsOutputIsNotWaitedFor) {
  const Planned planned = converse("exec " + kZoo + "closes_output");
  EXPECT_EQ(planned.outcome, Outcome::error);
  EXPECT_THAT(planned.reason, HasSubstr("closed its output without an answer, and did not end"));
}

TEST(External, APublishedPathSurvivesTheTimeout) {
  for (const char* mode : {"publish_then_wait", "ignore_signals"}) {
    const Planned planned = zoo_until(mode, [](const Planned& p) { return p.path.has_value(); });
    EXPECT_EQ(planned.outcome, Outcome::timeout) << planned.reason;
    ASSERT_TRUE(planned.path) << mode;
    EXPECT_GT(planned.path->length(), 10);
  }
}

// Processor time does not depend on how busy the machine is.
TEST(External, TheClockStartsWithTheProblem) {
  const Planned slow = zoo("slow_start");  // works for 0.5 s before it is ready, as does a child of it
  EXPECT_EQ(slow.outcome, Outcome::ok);
  EXPECT_LT(slow.cpu_s, 0.4);
  const Planned burn = zoo("burn");  // works for 0.3 s after that
  EXPECT_GE(burn.cpu_s, 0.29);
  EXPECT_GE(burn.wall_s, 0.29);
}

TEST(External, MemoryIsThatOfTheProgram) {
  EXPECT_GT(zoo("large").peak_rss_bytes, 100e6);
  const double small = zoo("burn").peak_rss_bytes;
  EXPECT_GT(small, 1e6);
  EXPECT_LT(small, 90e6);
}

TEST(External, WarmUpsAreConversationsOfTheirOwn) {
  IsolationOptions options = limits();
  options.warm_ups = 2;
  EXPECT_EQ(zoo("good", options).outcome, Outcome::ok);
}

TEST(External, AMissingCommandIsSaid) {
  const Planned planned = converse("no-such-program-anywhere");
  EXPECT_EQ(planned.outcome, Outcome::error);
  EXPECT_EQ(planned.exit_code, 127);
  EXPECT_THAT(planned.reason,
              ContainsRegex("exited with code 127; it printed last '.*no-such-program-anywhere: not found'"));
}

// --- descriptions --------------------------------------------------------------------------------------------

/// A command that describes itself by this text.
std::string describing(const Folder& folder, const std::string& text) {
  write_file(folder.file("description.json"), text);
  return "cat '" + folder.file("description.json") + "';:";
}

TEST(ExternalDescription, EveryMemberArrives) {
  const Folder folder;
  const PlannerInfo info = external_planner({describing(folder, R"({"oxturn": 1, "name": "my-planner", "family": "grid",
      "title": "t", "citation": "c", "guarantee": "g", "promise": "target", "capabilities": ["holes", "tether"],
      "version": "7", "parameters": [
        {"name": "d", "type": "number", "default": 1, "least": 0.5, "most": 2, "help": "metres"},
        {"name": "n", "type": "whole number", "default": 3},
        {"name": "b", "type": "yes/no", "default": true},
        {"name": "t", "type": "text", "default": "x", "choices": ["x", "y"]}]})")});
  EXPECT_EQ(info.name, "my-planner");
  EXPECT_EQ(info.family, "grid");
  EXPECT_EQ(info.title + info.citation + info.guarantee, "tcg");
  EXPECT_EQ(info.promise, Promise::target);
  EXPECT_TRUE(info.has(Capability::tether) && info.has(Capability::holes) && !info.has(Capability::footprint));
  ASSERT_EQ(info.parameters.size(), 4u);
  EXPECT_EQ(info.parameters[0].fallback, Value(1.0));
  EXPECT_EQ(info.parameters[0].range.most, 2);
  EXPECT_EQ(info.parameters[1].fallback, Value(std::int64_t{3}));
  EXPECT_EQ(info.parameters[2].fallback, Value(true));
  EXPECT_EQ(info.parameters[3].choices, (Choices{"x", "y"}));
  EXPECT_THAT(
      [&] {
        info.make({{"d", 9.0}}, Planners("planner"));
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("parameter 'd' of planner 'my-planner' is 9")));
}

TEST(ExternalDescription, EachMistakeIsOneSentenceThatNamesCommandAndMember) {
  const std::map<std::string, std::string> mistakes{
      {"hello", "printed 'hello', expected one JSON object"},
      {"", "printed '', expected one JSON object"},
      {"[1]", "is [1], expected an object"},
      {R"({"ready": true})", "has no member 'oxturn', expected 1"},
      {R"({"oxturn": 2, "name": "x"})", "member 'oxturn' is 2, expected 1"},
      {R"({"oxturn": 1})", "has no member 'name'"},
      {R"({"oxturn": 1, "name": "My Planner"})", "member 'name' is \"My Planner\", expected at most 64"},
      {R"({"oxturn": 1, "name": "*"})", "member 'name' is \"*\""},
      {R"({"oxturn": 1, "name": 3})", "member 'name' is 3, expected a string"},
      {R"({"oxturn": 1, "name": "x", "titel": "t"})", "has an unknown member 'titel'; expected: oxturn, name, family"},
      {R"({"oxturn": 1, "name": "x", "promise": "all"})",
       "member 'promise' is \"all\", expected one of: target, cells"},
      {R"({"oxturn": 1, "name": "x", "capabilities": ["fly"]})", "is \"fly\", expected one of: tether, holes"},
      {R"({"oxturn": 1, "name": "x", "capabilities": ["online"]})", "is given the whole map"},
      {R"({"oxturn": 1, "name": "x", "parameters": {}})", "member 'parameters' is {}, expected a list"},
      {R"({"oxturn": 1, "name": "x", "parameters": [{"name": "a"}]})", "parameter 1 has no member 'type'"},
      {R"({"oxturn": 1, "name": "x", "parameters": [{"name": "a", "type": "float", "default": 1}]})",
       "member 'type' is \"float\", expected one of: yes/no, whole number, number, text"},
      {R"({"oxturn": 1, "name": "x", "parameters": [{"name": "a", "type": "number", "default": "1"}]})",
       "parameter 1, member 'default' is \"1\", expected a finite number"},
      {R"({"oxturn": 1, "name": "x", "parameters": [{"name": "a", "type": "number", "default": 1, "most": 0}]})",
       "the default of parameter 'a' of planner 'x' is 1"},
      {R"({"oxturn": 1, "name": "x", "parameters": [{"name": "a", "type": "text", "default": "1", "most": 0}]})",
       "expected none: only numbers have a range"},
      {R"({"oxturn": 1, "name": "x", "parameters": [{"name": "exec", "type": "text", "default": "1"}]})",
       "suites have a key of this one"},
      {R"({"oxturn": 1, "name": "x", "parameters": [{"name": "a", "type": "text", "default": "1"},
           {"name": "a", "type": "text", "default": "2"}]})",
       "two parameters 'a'"}};
  const Folder folder;
  for (const auto& [text, sentence] : mistakes) {
    SCOPED_TRACE(text);
    const std::string command = describing(folder, text);
    const auto refused = [&] { external_planner({command}); };
    EXPECT_THAT(refused,
                ThrowsMessage<std::invalid_argument>(::testing::AllOf(HasSubstr("`cat '"), HasSubstr(sentence))));
  }
}

TEST(ExternalDescription, BadProgramsAreOneSentence) {
  const std::map<std::string, std::string> commands{{"exit 3;:", "`exit 3;: --describe` exited with code 3"},
                                                    {"kill -9 $$;:", "was killed by SIGKILL"},
                                                    {"no-such-program", "exited with code 127; it printed last"},
                                                    {"yes;:", "prints more than a megabyte"},
                                                    {"cat", "exited with code 1; it printed last"}};
  for (const auto& [text, sentence] : commands) {
    const ShellCommand command{text};
    EXPECT_THAT([&] { external_planner(command); }, ThrowsMessage<std::invalid_argument>(HasSubstr(sentence)));
  }
  EXPECT_TRUE(children_of(::getpid()).empty());
}

TEST(ExternalDescription, IdentityFollowsTheCommandItsFilesAndTheDescription) {
  const Folder folder;
  const std::string plain = R"({"oxturn": 1, "name": "x"})";
  const auto identity = [&](const std::string& command) { return external_planner({command, folder.path()}).identity; };
  write_file(folder.file("a b.json"), plain);
  const std::string first = identity("cat 'a b.json';:");
  EXPECT_EQ(first, identity("cat 'a b.json';:"));
  EXPECT_NE(first, identity("cat 'a b.json'; :"));
  write_file(folder.file("a b.json"), plain + "\n");  // the same description by another file
  EXPECT_NE(first, identity("cat 'a b.json';:"));
  write_file(folder.file("a b.json"), plain);
  EXPECT_EQ(first, identity("cat 'a b.json';:"));
}

TEST(ExternalDescription, OneNameIsOnePlanner) {
  const Folder folder;
  Planners planners("planner");
  write_file(folder.file("a"), R"({"oxturn": 1, "name": "x"})");
  write_file(folder.file("b"), R"({"oxturn": 1, "name": "x", "version": "2"})");
  EXPECT_EQ(add_external_planner(planners, {"cat a;:", folder.path()}), "x");
  EXPECT_EQ(add_external_planner(planners, {"cat a;:", folder.path()}), "x");
  EXPECT_EQ(planners.size(), 1u);
  EXPECT_THAT(
      [&] {
        add_external_planner(planners, {"cat b;:", folder.path()});
      },
      ThrowsMessage<std::invalid_argument>(
          HasSubstr("`cat b;:` describes itself as 'x', but there is another planner of that name, `cat a;:`")));
}

// --- in suites -----------------------------------------------------------------------------------------------

constexpr const char* kSuite = R"(schema = 1
name = "mine"
[robots.disc]
radius = 0.2
tool_width = 0.4
[[maps]]
generator = "rectangle"
width = 6
height = 4
[[planners]]
name = "zigzag"
[[planners]]
exec = "python3 lanes.py"
spacing = [0.8, 0.9]
)";

TEST(ExternalInSuites, ACommandIsStartedInTheSuitesFolderAndAnotherVersionIsNotResumed) {
  const Folder folder;
  const std::string program = read_file(OXTURN_SOURCE_DIR "/docs/planners/lanes.py");
  write_file(folder.file("lanes.py"), program);
  write_file(folder.file("suite.toml"), kSuite);
  const Registry registry = built_in_registry();
  SuiteRunOptions options;
  options.folder = folder.file("out");
  options.progress = options.pictures = false;
  const auto run = [&] { return run_suite(read_suite(folder.file("suite.toml"), registry), registry, options); };
  const Results results = run();
  ASSERT_EQ(results.rows.size(), 3u);
  EXPECT_EQ(results.rows[1].get("variant"), "lanes[spacing=0.8]");
  EXPECT_EQ(results.rows[2].get("variant"), "lanes");
  EXPECT_EQ(results.rows[2].get("planner_family"), "external");
  for (const Row& row : results.rows) EXPECT_EQ(row.outcome(), Outcome::ok) << row.get("reason");
  options.resume = true;
  EXPECT_EQ(run().rows[2].get("run_id"), results.rows[2].get("run_id"));

  write_file(folder.file("lanes.py"), program + "\n# changed\n");
  EXPECT_THAT(run, ThrowsMessage<std::invalid_argument>(
                       HasSubstr("holds results of another version of planner 'lanes': `python3 lanes.py`")));
  options.folder = folder.file("other");
  options.resume = false;
  const Results changed = run();
  EXPECT_EQ(changed.rows[0].get("run_id"), results.rows[0].get("run_id"));
  EXPECT_NE(changed.rows[2].get("run_id"), results.rows[2].get("run_id"));
  EXPECT_EQ(changed.rows[2].get("path_sha256"), results.rows[2].get("path_sha256"));
}

TEST(ExternalInSuites, MistakesNameTheLine) {
  const Folder folder;
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& sentence) {
    std::string text = kSuite;
    text.replace(text.find(from), from.size(), to);
    write_file(folder.file("suite.toml"), text);
    EXPECT_THAT([&] { read_suite(folder.file("suite.toml"), built_in_registry()); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(sentence)));
  };
  write_file(folder.file("lanes.py"), read_file(OXTURN_SOURCE_DIR "/docs/planners/lanes.py"));
  refused("exec = \"python3 lanes.py\"", "exec = \"exit 4;:\"",
          "suite.toml:13: `exit 4;: --describe` exited with code 4");
  refused("exec = \"python3 lanes.py\"", "exec = 3", "suite.toml:13: exec is not a text in quotes");
  refused("spacing = [0.8, 0.9]", "spacing = 3", "suite.toml:14: parameter 'spacing' of planner 'lanes' is 3");
  refused("spacing = [0.8, 0.9]", "name = \"lanes\"", "exec stands beside name");
}

// A planner that runs another one: the identity of that one is part of the run's.
TEST(ExternalInSuites, AnInnerPlannerCounts) {
  const Folder folder;
  Planners planners = built_in_planners();
  write_file(folder.file("a"), R"({"oxturn": 1, "name": "x", "capabilities": ["holes"]})");
  add_external_planner(planners, {"cat a;:", folder.path()});
  const PlannerInfo& leashed = planners.find("leashed");
  EXPECT_EQ(identified(leashed, {{"planner", std::string("stc")}}, planners), "leashed");
  EXPECT_EQ(identified(leashed, {{"planner", std::string("x")}}, planners), "leashed " + planners.find("x").identity);
}

}  // namespace
}  // namespace oxturn

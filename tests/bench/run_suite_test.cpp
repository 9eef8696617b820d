#include "bench/run_suite.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/sha256.hpp"
#include "bench/build_info.hpp"
#include "bench/registry.hpp"
#include "maps/path_file.hpp"
#include "metrics/score.hpp"
#include "reports/built_in_registry.hpp"
#include "test_planners.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

using testing::Folder;
using ::testing::HasSubstr;
using testing::test_registry;
using ::testing::ThrowsMessage;

Suite rectangles(const std::vector<std::string>& hows, int maps = 1) {
  Suite suite;
  suite.name = "test, of \"quotes\"";
  suite.limits = {.wall_s = 60, .memory_mb = 2000};  // enough on a slow machine, and under a sanitizer
  suite.robots.push_back(Robot{});
  for (int i = 0; i < maps; ++i) {
    MapSpec map;
    map.generator = "rectangle";
    map.settings = {{"width", 3.0 + i}, {"height", 2.0}};
    suite.maps.push_back(map);
  }
  for (const std::string& how : hows) suite.planners.push_back({"test", {{"how", how}}});
  return suite;
}

SuiteRunOptions into(const std::string& folder, int jobs = 1, bool resume = false) {
  SuiteRunOptions options;
  options.folder = folder;
  options.jobs = jobs;
  options.resume = resume;
  options.progress = false;
  return options;
}

/// That the file of a path names.
MapFile problem_of(const std::string& path_file) {
  return load_map(read_path_file(path_file).problem.value(), path_file, built_in_generators(), built_in_map_formats());
}

const Columns& all_columns() {
  static const Columns all = run_columns(built_in_metrics());
  return all;
}

// Every cell but those of timing columns.
std::string untimed(const Results& results) {
  std::string text;
  for (const Row& row : results.rows) {
    for (const Column& c : all_columns()) {
      if (!c.timing) text += row.get(c.name) + "|";
    }
    text += "\n";
  }
  return text;
}

TEST(SuiteRun, APathFileScoresAsTheRowSays) {
  const Folder folder;
  const Results results = run_suite(rectangles({"good"}), test_registry(), into(folder.file("out")));
  const Row& row = results.rows.at(0);
  const std::string file = folder.file("out/" + row.get("path_file"));
  const auto [path, made_for] = read_path_file(file);
  ASSERT_TRUE(made_for);
  const MapFile map = problem_of(file);
  const Problem problem(map.map, *map.robot, map.start, map.anchor);
  EXPECT_EQ("../maps/" + problem.content_hash() + ".geojson", made_for->source.file);
  const Score again = score(problem, path);
  EXPECT_EQ(again.flaw, "");
  for (const MetricValue& metric : again.values) EXPECT_EQ(row.number(metric.name), metric.value) << metric.name;
  EXPECT_EQ(row.get("path_sha256"), sha256(to_geojson(path)));
  EXPECT_EQ(row.get("map_sha256"), content_hash(map.map));
}

TEST(SuiteRun, StoresPathFilesOfAnySize) {
  const Folder folder;
  const Results results = run_suite(rectangles({"long_file"}), test_registry(), into(folder.file("out")));
  const Row& row = results.rows.at(0);
  EXPECT_EQ(row.get("outcome"), "partial") << row.get("reason");
  EXPECT_GT(std::filesystem::file_size(folder.file("out/" + row.get("path_file"))), std::uintmax_t{64} << 20);
  EXPECT_NEAR(row.number("path_m").value(), std::hypot(0.9, 0.4), 1e-6);
}

TEST(SuiteRun, WithoutScoringThereIsTimeAndNothingElse) {
  const Folder folder;
  Suite suite = rectangles({"good", "throw"});
  suite.scoring = false;
  const Results results = run_suite(suite, test_registry(), into(folder.file("out")));
  ASSERT_EQ(results.rows.size(), 2u);
  EXPECT_EQ(results.rows[0].outcome(), Outcome::ok);
  EXPECT_TRUE(results.rows[0].number("plan_cpu_s"));
  EXPECT_FALSE(results.rows[0].number("coverage"));
  EXPECT_EQ(results.rows[0].get("path_file"), "");
  EXPECT_EQ(results.rows[1].outcome(), Outcome::error);
}

TEST(SuiteRun, SameRowsWhateverTheJobsAndAgain) {
  const std::vector<std::string> hows{"random", "good", "partial", "null", "throw", "wall"};
  for (const int maps : {1, 3}) {
    Suite suite = rectangles(hows, maps);
    suite.repeats = 2;
    const Folder folder;
    const std::string one = untimed(run_suite(suite, test_registry(), into(folder.file("1"), 1)));
    EXPECT_EQ(one, untimed(run_suite(suite, test_registry(), into(folder.file("2"), 2))));
    EXPECT_EQ(one, untimed(run_suite(suite, test_registry(), into(folder.file("3"), 5))));
    EXPECT_EQ(one, untimed(run_suite(suite, test_registry(), into(folder.file("4"), 1))));
    EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), static_cast<long>(hows.size()) * maps * 2);
  }
}

TEST(SuiteRun, RepeatsDifferInLuckVariantsShareIt) {
  const Folder folder;
  Suite suite = rectangles({"random"});
  suite.planners.push_back({"test", {{"how", "random"}, {"amount", 1.0}}});
  suite.repeats = 2;
  const auto rows = run_suite(suite, test_registry(), into(folder.file("out"))).rows;
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_NE(rows[0].get("seed"), rows[1].get("seed"));
  EXPECT_NE(rows[0].get("path_sha256"), rows[1].get("path_sha256"));
  EXPECT_EQ(rows[0].get("path_sha256"), rows[2].get("path_sha256"));
  EXPECT_NE(rows[0].get("run_id"), rows[2].get("run_id"));
}

TEST(SuiteRun, ResumeAfterACutDoesOnlyTheRest) {
  const Suite suite = rectangles({"good", "random", "null", "partial"}, 2);
  const Folder folder;
  const std::string out = folder.file("out");
  const std::string whole = untimed(run_suite(suite, test_registry(), into(out)));
  const std::string text = read_file(out + "/runs.csv");
  std::size_t third = 0;
  for (int i = 0; i < 4; ++i) third = text.find('\n', third) + 1;
  for (const std::size_t cut :
       {text.size(), text.size() - 1, third, third + 20, csv_header(all_columns()).size(), std::size_t{5}}) {
    SCOPED_TRACE(cut);
    write_file(out + "/runs.csv", text.substr(0, cut));
    EXPECT_EQ(untimed(run_suite(suite, test_registry(), into(out, 2, true))), whole);
    const std::string now = read_file(out + "/runs.csv");
    // Rows that were whole are kept to the byte, timing and all; that is only the case if they were not run again.
    const std::size_t kept = text.rfind('\n', cut - 1);
    if (kept != std::string::npos && cut > csv_header(all_columns()).size()) {
      EXPECT_EQ(now.substr(0, kept), text.substr(0, kept));
    }
  }
}

// What the settings at hand promise, which may differ from what the planner's defaults do.
TEST(SuiteRun, RowsSayWhatIsPromised) {
  const Folder folder;
  Suite suite = rectangles({});
  suite.limits = {.wall_s = 20, .memory_mb = 2000};
  suite.planners = {{"stc", {{"partial", true}}}, {"wavefront", {{"stop", std::string("closed")}}}};
  const Results results = run_suite(suite, built_in_registry(), into(folder.file("out")));
  EXPECT_EQ(results.rows[0].get("promise"), "cells");
  EXPECT_GT(std::stod(results.rows[0].get("promise_coverage")), 0.999);
  EXPECT_EQ(results.rows[1].get("promise"), "nothing");
  EXPECT_EQ(results.rows[1].get("promise_coverage"), "");
}

// metrics.csv: what planners report of themselves, in suite order, whatever the jobs; nobody reports, no file.
TEST(SuiteRun, KeepsWhatPlannersReport) {
  const Folder folder;
  const Suite suite = rectangles({"report", "good"}, 3);
  std::string expected = "run_id,metric,value\n";
  for (const Row& row : run_suite(suite, test_registry(), into(folder.file("1"))).rows)
    if (row.get("variant").find("report") != std::string::npos)
      for (const char* line : {"laps,4", "share,0.25", "nothing,"}) expected += row.get("run_id") + "," + line + "\n";
  EXPECT_EQ(read_file(folder.file("1/metrics.csv")), expected);
  run_suite(suite, test_registry(), into(folder.file("2"), 3));
  EXPECT_EQ(read_file(folder.file("2/metrics.csv")), expected);

  const std::string rows = read_file(folder.file("1/runs.csv"));
  std::size_t two = 0;
  for (int i = 0; i < 3; ++i) two = rows.find('\n', two) + 1;
  write_file(folder.file("1/runs.csv"), rows.substr(0, two));
  write_file(folder.file("1/metrics.csv"), expected.substr(0, expected.size() - 3));  // cut off as well
  run_suite(suite, test_registry(), into(folder.file("1"), 2, true));
  EXPECT_EQ(read_file(folder.file("1/metrics.csv")), expected);

  run_suite(rectangles({"good"}), test_registry(), into(folder.file("3")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("3/metrics.csv")));
}

TEST(SuiteRun, ResumeRetriesCancelledAndInfrastructure) {
  const Suite suite = rectangles({"good", "null", "partial"});
  const Folder folder;
  const std::string out = folder.file("out");
  run_suite(suite, test_registry(), into(out));
  Results results = read_results(out);
  std::string text = csv_header(all_columns());
  for (Row& row : results.rows) {
    if (row.get("params") == "how=good") row.cells.set("outcome", "cancelled");
    if (row.get("params") == "how=partial") row.cells.set("outcome", "infrastructure");
    text += csv_line(row, all_columns());
  }
  write_file(out + "/runs.csv", text);
  const Results again = run_suite(suite, test_registry(), into(out, 1, true));
  ASSERT_EQ(again.rows.size(), 3u);
  EXPECT_EQ(again.rows[0].outcome(), Outcome::ok);
  EXPECT_EQ(again.rows[0].get("attempt"), "2");
  EXPECT_EQ(again.rows[1].get("attempt"), "1");
  EXPECT_EQ(again.rows[2].outcome(), Outcome::partial);
  EXPECT_EQ(parse_csv(read_file(out + "/runs.csv"), "t").size(), 1u + 5u);  // one row an attempt
}

// A suite that has gained a planner and a map: what was there stays as it is, only the rest is run.
TEST(SuiteRun, ResumeExtendsAFolder) {
  const Folder folder;
  const std::string out = folder.file("out");
  run_suite(rectangles({"good"}), test_registry(), into(out));
  const std::string before = read_file(out + "/runs.csv");
  Suite larger = rectangles({"good", "partial"});
  larger.maps.push_back(larger.maps[0]);
  larger.maps.back().name = "another";
  larger.maps.back().seed = 2;
  const Results results = run_suite(larger, test_registry(), into(out, 1, true));
  EXPECT_EQ(results.rows.size(), larger.maps.size() * 2);
  const std::string after = read_file(out + "/runs.csv");
  std::size_t kept = 0, begin = before.find('\n') + 1;
  for (std::size_t end; (end = before.find('\n', begin)) != std::string::npos; begin = end + 1, ++kept)
    EXPECT_THAT(after, HasSubstr(before.substr(begin, end + 1 - begin)));
  EXPECT_EQ(kept, larger.maps.size() - 1);
}

TEST(SuiteRun, BytesThatAreNoTextDoNotSpoilTheFile) {
  const Folder folder;
  const Results results = run_suite(rectangles({"throw_bytes"}), test_registry(), into(folder.file("out")));
  ASSERT_FALSE(results.rows.empty());
  EXPECT_EQ(results.rows[0].get("reason"), "caf\xEF\xBF\xBD \xEF\xBF\xBD \"is\", closed");
}

// Reading and making maps, building problems: a breach of a limit is a row.
TEST(SuiteRun, SettingUpAProblemHasLimits) {
  const Folder folder;
  Suite suite = rectangles({"good"});
  suite.limits = {.wall_s = 0.3, .memory_mb = 2000};
  suite.maps[0].generator = "clutter";
  suite.maps[0].settings = {{"width", 400.0}, {"height", 400.0}};
  const Results slow = run_suite(suite, test_registry(), into(folder.file("slow")));
  EXPECT_EQ(slow.rows[0].outcome(), Outcome::timeout);
  EXPECT_THAT(slow.rows[0].get("reason"), HasSubstr("setting up the problem: no result after 0.3 s"));
  suite.limits = {.wall_s = 60, .memory_mb = 20};
  const Results large = run_suite(suite, test_registry(), into(folder.file("large")));
  EXPECT_EQ(large.rows[0].outcome(), Outcome::out_of_memory) << large.rows[0].get("reason");
}

TEST(SuiteRun, RefusesWhatItWouldSpoil) {
  const Folder folder;
  const std::string out = folder.file("out");
  run_suite(rectangles({"good"}), test_registry(), into(out));
  EXPECT_THAT([&] { run_suite(rectangles({"good"}), test_registry(), into(out)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("already holds results")));
  Suite other = rectangles({"good"});
  other.name = "other";
  EXPECT_THAT([&] { run_suite(other, test_registry(), into(out, 1, true)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("holds results of the suite")));
  std::string session = read_file(out + "/session.json");
  session.replace(session.find(build_identity()), build_identity().size(), "0123456789abcdef");
  write_file(out + "/session.json", session);
  EXPECT_THAT([&] { run_suite(rectangles({"good"}), test_registry(), into(out, 1, true)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("another build")));
  write_file(folder.file("file"), "x");
  EXPECT_THAT([&] { run_suite(rectangles({"good"}), test_registry(), into(folder.file("file/out"))); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cannot write")));
}

TEST(SuiteRun, ARobotThatFitsNowhereIsInfeasible) {
  const Folder folder;
  Suite suite = rectangles({"good", "null"});
  suite.robots[0].radius = 5;
  MapSpec in_a_wall = suite.maps[0];
  in_a_wall.start = Location{"", {50, 50}};
  suite.maps.push_back(in_a_wall);
  const Results results = run_suite(suite, test_registry(), into(folder.file("out")));
  ASSERT_EQ(results.rows.size(), 4u);
  for (const Row& row : results.rows) {
    EXPECT_EQ(row.outcome(), Outcome::infeasible) << row.get("reason");
    EXPECT_FALSE(row.get("reason").empty());
  }
}

TEST(SuiteRun, ALackingCapabilityIsUnsupported) {
  const Folder folder;
  Suite suite = rectangles({"good"});
  suite.robots[0].tether = Tether{10};
  const Results results = run_suite(suite, test_registry(), into(folder.file("out")));
  EXPECT_EQ(results.rows.at(0).outcome(), Outcome::unsupported);
  EXPECT_THAT(results.rows[0].get("reason"), HasSubstr("tether"));
}

// The string in an empty rectangle is straight, so its greatest length is taken at a corner of the path.
TEST(SuiteRun, AnIgnoredTetherIsMeasuredAndDoesNotCount) {
  const Folder folder;
  Registry registry = testing::test_registry_copy();
  PlannerInfo tied = registry.planners.find("test");
  tied.name = "tied";
  tied.capabilities = {Capability::tether};
  registry.planners.add(tied);
  Suite suite = rectangles({"good", "wall"});
  const Results free = run_suite(suite, registry, into(folder.file("free")));
  suite.robots[0].tether = Tether{1.2};
  for (const char* how : {"good", "wall"}) suite.planners.push_back({"test", {{"how", how}}, true});
  suite.planners.push_back({"tied", {{"how", "good"}}});
  const Results held = run_suite(suite, registry, into(folder.file("held")));
  ASSERT_EQ(held.rows.size(), 5u);
  EXPECT_EQ(held.rows[0].outcome(), Outcome::unsupported);
  EXPECT_EQ(held.rows[1].outcome(), Outcome::unsupported);

  // As if there were no tether, but measured.
  const Row& row = held.rows[2];
  EXPECT_EQ(row.outcome(), Outcome::ok) << row.get("reason");
  EXPECT_EQ(row.get("variant"), "test[how=good;ignore_tether=true]");
  EXPECT_EQ(row.get("params"), "how=good;ignore_tether=true");
  EXPECT_EQ(row.get("path_sha256"), free.rows[0].get("path_sha256"));
  EXPECT_EQ(row.get("path_m"), free.rows[0].get("path_m"));
  const std::string file = folder.file("held/" + row.get("path_file"));
  const Path path = read_path(file);
  double farthest = 0;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points) farthest = std::max(farthest, distance(p, path.legs[0].points[0]));
  EXPECT_EQ(row.number("tether_limit_m"), 1.2);
  EXPECT_NEAR(row.number("tether_max_m").value(), farthest, 1e-9);
  EXPECT_GT(farthest, 1.2);
  // The stored problem has the tether: scored again, the path exceeds it.
  const MapFile map = problem_of(file);
  const Problem problem(map.map, *map.robot, map.start, map.anchor);
  EXPECT_THAT(find_flaw(problem, path), HasSubstr("tether"));
  EXPECT_EQ(find_flaw(problem, path, {.tether_counts = false}), "");
  EXPECT_LT(row.number("target_m2").value(), free.rows[0].number("target_m2").value());

  EXPECT_EQ(held.rows[3].outcome(), Outcome::invalid);  // walls count for everyone
  EXPECT_EQ(held.rows[4].outcome(), Outcome::invalid);  // who minds the tether is judged by it
  EXPECT_THAT(held.rows[4].get("reason"), HasSubstr("tether"));
  std::set<std::string> ids;
  for (const Row& r : held.rows) ids.insert(r.get("run_id"));
  EXPECT_EQ(ids.size(), 5u);
  EXPECT_EQ(held.rows[0].get("seed"), held.rows[2].get("seed"));
}

// `leashed` covers less than the planner that it runs: it promises nothing, whatever that one does.
TEST(SuiteRun, APlannerThatRunsAnotherOnePromisesForItself) {
  const Folder folder;
  Suite suite = rectangles({});
  suite.robots[0].tether = Tether{6};
  suite.planners = {{"leashed", {{"planner", "zigzag"}}}, {"zigzag", {}, true}};
  const Results results = run_suite(suite, built_in_registry(), into(folder.file("out")));
  ASSERT_EQ(results.rows.size(), 2u);
  EXPECT_EQ(results.rows[0].get("promise"), "nothing");
  EXPECT_EQ(results.rows[0].get("promise_coverage"), "");
  EXPECT_EQ(results.rows[1].get("promise"), "target");
}

// Found out once for all robots of a map, except what depends on the tool.
TEST(SuiteRun, RowsDescribeTheMapForEveryRobot) {
  const Folder folder;
  Suite suite = rectangles({"good"}, 2);
  suite.robots.push_back(Robot{});
  suite.robots.back().name = "wide";
  suite.robots.back().tool_width = 0.8;
  const Results results = run_suite(suite, test_registry(), into(folder.file("out")));
  ASSERT_EQ(results.rows.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Row& row = results.rows[i];
    const double width = i < 2 ? 3 : 4, tool = i % 2 == 0 ? 0.4 : 0.8;
    EXPECT_EQ(row.number("map_area_m2"), 2 * width);
    EXPECT_EQ(row.number("map_perimeter_m"), 2 * width + 4);
    EXPECT_NEAR(row.number("map_area_tools").value(), 2 * width / (tool * tool), 1e-9);
    EXPECT_EQ(row.get("map_sha256"), results.rows[i - i % 2].get("map_sha256"));
  }
}

TEST(SuiteRun, NamedLocationsAreResolvedForEachRobot) {
  const Folder folder;
  Suite suite = rectangles({"good"});
  suite.robots.push_back(Robot{});
  suite.robots.back().name = "thin";
  suite.robots.back().radius = 0.1;
  suite.maps[0].start = Location{"corner"};
  suite.maps[0].anchor = Location{"wall"};
  const Results results = run_suite(suite, test_registry(), into(folder.file("out")));
  ASSERT_EQ(results.rows.size(), 2u);
  for (const Row& row : results.rows) {
    const MapFile map = problem_of(folder.file("out/" + row.get("path_file")));
    const double r = map.robot->radius;
    EXPECT_NEAR(distance(*map.start, {r + 0.004, r + 0.004}), 0, 1e-3);
    EXPECT_EQ(std::min(map.anchor->x(), map.anchor->y()), 0);
    EXPECT_NEAR(distance(*map.start, *map.anchor), r + 0.004, 1e-3);
  }
}

TEST(SuiteRun, SessionAndColumnsDescribeTheFolder) {
  const Folder folder;
  SuiteRunOptions options = into(folder.file("out"));
  options.traces = true;
  options.command_line = {"oxturn", "run"};
  const Results results = run_suite(rectangles({"good"}), test_registry(), options);
  const auto session = nlohmann::json::parse(read_file(folder.file("out/session.json")));
  EXPECT_EQ(session.at("limits").at("memory_mb"), 2000);
  EXPECT_EQ(session.at("sessions").at(0).at("command_line").at(1), "run");
  const auto described = nlohmann::json::parse(read_file(folder.file("out/columns.json")));
  ASSERT_EQ(described.size(), all_columns().size());
  EXPECT_EQ(described[1].at("name"), "run_id");
  const auto traces =
      nlohmann::json::parse(read_file(folder.file("out/traces/" + results.rows[0].get("run_id") + ".json")));
  EXPECT_EQ(traces.at(0).at("name"), "box");
}

// Ctrl-C in the middle: whole lines stay, and --resume does the rest.
TEST(SuiteRun, InterruptKeepsWhatIsThere) {
  Suite suite = rectangles({"good", "spin_and_tell", "partial"});
  suite.limits.wall_s = 3;
  const Folder folder;
  const std::string out = folder.file("out");
  const std::string spins = folder.file("spins");
  ::setenv("OXTURN_TEST_SPINS", spins.c_str(), 1);
  const pid_t pid = ::fork();
  if (pid == 0) {
    int code = 1;
    try {
      run_suite(suite, test_registry(), into(out));
    } catch (const Interrupted& e) {
      code = std::string(e.what()).find("interrupted after 1 of 3 runs") == 0 ? 42 : 2;
    } catch (...) { code = 3; }
    ::_exit(code);
  }
  for (int i = 0; i < 3000 && !std::filesystem::exists(spins); ++i) ::usleep(20000);
  ::kill(pid, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(pid, &status, 0), pid);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 42);
  const Results cut = read_results(out);
  ASSERT_EQ(cut.rows.size(), 2u);
  EXPECT_EQ(cut.rows[0].outcome(), Outcome::ok);
  EXPECT_EQ(cut.rows[1].outcome(), Outcome::cancelled);
  const Results whole = run_suite(suite, test_registry(), into(out, 1, true));
  ASSERT_EQ(whole.rows.size(), 3u);
  EXPECT_EQ(whole.rows[1].outcome(), Outcome::timeout);
  EXPECT_EQ(whole.rows[1].get("attempt"), "2");
  EXPECT_EQ(whole.rows[2].outcome(), Outcome::partial);
}

}  // namespace
}  // namespace oxturn

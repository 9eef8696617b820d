// Everything at its worst in one suite: it ends by itself, with one right row each, nothing left running, and the
// memory of the harness as it was. Only what never ends by itself has a short limit on time: all else has enough on the
// slowest of machines.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/sanitized.hpp"
#include "bench/child_process.hpp"
#include "bench/process_info.hpp"
#include "bench/run_suite.hpp"
#include "test_planners.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using testing::Folder;
using ::testing::HasSubstr;
using testing::test_registry;

/// What becomes of a planner: its outcome (one of those separated by |), and a regular expression for the reason.
struct Expected {
  const char *how, *outcome, *reason;
};

constexpr Expected kEnding[] = {
    {"good", "ok", "^$"},
    {"throw", "error", "^my tour is broken$"},
    {"throw_int", "error", "not a std::exception"},
    {"throw_bytes", "error", "^caf\xEF\xBF\xBD"},
    {"throw_megabytes", "error", "^x+ \\.\\.\\.$"},
    {"throw_in_thread", "crash", "SIGABRT"},
    {"infeasible", "infeasible", "too small for me"},
    {"unsupported", "unsupported", "no rectangles"},
    {"exit", "error", "^exited with code 3$"},
    {"quiet_exit", "error", "ended without a result"},
    {"null", "crash", "SIGSEGV"},
    {"abort", "crash", "SIGABRT"},
    {"stack", "crash", "SIG(SEGV|BUS)"},
    {"kill_itself", "crash|out_of_memory", "SIGKILL|ran out of memory"},  // if the kernel killed another one meanwhile
    {"kill_parent", "infrastructure", "was killed by signal 9"},
    {"kill_parents_group", "infrastructure", "was killed by signal 9"},
    {"allocate", "out_of_memory", "needs more than 300 MB"},
    {"allocate_100_gb", kSanitized ? "out_of_memory|crash|error" : "out_of_memory", ""},
    {"allocate_in_children", "out_of_memory", "needs more than 300 MB"},
    {"fork_bomb", kSanitized ? "ok|out_of_memory" : "ok", ""},
    {"leave_child", "ok", "^$"},
    {"leave_daemon", "ok", "^$"},
    {"garbage", "error", "bad protocol"},
    {"babble", "ok", "^$"},
    {"record_megabytes", "ok", "^$"},
    {"promise_throws", "error", "not a std::exception"},
    {"promise_nan", "ok", "^$"},
    {"wall", "invalid", "leaves configuration space"},
    {"nan", "invalid", "leg 1 point 2 is not finite"},
    {"infinite", "invalid", "leg 1 point 2 is not finite"},
    {"huge", "invalid", "leaves configuration space"},
    {"empty", "invalid", "no legs"},
    {"empty_leg", "invalid", "leg 1 has 0 points"},
    {"one_point", "invalid", "leg 1 has 1 point"},
    {"zero_length", "partial", "is below 0.99"},
    {"jump", "invalid", "leg 2 starts at"},
    {"elsewhere", "invalid", "starts at"},
    {"points", "out_of_memory", "needs more than 300 MB"},
    {"million_points", "partial|out_of_memory", "is below 0.99|^(scoring|storing the path): needs more"},
    {"partial", "partial", "is below 0.99"},
};

constexpr Expected kHanging[] = {
    {"spin", "timeout", "no result after 0.5 s"},    {"sleep", "timeout", "no result after 0.5 s"},
    {"stop", "timeout", "no result after 0.5 s"},    {"exec", "timeout", "no result after 0.5 s"},
    {"hide", "timeout", "no result after 0.5 s"},    {"ignore_signals", "timeout", "no result after 0.5 s"},
    {"publish", "timeout", "no result after 0.5 s"}, {"publish_nan", "timeout", "no result after 0.5 s"},
};

Suite suite_of(std::span<const Expected> planners, double wall_s) {
  Suite suite;
  suite.name = "hostile";
  suite.limits = {.wall_s = wall_s, .memory_mb = 300};
  suite.robots.push_back(Robot{});
  MapSpec map;
  map.generator = "rectangle";
  map.settings = {{"width", 3.0}, {"height", 2.0}};
  suite.maps = {map};
  for (const Expected& e : planners) suite.planners.push_back({"test", {{"how", e.how}}});
  return suite;
}

Results run_into(const Suite& suite, const std::string& folder) {
  SuiteRunOptions options;
  options.folder = folder;
  options.jobs = 2;
  options.progress = false;
  options.pictures = false;
  return run_suite(suite, test_registry(), options);
}

/// Runs the suite in a process and a process group of its own, and checks what it leaves behind.
Results harness_runs(const Suite& suite, const Folder& folder) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::setpgid(0, 0);
    int code = 1;
    try {
      run_into(suite_of(std::span(kEnding).first(1), 60), folder.file("warm"));  // touches the code that is needed
      reset_peak();
      const double before = peak_bytes();
      run_into(suite, folder.file("out"));
      write_file(folder.file("growth"), std::to_string(peak_bytes() - before));
      code = 0;
    } catch (const std::exception& e) { std::fprintf(stderr, "the harness: %s\n", e.what()); }
    ::_exit(code);
  }
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {}
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the harness ended with status " << status;
  EXPECT_TRUE(descendants(::getpid()).empty()) << "processes are left";
  ::prctl(PR_SET_CHILD_SUBREAPER, 0);
  const double growth = std::stod(read_file(folder.file("growth")));
  EXPECT_LT(kSanitized ? 0 : growth, 20e6);
  return read_results(folder.file("out"));
}

void expect_rows(std::span<const Expected> planners, const Results& results) {
  ASSERT_EQ(results.rows.size(), planners.size());
  EXPECT_EQ(parse_csv(read_file(results.folder + "/runs.csv"), "runs.csv").size(), planners.size() + 1);
  std::set<std::string> ids;
  for (std::size_t i = 0; i < planners.size(); ++i) {
    SCOPED_TRACE(planners[i].how);
    const Row& row = results.rows[i];
    ids.insert(row.get("run_id"));
    EXPECT_EQ(row.get("params"), fmt::format("how={}", planners[i].how));
    EXPECT_THAT("|" + std::string(planners[i].outcome) + "|", HasSubstr("|" + row.get("outcome") + "|"))
        << row.get("reason");
    EXPECT_THAT(row.get("reason"), ContainsRegex(planners[i].reason));
    EXPECT_LE(row.get("reason").size(), 600u);
  }
  EXPECT_EQ(ids.size(), planners.size());
}

const Row& row_of(const Results& results, const std::string& how) {
  for (const Row& row : results.rows)
    if (row.get("params") == "how=" + how) return row;
  throw std::logic_error("no row of " + how);
}

TEST(Hostile, PlannersAndPathsCostOneRowEach) {
  const Folder folder;
  const Results results = harness_runs(suite_of(kEnding, 60), folder);
  expect_rows(kEnding, results);
  const auto cell = [&](const char* how, const char* column) { return row_of(results, how).get(column); };
  EXPECT_EQ(cell("null", "signal"), std::to_string(SIGSEGV));
  EXPECT_EQ(cell("exit", "exit_code"), "3");
  EXPECT_EQ(cell("good", "signal") + cell("good", "exit_code"), "");
  EXPECT_EQ(cell("nan", "path_file") + cell("one_point", "path_file"), "");
  const auto log = [&](const char* how) { return folder.file("out/logs/" + cell(how, "run_id") + ".log"); };
  EXPECT_THAT(read_file(log("babble")), HasSubstr("garbage"));
  EXPECT_FALSE(fs::exists(log("good")));
}

TEST(Hostile, HangingPlannersCostTheLimitOnTime) {
  const Folder folder;
  expect_rows(kHanging, harness_runs(suite_of(kHanging, 0.5), folder));
}

const char* const kHead =
    "schema = 1\nname = \"maps\"\n[limits]\nwall_s = 20\nmemory_mb = 300\n[robots.disc]\nradius = 0.2\ntool_width = "
    "0.4\n";

std::string suite_of_map(const Folder& folder, const std::string& file, const std::string& keys) {
  write_file(folder.file("suite.toml"),
             fmt::format("{}[[maps]]\nfile = \"{}\"\n{}\n[[planners]]\nname = \"test\"\nhow = "
                         "\"partial\"\n",
                         kHead, file, keys));
  return folder.file("suite.toml");
}

std::string square(double low, double high) {
  return fmt::format(
      "{{\"type\": \"Polygon\", \"coordinates\": [[[{0}, {0}], [{1}, {0}], [{1}, {1}], [{0}, {1}], [{0}, {0}]]]}}", low,
      high);
}

// What is wrong with a file is a sentence before anything runs.
TEST(Hostile, BadMapsAreRefused) {
  const Folder folder;
  ASSERT_EQ(::mkfifo(folder.file("fifo.png").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", folder.file("device.png"));
  fs::create_symlink("/dev/full", folder.file("device.geojson"));
  write_file(folder.file("empty.png"), "");
  write_file(folder.file("empty.geojson"), "{\"type\": \"Polygon\", \"coordinates\": []}");
  write_file(folder.file("huge.pgm"), "P5\n100000 100000\n255\n");
  write_file(folder.file("cut.pgm"), "P5\n9000 9000\n255\n");
  write_file(folder.file("bow.geojson"),
             "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [4, 4], [4, 0], [0, 5], [0, 0]]]}");
  write_file(folder.file("nan.geojson"),
             "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [NaN, 0], [1, 1], [0, 0]]]}");
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path())) names.insert(entry.path().filename().string());
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const bool image = !name.ends_with(".geojson");
    const std::string suite = suite_of_map(folder, name, image ? "scale = 0.05" : "");
    try {
      read_suite(suite, test_registry());
      ADD_FAILURE() << "was accepted";
    } catch (const std::invalid_argument& e) { EXPECT_THAT(e.what(), HasSubstr(name)); }
  }
  EXPECT_TRUE(descendants(::getpid()).empty());
}

// Files that are well-formed cost their rows, whatever they hold.
TEST(Hostile, StrangeMapsAreRows) {
  struct Case {
    std::string name, content, keys, outcome;
  };
  const std::vector<Case> cases{
      {"cell.pgm", "P5\n1 1\n255\n\xff", "scale = 0.05", "infeasible"},
      {"large_cell.pgm", "P5\n1 1\n255\n\xff", "scale = 3.0", "partial"},
      {"wall.pgm", std::string("P5\n1 1\n255\n") + '\0', "scale = 0.05", "infeasible"},
      {"far.geojson", square(1e15, 1e15 + 8), "", "partial|invalid|infeasible"},
      {"wide.geojson", square(-1e15, 1e15), "", "partial|invalid|infeasible|out_of_memory|timeout"},
      {"tiny.geojson", square(0, 1e-9), "", "infeasible"},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Folder folder;
    write_file(folder.file(c.name), c.content);
    Suite suite;
    try {
      suite = read_suite(suite_of_map(folder, c.name, c.keys), test_registry());
    } catch (const std::invalid_argument& e) {
      EXPECT_EQ(c.outcome, "infeasible") << e.what();
      EXPECT_THAT(e.what(), HasSubstr(c.name));
      continue;
    }
    const Results results = run_into(suite, folder.file("out"));
    ASSERT_EQ(results.rows.size(), 1u);
    EXPECT_THAT("|" + c.outcome + "|", HasSubstr("|" + results.rows[0].get("outcome") + "|"))
        << results.rows[0].get("outcome") << ": " << results.rows[0].get("reason");
    EXPECT_TRUE(descendants(::getpid()).empty());
  }
}

}  // namespace
}  // namespace oxturn

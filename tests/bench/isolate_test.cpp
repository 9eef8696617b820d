// Planners at their worst, one process each.
#include "bench/isolate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>

#include "base/files.hpp"
#include "base/sanitized.hpp"
#include "bench/process_info.hpp"
#include "bench/run_suite.hpp"
#include "bench/verdict.hpp"
#include "maps/path_file.hpp"
#include "reports/built_in_registry.hpp"
#include "test_planners.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using testing::small_problem;
using testing::test_planner;

/// Time enough on the slowest of machines; a test whose planner hangs sets a limit of its own.
IsolationOptions limits() {
  IsolationOptions options;
  options.limits = {.wall_s = 60, .memory_mb = 200};
  return options;
}

Planned run(const std::string& how, const IsolationOptions& options = limits()) {
  static const Problem problem = small_problem();
  return plan_isolated([&] { return test_planner({{"how", how}}); }, problem, options);
}

/// With more and more time, until there is enough of it for the planner on this machine.
template <class Enough>
Planned run_until(const std::string& how, Enough enough) {
  IsolationOptions options = limits();
  Planned planned;
  for (double wall_s = 0.5; wall_s <= 32; wall_s *= 2) {
    options.limits.wall_s = wall_s;
    planned = run(how, options);
    if (enough(planned)) break;
  }
  return planned;
}

std::size_t open_descriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

TEST(Isolate, AGoodPathComesBackAsItWas) {
  Context context(1);
  const Path expected = test_planner({{"how", "good"}})->plan(small_problem(), context);
  const Planned planned = run("good");
  ASSERT_EQ(planned.outcome, Outcome::ok);
  ASSERT_TRUE(planned.path);
  EXPECT_EQ(to_geojson(*planned.path), to_geojson(expected));
  EXPECT_EQ(planned.reason, "");
  EXPECT_GT(planned.wall_s, 0);
}

TEST(Isolate, CrashesNameTheSignal) {
  const Planned null = run("null");
  EXPECT_EQ(null.outcome, Outcome::crash);
  EXPECT_EQ(null.signal, SIGSEGV);
  EXPECT_EQ(null.reason, "killed by SIGSEGV (segmentation fault)");
  EXPECT_FALSE(null.path);
  const Planned aborted = run("abort");
  EXPECT_EQ(aborted.outcome, Outcome::crash);
  EXPECT_EQ(aborted.signal, SIGABRT);
}

TEST(Isolate, HangsEndAtTheWall) {
  IsolationOptions options = limits();
  options.limits.wall_s = 0.5;
  for (const char* how : {"spin", "hide"}) {
    const Planned planned = run(how, options);
    EXPECT_EQ(planned.outcome, Outcome::timeout) << how;
    EXPECT_EQ(planned.reason, "no result after 0.5 s");
    EXPECT_FALSE(planned.path);
  }
}

TEST(Isolate, ThePoliteAreToldBeforeTheWall) {
  const Planned planned = run_until("polite", [](const Planned& p) { return p.wall_s > 0; });
  EXPECT_GT(planned.wall_s, 0);  // measured at its end: it was not killed
  // It had nothing to show then, which is no invalid path.
  EXPECT_EQ(planned.outcome, Outcome::timeout);
  EXPECT_THAT(planned.reason, HasSubstr("no result after"));
  EXPECT_FALSE(planned.path);
}

// A path that was cut short is scored as it is, and the reason tells what cut it short.
TEST(Isolate, APathAtTheDeadlineSaysSo) {
  const Planned planned = run_until("cut_short", [](const Planned& p) { return p.path.has_value(); });
  EXPECT_EQ(planned.outcome, Outcome::ok);
  EXPECT_THAT(planned.reason, HasSubstr("planning ended at the limit of"));
  EXPECT_THAT(judge(planned, score(small_problem(), *planned.path), 0.99).reason,
              HasSubstr(" is below 0.99; planning ended at the limit of"));
  EXPECT_EQ(run("good").reason, "");
}

TEST(Isolate, AllocatingTooMuchIsStopped) {
  IsolationOptions options = limits();
  const Planned planned = run("allocate", options);
  EXPECT_EQ(planned.outcome, Outcome::out_of_memory);
  EXPECT_EQ(planned.reason, "needs more than 200 MB of memory");
  // One that does not hear the refusals hangs, and does not get more for it.
  options.limits.wall_s = 1.5;
  const Outcome mapped = run("allocate_by_mmap", options).outcome;
  EXPECT_TRUE(mapped == Outcome::timeout || mapped == Outcome::out_of_memory) << to_text(mapped);
}

TEST(Isolate, ProcessorTimeHasALimitOfItsOwn) {
  IsolationOptions options = limits();
  options.limits.cpu_s = 0.2;
  const Planned spinning = run("spin", options);
  EXPECT_EQ(spinning.outcome, Outcome::timeout);
  EXPECT_EQ(spinning.reason, "no result after 0.2 s of processor time");
  options.limits.wall_s = 0.5;
  options.limits.cpu_s = 60;
  EXPECT_EQ(run("sleep", options).reason, "no result after 0.5 s");
}

TEST(Isolate, MemoryOfAllProcessesCounts) {
  const Planned planned = run("allocate_in_children");
  EXPECT_EQ(planned.outcome, Outcome::out_of_memory);
  EXPECT_EQ(planned.reason, "needs more than 200 MB of memory");
}

// The limit is the one that is given, from both sides.
TEST(Isolate, TheMemoryLimitIsAccurate) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer's own memory counts, too";
  IsolationOptions options = limits();
  options.limits.memory_mb = 45;
  EXPECT_EQ(run("measure", options).outcome, Outcome::out_of_memory);  // 50 MB
  options.limits.memory_mb = 80;
  EXPECT_EQ(run("measure", options).outcome, Outcome::ok);
}

TEST(Isolate, DaemonsAreKilledToo) {
  EXPECT_EQ(run("leave_daemon").outcome, Outcome::ok);
  EXPECT_TRUE(descendants(::getpid()).empty());
}

TEST(Isolate, RecordsAndTracesAreBounded) {
  IsolationOptions options = limits();
  options.limits.memory_mb = 1000;
  options.traces = true;
  const Planned records = run("record_megabytes", options);
  EXPECT_EQ(records.outcome, Outcome::ok);
  EXPECT_EQ(records.records.size(), kMostRecords);
  const Planned traces = run("trace_megabytes", options);
  EXPECT_EQ(traces.outcome, Outcome::ok);
  EXPECT_FALSE(traces.traces.empty());
  EXPECT_LE(traces.traces.size() * 16'000'000, kMostTraceBytes);
}

TEST(Isolate, WarmUpsAreNotTheRunThatCounts) {
  IsolationOptions options = limits();
  options.warm_ups = 2;
  EXPECT_EQ(run("count_calls", options).records, (Records{{"calls", 3}}));
}

TEST(Isolate, APromiseComesBack) {
  const Planned planned = run("promise");
  ASSERT_TRUE(planned.promised);
  EXPECT_DOUBLE_EQ(area(*planned.promised), 1);
}

TEST(Isolate, MapsThatNeverEndAreBad) {
  const testing::Folder folder;
  const std::string fifo = folder.file("fifo.png");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string zeros = folder.file("zeros.png");
  std::filesystem::create_symlink("/dev/zero", zeros);
  const MapFormats formats = built_in_registry().formats;
  for (const std::string& file : {fifo, zeros}) {
    const ReadResult result = read_map_isolated(file, {{"scale", 0.05}}, formats, limits().limits);
    EXPECT_EQ(result.report.outcome, Outcome::error) << file;
    EXPECT_THAT(result.report.reason, HasSubstr("is not a regular file")) << file;
  }
}

TEST(Isolate, ExceptionsAndExits) {
  EXPECT_EQ(run("throw").outcome, Outcome::error);
  EXPECT_EQ(run("throw").reason, "my tour\nis broken");
  EXPECT_EQ(run("throw_int").outcome, Outcome::error);
  EXPECT_EQ(run("infeasible").outcome, Outcome::infeasible);
  EXPECT_EQ(run("infeasible").reason, "the map is too small for me");
  EXPECT_EQ(run("unsupported").outcome, Outcome::unsupported);
  const Planned left = run("exit");
  EXPECT_EQ(left.outcome, Outcome::error);
  EXPECT_EQ(left.exit_code, 3);
  EXPECT_EQ(left.reason, "exited with code 3");
  const Planned quiet = run("quiet_exit");
  EXPECT_EQ(quiet.outcome, Outcome::error);
  EXPECT_EQ(quiet.reason, "its process ended without a result");
}

TEST(Isolate, BadSettingsAreAnError) {
  const Planned planned = plan_isolated([] { return test_planner({{"nope", true}}); }, small_problem(), limits());
  EXPECT_EQ(planned.outcome, Outcome::error);
  EXPECT_THAT(planned.reason, HasSubstr("unknown parameter 'nope'"));
}

TEST(Isolate, ATimeoutKeepsTheLastPublishedPath) {
  const Planned planned = run_until("publish", [](const Planned& p) { return p.path && p.path->length() > 0.9; });
  EXPECT_EQ(planned.outcome, Outcome::timeout);
  ASSERT_TRUE(planned.path);
  EXPECT_DOUBLE_EQ(planned.path->length(), 1);
}

TEST(Isolate, PrintingGoesToTheLog) {
  const testing::Folder folder;
  IsolationOptions options = limits();
  options.log_file = folder.file("a.log");
  EXPECT_EQ(run("babble", options).outcome, Outcome::ok);
  EXPECT_THAT(read_file(folder.file("a.log")), HasSubstr("garbage"));
  EXPECT_THAT(read_file(folder.file("a.log")), HasSubstr("and more"));
  options.log_file = folder.file("b.log");
  EXPECT_EQ(run("good", options).outcome, Outcome::ok);
  EXPECT_FALSE(std::filesystem::exists(folder.file("b.log")));
}

TEST(Isolate, MeasuresPlanAlone) {
  IsolationOptions options = limits();
  options.limits.memory_mb = 2000;
  const auto before = std::chrono::steady_clock::now();
  const Planned planned = run("measure", options);
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  EXPECT_EQ(planned.outcome, Outcome::ok) << planned.reason;
  EXPECT_GE(planned.wall_s, 0.1);
  EXPECT_LE(planned.wall_s, elapsed);
  EXPECT_GT(planned.cpu_s, 0);
  EXPECT_GE(planned.peak_rss_bytes, 49e6);
#if !defined(__SANITIZE_THREAD__)  // its shadow is several times as large as the planner's memory
  EXPECT_LT(planned.peak_rss_bytes, 150e6);
#endif
}

TEST(Isolate, TracesAndProgressOnRequest) {
  IsolationOptions options = limits();
  EXPECT_TRUE(run("good", options).traces.empty());
  options.traces = true;
  double last = 0;
  options.progress = [&](double fraction) { last = fraction; };
  const Planned planned = run("good", options);
  ASSERT_EQ(planned.traces.size(), 1u);
  EXPECT_EQ(planned.traces[0].name, "box");
  ASSERT_EQ(planned.traces[0].lines.size(), 1u);
  EXPECT_EQ(planned.traces[0].lines[0].size(), 2u);
  EXPECT_EQ(last, 0.5);
}

TEST(Isolate, LeavesNothingBehind) {
  run("good");
  const std::size_t before = open_descriptors();
  for (const char* how : {"good", "null", "exit", "throw", "leave_child", "quiet_exit"}) run(how);
  EXPECT_EQ(open_descriptors(), before);
  errno = 0;
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);  // no child, dead or alive
  EXPECT_EQ(errno, ECHILD);
}

TEST(Isolate, TheSeedIsThePlannersLuck) {
  IsolationOptions options = limits();
  const auto text = [&](std::uint64_t seed) {
    options.seed = seed;
    return to_geojson(run("random", options).path.value());
  };
  EXPECT_EQ(text(7), text(7));
  EXPECT_NE(text(7), text(8));
}

}  // namespace
}  // namespace oxturn

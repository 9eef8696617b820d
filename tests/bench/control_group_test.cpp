// Everything that a child starts is found, counted and killed: in a control group, and without one as a sub-reaper.
#include "bench/control_group.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <thread>
#include <vector>

#include "bench/child_process.hpp"
#include "bench/process_info.hpp"
#include "bench/session_file.hpp"
#include "bench/wire.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;

constexpr const char* kNone = "this process can make no control groups (cgroup v2 is not there, or not writable)";

bool is_alive(pid_t pid) { return ::kill(pid, 0) == 0; }

/// Waits, a second at most, until the process is gone.
bool is_gone(pid_t pid) {
  for (int round = 0; round < 1000 && is_alive(pid); ++round) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return !is_alive(pid);
}

/// Starts a daemon in a session of its own, whose parent has ended; returns its process id.
template <class Work>
pid_t daemon_doing(Work work) {
  wire::Pipe pipe = wire::make_pipe();
  const pid_t between = ::fork();
  if (between == 0) {
    ::setsid();
    const pid_t pid = ::fork();
    if (pid == 0) {
      work();
      ::_exit(0);
    }
    [[maybe_unused]] const ssize_t put = ::write(pipe.write.number(), &pid, sizeof pid);
    ::_exit(0);
  }
  pid_t pid = 0;
  [[maybe_unused]] const ssize_t got = ::read(pipe.read.number(), &pid, sizeof pid);
  ::waitpid(between, nullptr, 0);
  return pid;
}

[[noreturn]] void wait_for_ever() {
  for (;;) ::pause();
}

TEST(ControlGroup, HoldsAndKillsDaemons) {
  auto group = ControlGroup::make(1e9);
  if (!group) GTEST_SKIP() << kNone;
  const Orphans orphans;  // the daemon becomes ours when its parent ends
  wire::Pipe pipe = wire::make_pipe();
  const pid_t child = ::fork();
  if (child == 0) {
    group->enter();
    const pid_t daemon = daemon_doing(wait_for_ever);
    wire::send(pipe.write.number(), 'D', {reinterpret_cast<const char*>(&daemon), sizeof daemon});
    wait_for_ever();
  }
  pid_t daemon = 0;
  wire::FrameReader frames(100);
  while (daemon == 0)
    frames.read(pipe.read.number(), [&](char, std::string_view p) { std::memcpy(&daemon, p.data(), sizeof daemon); });
  EXPECT_THAT(group->processes(), ::testing::UnorderedElementsAre(child, daemon));
  group->kill();
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  orphans.kill_all({});  // reaps it
  EXPECT_TRUE(is_gone(daemon));
  EXPECT_TRUE(group->processes().empty());
  EXPECT_EQ(group->out_of_memory_kills(), 0U);
}

TEST(ControlGroup, LeavesNothingBehind) {
  const auto groups = [] {
    std::size_t count = 0;
    std::error_code error;
    for (const char* folder : {"/sys/fs/cgroup", "/sys/fs/cgroup/unified"})
      for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().filename().string().starts_with("oxturn-" + std::to_string(::getpid()))) ++count;
    return count;
  };
  if (!ControlGroup::make(1e9)) GTEST_SKIP() << kNone;
  {
    const auto group = ControlGroup::make(1e9);
    ASSERT_TRUE(group);
  }
  ChildTask task;
  task.work = [](int) { daemon_doing(wait_for_ever); };
  EXPECT_EQ(run_child(task).outcome, Outcome::ok);
  EXPECT_EQ(groups(), 0U);
  // Of a process that was killed while it had one.
  const pid_t victim = ::fork();
  if (victim == 0) {
    const auto group = ControlGroup::make(1e9);
    ::raise(SIGKILL);
  }
  ::waitpid(victim, nullptr, 0);
  remove_stale_control_groups();
  EXPECT_EQ(groups(), 0U);
}

class Confined : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (GetParam() && !ControlGroup::make(1e9)) GTEST_SKIP() << kNone;
    task.control_group = GetParam();
    task.limits = {.wall_s = 20, .memory_mb = 200};
  }
  ChildTask task;
};

TEST_P(Confined, DaemonsAreKilled) {
  pid_t daemon = 0;
  task.work = [](int fd) {
    const pid_t pid = daemon_doing(wait_for_ever);
    wire::send(fd, 'D', {reinterpret_cast<const char*>(&pid), sizeof pid});
  };
  task.receive = [&](char, std::string_view payload) { std::memcpy(&daemon, payload.data(), sizeof daemon); };
  EXPECT_EQ(run_child(task).outcome, Outcome::ok);
  ASSERT_GT(daemon, 0);
  EXPECT_TRUE(is_gone(daemon));
}

TEST_P(Confined, MemoryOfDaemonsCounts) {
  task.work = [](int) {
    daemon_doing([] {
      const std::vector<char> memory(300'000'000, 1);
      [[maybe_unused]] volatile char last = memory.back();  // so that the compiler keeps it
      wait_for_ever();
    });
    wait_for_ever();
  };
  // The daemon has the limit on address space too, above which it would get nothing.
  task.work = [inner = task.work](int fd) {
    rlimit space{RLIM_INFINITY, RLIM_INFINITY};
    ::getrlimit(RLIMIT_AS, &space);
    space.rlim_cur = space.rlim_max;
    ::setrlimit(RLIMIT_AS, &space);
    inner(fd);
  };
  const ChildReport report = run_child(task);
  EXPECT_EQ(report.outcome, Outcome::out_of_memory) << report.reason;
  EXPECT_THAT(report.reason, HasSubstr("needs more than 200 MB of memory"));
}

TEST_P(Confined, ThereAreNoCoreDumps) {
  rlim_t limit = 99;
  task.work = [](int fd) {
    rlimit core{};
    ::getrlimit(RLIMIT_CORE, &core);
    wire::send(fd, 'C', {reinterpret_cast<const char*>(&core.rlim_cur), sizeof core.rlim_cur});
  };
  task.receive = [&](char, std::string_view payload) { std::memcpy(&limit, payload.data(), sizeof limit); };
  EXPECT_EQ(run_child(task).outcome, Outcome::ok);
  EXPECT_LE(limit, 1U);
}

// Each process of the chain lives so short that it has ended before a search has found it.
TEST(ControlGroup, KillsProcessesThatForkOnAndOn) {
  if (!ControlGroup::make(1e9)) GTEST_SKIP() << kNone;
  ChildTask task;
  task.work = [](int) {
    daemon_doing([] {
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);  // if nobody kills it
      while (::fork() == 0 && std::chrono::steady_clock::now() < end) {}
    });
  };
  EXPECT_EQ(run_child(task).outcome, Outcome::ok);
  EXPECT_TRUE(Orphans().adopted({}).empty());
  EXPECT_TRUE(children_of(::getpid()).empty());
}

INSTANTIATE_TEST_SUITE_P(, Confined, testing::Bool(),
                         [](const auto& one) { return one.param ? "InAControlGroup" : "AsSubreaper"; });

TEST(Confinement, SaysWhatThereIs) {
  const bool groups = ControlGroup::make(1e9).has_value();
  EXPECT_EQ(confinement().kill, groups ? "cgroup v2" : "subreaper");
  EXPECT_THAT(confinement().memory, testing::AnyOf("cgroup v2", "polled"));
  EXPECT_TRUE(groups || confinement().memory == "polled");
}

}  // namespace
}  // namespace oxturn

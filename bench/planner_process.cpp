// The child's side of isolate.cpp: obeys the limits, calls plan(), sends what came of it, ends.
#include "bench/planner_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>
#include <stdexcept>

#include "bench/wire.hpp"
#include "geometry/trace.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define OXTURN_SANITIZED 1
#else
#define OXTURN_SANITIZED 0
#endif

namespace oxturn {

namespace {

using Clock = std::chrono::steady_clock;

constexpr rlim_t kLogBytes = rlim_t{64} << 20;
constexpr std::chrono::milliseconds kProgress{50};  // least time between two progress messages

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

double cpu_seconds() {
  timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// A small file of /proc without allocation; "" if it cannot be read.
struct Small {
  char text[4096] = {};
  explicit Small(const char* file) {
    const int fd = ::open(file, O_RDONLY | O_CLOEXEC);
    if (fd < 0) return;
    const ssize_t got = ::read(fd, text, sizeof text - 1);
    text[got > 0 ? got : 0] = 0;
    ::close(fd);
  }
};

double status_bytes(const char* key) {
  const Small status("/proc/self/status");
  const char* line = std::strstr(status.text, key);
  unsigned long kib = 0;
  if (line == nullptr || std::sscanf(line + std::strlen(key), " %lu", &kib) != 1) return 0;
  return static_cast<double>(kib) * 1024;
}

void reset_peak() {
  const int fd = ::open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
  if (fd < 0) return;  // then the peak is that since the fork, which is nearly the same
  [[maybe_unused]] const ssize_t put = ::write(fd, "5", 1);
  ::close(fd);
}

void prepare(const Limits& limits, const Birth& birth) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != birth.parent) ::_exit(1);  // it died before we could ask to follow
  // Sanitizers turn signals into exit codes; the outcome `crash` wants the signal.
  for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    std::signal(s, SIG_DFL);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a planner that prints too much loses its print, not its run
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);

  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nothing, 0);
  ::dup2(birth.log >= 0 ? birth.log : nothing, 1);
  ::dup2(birth.log >= 0 ? birth.log : nothing, 2);
  // Nothing else of the parent's stays open: a process that the planner leaves behind must not hold its pipes.
  ::close_range(3, static_cast<unsigned>(birth.pipe) - 1, 0);
  ::close_range(static_cast<unsigned>(birth.pipe) + 1, ~0U, 0);

  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  rlimit file{};
  ::getrlimit(RLIMIT_FSIZE, &file);
  file.rlim_cur = std::min(file.rlim_max, kLogBytes);
  ::setrlimit(RLIMIT_FSIZE, &file);
  if (!OXTURN_SANITIZED) {
    rlimit space{};
    ::getrlimit(RLIMIT_AS, &space);
    const double allowed = statm_bytes("/proc/self/statm", false) + limits.memory_mb * kMega;
    if (allowed < static_cast<double>(space.rlim_max)) space.rlim_cur = static_cast<rlim_t>(allowed);
    ::setrlimit(RLIMIT_AS, &space);
  }
}

void fail(int fd, Outcome outcome, const char* what) {
  // Built on the stack: memory may be what is lacking.
  char message[1 + 2000];
  message[0] = static_cast<char>(outcome);
  const std::size_t size = std::min<std::size_t>(std::strlen(what), sizeof message - 1);
  std::memcpy(message + 1, what, size);
  wire::send(fd, frames::kFailed, {message, 1 + size});
}

void plan_and_send(int fd, const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem,
                   const IsolationOptions& options) {
  Context::Sinks sinks;
  sinks.publish = [fd](const Path& path) { wire::send_path(fd, frames::kPublished, path); };
  if (options.progress) {
    sinks.progress = [fd, last = Clock::time_point{}](double fraction) mutable {
      if (Clock::now() - last < kProgress) return;
      last = Clock::now();
      std::string message;
      wire::put(message, fraction);
      wire::send(fd, frames::kProgressed, message);
    };
  }
  sinks.record = [fd](const std::string& name, double value) {
    std::string message;
    wire::put(message, value);
    wire::send(fd, frames::kRecorded, message + name);
  };
  if (options.traces) sinks.trace = [fd](const Trace& trace) { wire::send(fd, frames::kTrace, wire::pack(trace)); };

  const auto planner = make();
  Context context(options.seed, 0.95 * options.limits.wall_s, std::move(sinks));
  reset_peak();
  const double rss_before = status_bytes("VmRSS:");
  const double cpu_before = cpu_seconds();
  const auto wall_before = Clock::now();
  const auto measure = [&] {
    const double wall = seconds(Clock::now() - wall_before);
    const double cpu = cpu_seconds() - cpu_before;
    const double growth = std::max(0.0, status_bytes("VmHWM:") - rss_before);
    char message[3 * sizeof(double)];
    const double values[3] = {wall, cpu, growth};
    std::memcpy(message, values, sizeof message);
    wire::send(fd, frames::kMeasures, {message, sizeof message});
  };
  try {
    const Path path = planner->plan(problem, context);
    measure();
    wire::send_path(fd, frames::kResult, path);
  } catch (...) {
    measure();
    throw;
  }
}

}  // namespace

double statm_bytes(const char* file, bool resident) {
  const Small statm(file);
  unsigned long size = 0, rss = 0;
  if (std::sscanf(statm.text, "%lu %lu", &size, &rss) != 2) return 0;
  return static_cast<double>(resident ? rss : size) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

void be_planner(const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem,
                const IsolationOptions& options, const Birth& birth) {
  prepare(options.limits, birth);
  const int fd = birth.pipe;
  try {
    plan_and_send(fd, make, problem, options);
  } catch (const Infeasible& e) { fail(fd, Outcome::infeasible, e.what()); } catch (const Unsupported& e) {
    fail(fd, Outcome::unsupported, e.what());
  } catch (const std::bad_alloc&) { fail(fd, Outcome::out_of_memory, ""); } catch (const std::exception& e) {
    fail(fd, Outcome::error, e.what());
  } catch (...) { fail(fd, Outcome::error, "threw something that is not a std::exception"); }
  wire::send(fd, frames::kEnd, "");
  std::fflush(nullptr);  // the planner's own printing; ours was flushed before the fork
  ::_exit(0);
}

}  // namespace oxturn

// The child is forked, so it has the problem at hand without reading or building anything. It leads a process
// group, which is killed as a whole; it dies with its parent; it sees /dev/null as standard input and a log as its
// output (at most 64 MiB of it). What it finds comes back through a pipe in frames (wire.hpp).
//
// Decisions  1. Time and memory are measured in the child around plan() alone.
//            2. Memory is limited twice: address space by the kernel (so that a planner which allocates too much gets
//               bad_alloc and can report it), resident memory by the parent every 10 ms (for planners that never see
//               bad_alloc, and for sanitizers, which reserve terabytes of address space).
//            3. The wall limit counts from the start of the child until plan() has returned; the transfer of the
//               result has the same time once more.
//            4. The child ends by _exit: nothing of the parent (atexit, destructors, buffers) happens twice.
#include "bench/isolate.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "base/text.hpp"
#include "bench/planner_process.hpp"
#include "bench/wire.hpp"

namespace oxturn {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kWatch{10};  // how often resident memory is read

volatile std::sig_atomic_t running_group = 0;

std::string signal_text(int s) {
  const char* name = ::sigabbrev_np(s);
  const char* meaning = ::sigdescr_np(s);
  std::string text = fmt::format("killed by SIG{}", name != nullptr ? name : std::to_string(s));
  if (meaning != nullptr) {
    std::string lower = meaning;
    if (!lower.empty() && lower.size() > 1 && (lower[1] < 'A' || lower[1] > 'Z')) {
      lower[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(lower[0])));
    }
    text += fmt::format(" ({})", lower);
  }
  if (s == SIGKILL) text += ", not by oxturn: perhaps the kernel ran out of memory";
  return text;
}

// The log is kept only if the planner printed.
class Log {
 public:
  explicit Log(std::string file) : file_(std::move(file)) {
    if (file_.empty()) return;
    fd_ = wire::Descriptor(::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666));
    if (!fd_.open()) throw std::runtime_error(fmt::format("cannot write '{}': {}", file_, std::strerror(errno)));
  }
  Log(const Log&) = delete;
  ~Log() {
    struct stat about {};
    if (fd_.open() && ::fstat(fd_.number(), &about) == 0 && about.st_size == 0) ::unlink(file_.c_str());
  }
  int number() const { return fd_.number(); }

 private:
  std::string file_;
  wire::Descriptor fd_;
};

class Supervisor {
 public:
  Supervisor(pid_t pid, int fd, const IsolationOptions& options, double rss_before)
      : pid_(pid),
        fd_(fd),
        options_(options),
        statm_(fmt::format("/proc/{}/statm", pid)),
        rss_limit_(rss_before + options.limits.memory_mb * kMega),
        frames_(static_cast<std::uint64_t>(options.limits.memory_mb * kMega)),
        deadline_(Clock::now() +
                  std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.limits.wall_s))) {}

  Planned watch() {
    while (!ended_ && !reaped_) {
      const auto now = Clock::now();
      if (now >= deadline_) {
        kill_with(Outcome::timeout, fmt::format("no result after {} s", to_decimal(options_.limits.wall_s)));
        break;
      }
      if (statm_bytes(statm_.c_str(), true) > rss_limit_) {
        kill_with(Outcome::out_of_memory, memory_text());
        break;
      }
      if (!wait_and_read(now)) break;
    }
    if (!reaped_) {
      ::kill(-pid_, SIGKILL);  // processes that the planner has left behind, too
      reap(0);
    } else {
      ::kill(-pid_, SIGKILL);
    }
    judge();
    return std::move(planned_);
  }

 private:
  std::string memory_text() const {
    return fmt::format("needs more than {} MB of memory", to_decimal(options_.limits.memory_mb));
  }

  void kill_with(Outcome outcome, std::string reason) {
    failed_ = true;
    planned_.outcome = outcome;
    planned_.reason = std::move(reason);
  }

  // False when the protocol is broken.
  bool wait_and_read(Clock::time_point now) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - now) + std::chrono::milliseconds(1);
    const int patience = static_cast<int>(std::min<std::chrono::milliseconds>(left, kWatch).count());
    if (closed_) {  // the child closed the pipe without an end frame: it is ending, or still running
      ::usleep(200);
      reap(WNOHANG);
      return true;
    }
    pollfd p{fd_, POLLIN, 0};
    const int ready = ::poll(&p, 1, patience);
    if (ready == 0) {
      // A grandchild may hold the pipe open when the child is gone.
      reap(WNOHANG);
      if (reaped_) drain();
      return true;
    }
    if (ready < 0) return true;  // EINTR
    return read();
  }

  bool read() {
    try {
      closed_ = frames_.read(fd_, [this](char type, std::string_view payload) { take(type, payload); }) ==
                wire::FrameReader::State::closed;
      return true;
    } catch (const std::bad_alloc&) {
      kill_with(Outcome::out_of_memory, "its path does not fit into the memory left beside the harness");
    } catch (const std::exception& e) { kill_with(Outcome::error, fmt::format("bad protocol: {}", e.what())); }
    return false;
  }

  void drain() {
    while (!closed_ && !ended_) {
      pollfd p{fd_, POLLIN, 0};
      if (::poll(&p, 1, 0) <= 0 || !read()) return;
    }
  }

  void take(char type, std::string_view payload) {
    if (ended_) throw std::runtime_error("a message after the end");
    switch (type) {
      case frames::kPublished:
      case frames::kResult:
        planned_.path = wire::path_from(payload);
        if (type == frames::kResult) has_result_ = true;
        break;
      case frames::kMeasures:
        planned_.wall_s = wire::take<double>(payload);
        planned_.cpu_s = wire::take<double>(payload);
        planned_.peak_rss_bytes = wire::take<double>(payload);
        deadline_ = Clock::now() +
                    std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.limits.wall_s));
        break;
      case frames::kTrace:
        planned_.traces.push_back(wire::trace_from(payload));
        break;
      case frames::kRecorded: {
        const double value = wire::take<double>(payload);
        planned_.record(std::string(payload), value);
        break;
      }
      case frames::kProgressed:
        if (options_.progress) options_.progress(wire::take<double>(payload));
        break;
      case frames::kFailed: {
        const auto outcome = static_cast<Outcome>(wire::take<char>(payload));
        kill_with(outcome, outcome == Outcome::out_of_memory ? memory_text() : std::string(payload));
        break;
      }
      case frames::kEnd:
        ended_ = true;
        break;
      default:
        throw std::runtime_error(fmt::format("a message of unknown type {}", static_cast<int>(type)));
    }
  }

  void reap(int flags) {
    int status = 0;
    pid_t got = 0;
    do got = ::waitpid(pid_, &status, flags);
    while (got < 0 && errno == EINTR);
    if (got == 0) return;
    reaped_ = true;
    if (got != pid_) return;
    if (WIFEXITED(status)) exit_code_ = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) signal_ = WTERMSIG(status);
  }

  void judge() {
    if (ended_ && (has_result_ || failed_)) return;  // how the child ended after that was caused by the parent
    if (failed_) return;                             // killed by the parent
    planned_.path = has_result_ ? std::nullopt : std::move(planned_.path);
    if (signal_ != 0) {
      planned_.outcome = Outcome::crash;
      planned_.signal = signal_;
      planned_.reason = signal_text(signal_);
    } else {
      planned_.outcome = Outcome::error;
      planned_.exit_code = exit_code_;
      planned_.reason =
          exit_code_ != 0 ? fmt::format("exited with code {}", exit_code_) : "its process ended without a result";
    }
  }

  pid_t pid_;
  int fd_;
  const IsolationOptions& options_;
  std::string statm_;
  double rss_limit_;
  wire::FrameReader frames_;
  Clock::time_point deadline_;
  Planned planned_;
  bool closed_ = false, ended_ = false, reaped_ = false, failed_ = false, has_result_ = false;
  int exit_code_ = 0, signal_ = 0;
};

}  // namespace

void Planned::record(const std::string& name, double value) {
  for (auto& [known, old] : records)
    if (known == name) {
      old = value;
      return;
    }
  records.emplace_back(name, value);
}

void kill_running_planner() {
  if (running_group > 0) ::kill(-static_cast<pid_t>(running_group), SIGKILL);
}

Planned plan_isolated(const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem,
                      const IsolationOptions& options) {
  const Log log(options.log_file);
  wire::Pipe pipe = wire::make_pipe();
  std::fflush(nullptr);
  const pid_t parent = ::getpid();
  const double rss_before = statm_bytes("/proc/self/statm", true);
  const pid_t pid = ::fork();
  if (pid < 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (pid == 0) { be_planner(make, problem, options, {parent, log.number(), pipe.write.number()}); }
  ::setpgid(pid, pid);  // in both processes, so that no kill comes too early
  running_group = static_cast<std::sig_atomic_t>(pid);
  pipe.write.close();
  Planned planned = Supervisor(pid, pipe.read.number(), options, rss_before).watch();
  running_group = 0;
  return planned;
}

}  // namespace oxturn

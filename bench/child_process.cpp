// Decisions  1. Memory is limited twice: address space by the kernel (so that work which allocates too much gets
//               bad_alloc and can report it), memory of the whole tree of processes by the parent every 10 ms (for work
//               that never sees bad_alloc, and for sanitizers, which reserve terabytes of address space). The child
//               counts with what it has grown since the fork, its own children with the memory that is theirs alone.
//            2. Where the kernel lets us, the child is in a control group of its own, which tells what belongs to it
//               and kills all of it at once. Elsewhere its descendants are searched for. A daemon's parent is gone, so
//               it is adopted (PR_SET_CHILD_SUBREAPER) and counts as a descendant too; with a control group it is
//               adopted as well, because someone must reap it.
//            3. A SIGKILL that the parent did not send is the kernel's, if the kernel's count of out-of-memory kills
//               has grown meanwhile.
//            4. The child ends by _exit: nothing of the parent (atexit, destructors, buffers) happens twice.
#include "bench/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
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
#include <ctime>
#include <new>
#include <optional>
#include <stdexcept>

#include "algorithms/context.hpp"
#include "base/heap.hpp"
#include "base/sanitized.hpp"
#include "base/text.hpp"
#include "bench/control_group.hpp"
#include "bench/process_info.hpp"
#include "bench/wire.hpp"

namespace oxturn {
namespace {

using Clock = std::chrono::steady_clock;

constexpr rlim_t kLogBytes = rlim_t{64} << 20;
constexpr std::chrono::milliseconds kWatch{10};  // between two readings of memory and processor time
constexpr double kReserved = 0.75;               // of the memory limit: address space for the heap
constexpr int kKillRounds = 1000;                // processes may be started while others are killed

volatile std::sig_atomic_t running_group = 0;        // process group of the child, or 0
volatile std::sig_atomic_t running_group_kill = -1;  // ControlGroup::kill_descriptor(), or -1

// --- the child's side ----------------------------------------------------------------------------------------

struct Birth {
  pid_t parent = 0;
  int log = -1;                         // takes what the work prints; -1: it is dropped
  int pipe = -1;                        // takes the frames
  const ControlGroup* group = nullptr;  // to enter; nullptr: there is none
};

void default_signals() {
  // Sanitizers turn signals into exit codes; the outcome `crash` needs the signal.
  for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    std::signal(s, SIG_DFL);
  std::signal(SIGXFSZ, SIG_IGN);  // work that prints too much loses its print, not its result
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void redirect(const Birth& birth) {
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nothing, 0);
  ::dup2(birth.log >= 0 ? birth.log : nothing, 1);
  ::dup2(birth.log >= 0 ? birth.log : nothing, 2);
  // Nothing else of the parent's stays open: a process that the work leaves behind must not hold its pipes.
  ::close_range(3, static_cast<unsigned>(birth.pipe) - 1, 0);
  ::close_range(static_cast<unsigned>(birth.pipe) + 1, ~0U, 0);
}

void set_soft_limit(int resource, double value) {
  rlimit limit{};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &limit);
  if (value < static_cast<double>(limit.rlim_max)) limit.rlim_cur = static_cast<rlim_t>(value);
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/// A limit of one byte, because the kernel does not apply a limit of none where dumps are piped to a program: one byte
/// stops these too (Linux, fs/coredump.c).
void disable_core_dumps() {
  rlimit limit{};
  ::getrlimit(RLIMIT_CORE, &limit);
  limit.rlim_cur = limit.rlim_max = std::min<rlim_t>(1, limit.rlim_max);
  ::setrlimit(RLIMIT_CORE, &limit);
}

void prepare(const ChildTask& task, const Birth& birth) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != birth.parent) ::_exit(1);  // the parent died before the line above
  default_signals();
  redirect(birth);
  disable_core_dumps();
  if (!task.writes_results) set_soft_limit(RLIMIT_FSIZE, static_cast<double>(kLogBytes));
  if (!kSanitized) set_soft_limit(RLIMIT_AS, address_space_bytes(::getpid()) + task.limits.memory_mb * kMega);
  reserve_heap(kReserved * task.limits.memory_mb * kMega);
}

void fail(int fd, Outcome outcome, const char* what, int exit_code = 0, int signal = 0) {
  // Built on the stack: memory may be what is lacking.
  constexpr std::size_t kHead = 1 + 2 * sizeof(int);
  char message[kHead + 2000];
  message[0] = static_cast<char>(outcome);
  std::memcpy(message + 1, &exit_code, sizeof exit_code);
  std::memcpy(message + 1 + sizeof exit_code, &signal, sizeof signal);
  const std::size_t size = std::min<std::size_t>(std::strlen(what), sizeof message - kHead);
  std::copy_n(what, size, message + kHead);
  wire::send(fd, child_frames::kFailed, {message, kHead + size});
}

[[noreturn]] void be_child(const ChildTask& task, const Birth& birth) {
  prepare(task, birth);
  const int fd = birth.pipe;
  try {
    if (birth.group != nullptr) birth.group->enter();
    task.work(fd);
  } catch (const Infeasible& e) { fail(fd, Outcome::infeasible, e.what()); } catch (const Unsupported& e) {
    fail(fd, Outcome::unsupported, e.what());
  } catch (const WorkEnded& e) { fail(fd, e.outcome, e.what(), e.exit_code, e.signal); } catch (const std::bad_alloc&) {
    fail(fd, Outcome::out_of_memory, "");
  } catch (const std::exception& e) { fail(fd, Outcome::error, e.what()); } catch (...) {
    fail(fd, Outcome::error, "threw something that is not a std::exception");
  }
  wire::send(fd, child_frames::kEnd, "");
  std::fflush(nullptr);  // what the work has printed; the parent's own buffers were flushed before the fork
  ::_exit(0);
}

// --- the parent's side ---------------------------------------------------------------------------------------

/// While a child runs, a signal that ends this process ends the child's process group first. Handlers that a caller has
/// installed stay.
class KillOnSignal {
 public:
  KillOnSignal() {
    for (const int s : kSignals) {
      struct sigaction now {};
      if (::sigaction(s, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
      std::signal(s, kill_and_end);
      ours_.push_back(s);
    }
  }
  ~KillOnSignal() {
    for (const int s : ours_) std::signal(s, SIG_DFL);
  }
  KillOnSignal(const KillOnSignal&) = delete;

 private:
  static constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
  static void kill_and_end(int s) {
    kill_running_child();
    std::signal(s, SIG_DFL);
    std::raise(s);
  }
  std::vector<int> ours_;
};

// The log is kept only if something was printed.
class Log {
 public:
  explicit Log(std::string file) : file_(std::move(file)) {
    if (file_.empty() || file_ == kLogToStandardError) return;
    fd_ = wire::Descriptor(::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666));
    if (!fd_.open()) throw std::runtime_error(fmt::format("cannot write '{}': {}", file_, std::strerror(errno)));
  }
  Log(const Log&) = delete;
  ~Log() {
    struct stat about {};
    if (fd_.open() && ::fstat(fd_.number(), &about) == 0 && about.st_size == 0) ::unlink(file_.c_str());
  }
  int number() const { return file_ == kLogToStandardError ? STDERR_FILENO : fd_.number(); }

 private:
  std::string file_;
  wire::Descriptor fd_;
};

class Supervisor {
 public:
  Supervisor(pid_t pid, int fd, const ChildTask& task, const ControlGroup* group, const Orphans& orphans)
      : pid_(pid),
        fd_(fd),
        task_(task),
        group_(group),
        orphans_(orphans),
        resident_before_(resident_bytes(::getpid())),
        frames_(static_cast<std::uint64_t>(task.limits.memory_mb * kMega)) {
    restart();
  }

  ChildReport watch() {
    while (!ended_ && !reaped_ && !failed_) {
      const auto now = Clock::now();
      if (check_limits(now)) break;
      if (!wait_and_read(now)) break;
    }
    ::kill(-pid_, SIGKILL);  // processes that the work has left behind in its group, too
    if (!reaped_) reap(0);
    conclude();
    if (!task_.what.empty() && !said_failed_ && !report_.reason.empty())
      report_.reason = task_.what + ": " + report_.reason;
    return std::move(report_);
  }

 private:
  void restart() {
    deadline_ =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(task_.limits.wall_s));
    cpu_limit_ = task_.limits.cpu_s > 0 ? cpu_seconds(pid_) + task_.limits.cpu_s : 0;
  }

  void stop_with(Outcome outcome, std::string reason) {
    failed_ = true;
    report_.outcome = outcome;
    report_.reason = std::move(reason);
  }

  std::string memory_text() const {
    return fmt::format("needs more than {} MB of memory", to_decimal(task_.limits.memory_mb));
  }

  /// The processes that the child has started, daemons included.
  std::vector<pid_t> others() const {
    std::vector<pid_t> all;
    if (group_ != nullptr) {
      all = group_->processes();
      std::erase(all, pid_);
      return all;
    }
    all = descendants(pid_);
    for (const pid_t orphan : orphans_.adopted({pid_})) {
      all.push_back(orphan);
      const std::vector<pid_t> more = descendants(orphan);
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }

  /// Memory of the child beyond what it had at the fork, and all of the others.
  double memory_grown() const {
    double grown = resident_bytes(pid_) - resident_before_;
    for (const pid_t p : others()) grown += private_bytes(p);
    return grown;
  }

  double cpu_used() const {
    double used = cpu_seconds(pid_);
    for (const pid_t p : others()) used += cpu_seconds(p);
    return used;
  }

  bool check_limits(Clock::time_point now) {
    if (now >= deadline_)
      stop_with(Outcome::timeout, fmt::format("no result after {} s", to_decimal(task_.limits.wall_s)));
    else if (now >= next_check_) {
      next_check_ = now + kWatch;
      if (memory_grown() > task_.limits.memory_mb * kMega)
        stop_with(Outcome::out_of_memory, memory_text());
      else if (cpu_limit_ > 0 && cpu_used() > cpu_limit_)
        stop_with(Outcome::timeout,
                  fmt::format("no result after {} s of processor time", to_decimal(task_.limits.cpu_s)));
    }
    return failed_;
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
      stop_with(Outcome::out_of_memory, "its result does not fit into the memory left beside the harness");
    } catch (const std::exception& e) { stop_with(Outcome::error, fmt::format("bad protocol: {}", e.what())); }
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
    if (type == child_frames::kEnd) {
      ended_ = true;
    } else if (type == child_frames::kRestart) {
      restart();
    } else if (type == child_frames::kFailed) {
      const auto outcome = static_cast<Outcome>(wire::take<char>(payload));
      said_failed_ = true;
      report_.outcome = outcome;
      report_.exit_code = wire::take<int>(payload);
      report_.signal = wire::take<int>(payload);
      report_.reason = outcome == Outcome::out_of_memory ? memory_text() : std::string(payload);
    } else {
      task_.receive(type, payload);
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

  void conclude() {
    if (failed_ || ended_ || said_failed_) return;  // how the child ended after that was caused by the parent
    if (signal_ == SIGKILL && group_ != nullptr && group_->out_of_memory_kills() > 0) {
      report_.outcome = Outcome::out_of_memory;
      report_.signal = signal_;
      report_.reason = memory_text();
    } else if (signal_ == SIGKILL && out_of_memory_kills() > kills_before_) {
      report_.outcome = Outcome::out_of_memory;
      report_.signal = signal_;
      report_.reason = "killed by the kernel, which ran out of memory";
    } else if (signal_ != 0) {
      report_.outcome = Outcome::crash;
      report_.signal = signal_;
      report_.reason = signal_text(signal_) + (signal_ == SIGKILL ? ", not by oxturn" : "");
    } else {
      report_.outcome = Outcome::error;
      report_.exit_code = exit_code_;
      report_.reason =
          exit_code_ != 0 ? fmt::format("exited with code {}", exit_code_) : "its process ended without a result";
    }
  }

  pid_t pid_;
  int fd_;
  const ChildTask& task_;
  const ControlGroup* group_;
  const Orphans& orphans_;
  double resident_before_;
  unsigned long kills_before_ = out_of_memory_kills();
  wire::FrameReader frames_;
  Clock::time_point deadline_, next_check_;
  double cpu_limit_ = 0;
  ChildReport report_;
  bool closed_ = false, ended_ = false, reaped_ = false, failed_ = false, said_failed_ = false;
  int exit_code_ = 0, signal_ = 0;
};

}  // namespace

std::string signal_text(int s) {
  const char* name = ::sigabbrev_np(s);
  const char* meaning = ::sigdescr_np(s);
  std::string text = fmt::format("killed by SIG{}", name != nullptr ? name : std::to_string(s));
  if (meaning != nullptr) {
    std::string lower = meaning;
    if (lower.size() > 1 && (lower[1] < 'A' || lower[1] > 'Z'))
      lower[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(lower[0])));
    text += fmt::format(" ({})", lower);
  }
  return text;
}

Orphans::Orphans() : before_(children_of(::getpid())) { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }

std::vector<int> Orphans::adopted(const std::vector<int>& own) const {
  std::vector<int> all = children_of(::getpid());
  std::erase_if(all, [&](int p) { return std::ranges::count(own, p) + std::ranges::count(before_, p) > 0; });
  return all;
}

void Orphans::kill_all(const std::vector<int>& own) const {
  for (int round = 0; round < kKillRounds; ++round) {
    const std::vector<int> orphans = adopted(own);
    for (const pid_t orphan : orphans) {
      for (const pid_t p : descendants(orphan)) ::kill(p, SIGKILL);
      ::kill(orphan, SIGKILL);
      while (::waitpid(orphan, nullptr, 0) < 0 && errno == EINTR) {}
    }
    if (orphans.empty()) return;
  }
}

ChildReport run_child(const ChildTask& task) {
  const Log log(task.log_file);
  wire::Pipe pipe = wire::make_pipe();
  std::fflush(nullptr);
  const pid_t parent = ::getpid();
  const Orphans orphans;
  const KillOnSignal guard;
  const std::optional<ControlGroup> group =
      task.control_group ? ControlGroup::make(task.limits.memory_mb * kMega) : std::nullopt;
  const ControlGroup* const entered = group ? &*group : nullptr;
  const pid_t pid = ::fork();
  if (pid < 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (pid == 0) be_child(task, {parent, log.number(), pipe.write.number(), entered});
  ::setpgid(pid, pid);  // in both processes, so that no kill comes too early
  running_group = static_cast<std::sig_atomic_t>(pid);
  running_group_kill = group ? group->kill_descriptor() : -1;
  pipe.write.close();
  ChildReport report = Supervisor(pid, pipe.read.number(), task, entered, orphans).watch();
  running_group = 0;
  running_group_kill = -1;
  if (group) group->kill();
  orphans.kill_all({});
  return report;
}

void kill_running_child() {
  if (running_group > 0) ::kill(-static_cast<pid_t>(running_group), SIGKILL);
  if (running_group_kill >= 0) { [[maybe_unused]] const ssize_t done = ::write(running_group_kill, "1", 1); }
}

void reset_peak() {
  const int fd = ::open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
  if (fd < 0) return;  // then the peak is that since the fork, which is nearly the same
  [[maybe_unused]] const ssize_t put = ::write(fd, "5", 1);
  ::close(fd);
}

double peak_bytes() {
  rusage usage{};
  const int fd = ::open("/proc/self/status", O_RDONLY | O_CLOEXEC);
  char text[4096] = {};
  if (fd >= 0) {
    const ssize_t got = ::read(fd, text, sizeof text - 1);
    text[got > 0 ? got : 0] = 0;
    ::close(fd);
  }
  const char* line = std::strstr(text, "VmHWM:");
  unsigned long kib = 0;
  if (line != nullptr && std::sscanf(line + 6, " %lu", &kib) == 1) return static_cast<double>(kib) * 1024;
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

double own_cpu_seconds() {
  timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  rusage children{};
  ::getrusage(RUSAGE_CHILDREN, &children);
  const auto seconds = [](const timeval& v) {
    return static_cast<double>(v.tv_sec) + 1e-6 * static_cast<double>(v.tv_usec);
  };
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec) + seconds(children.ru_utime) +
         seconds(children.ru_stime);
}

}  // namespace oxturn

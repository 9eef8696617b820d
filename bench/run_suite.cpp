// The parent process of a suite: hands units of work to forked workers, and writes the rows they send in suite order.
//
// Decisions  1. One thread. Workers are processes, so a defect of the harness (a generator or metric that crashes)
//               costs the run at hand, which becomes `infrastructure`; a new worker takes over the rest of the unit.
//            2. A row is held back until all rows before it are there, so the file does not depend on -j.
//            3. There are as many units as problems (the map is made and eroded once), or, with fewer problems than
//               jobs, each problem's runs in as many parts as there are jobs.
//            4. Resuming appends new rows as they come (nothing that was there can be lost) and puts the file in
//               suite order at the end.
#include "bench/run_suite.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <list>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/csv.hpp"
#include "base/text.hpp"
#include "bench/build_info.hpp"
#include "bench/child_process.hpp"
#include "bench/control_group.hpp"
#include "bench/process_info.hpp"
#include "bench/progress.hpp"
#include "bench/run_lines.hpp"
#include "bench/session.hpp"
#include "bench/verdict.hpp"
#include "bench/wire.hpp"
#include "bench/worker.hpp"

namespace oxturn {

namespace {

constexpr std::uint64_t kLongestMessage = 1 << 24;

volatile std::sig_atomic_t interrupted = 0;
extern "C" void note_interrupt(int) { interrupted = 1; }
extern "C" void end_worker(int) {
  kill_running_child();
  ::_exit(1);
}

// Ctrl-C and kill end a sweep in good order while this lives.
class Interrupts {
 public:
  Interrupts() {
    interrupted = 0;
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, &old_int_);
    ::sigaction(SIGTERM, &action, &old_term_);
  }
  ~Interrupts() {
    ::sigaction(SIGINT, &old_int_, nullptr);
    ::sigaction(SIGTERM, &old_term_, nullptr);
  }
  Interrupts(const Interrupts&) = delete;

 private:
  struct sigaction old_int_ {
  }, old_term_{};
};

/// Clusters end a job by sending SIGTERM to all of its processes at once, so a planner that it ended tells that this
/// process will be told to stop, too, if it has not been yet.
bool ended_with_us(const Row& row) {
  constexpr int kRounds = 20;
  constexpr std::chrono::milliseconds kPause{10};
  if (row.get("signal") != std::to_string(SIGTERM)) return false;
  for (int k = 0; k < kRounds && interrupted == 0; ++k) std::this_thread::sleep_for(kPause);
  return interrupted != 0;
}

/// Of the runs in `range`, from the first up to before the second.
std::vector<Unit> units_of(const Suite& suite, std::size_t cells, int jobs, std::pair<std::size_t, std::size_t> range) {
  const auto [first, last] = range;
  if (first >= last) return {};
  const std::size_t runs = cells / (suite.maps.size() * suite.robots.size());  // of one problem
  const std::size_t begin = first / runs, end = (last - 1) / runs + 1;         // problems
  const std::size_t wanted = end - begin < static_cast<std::size_t>(jobs) ? static_cast<std::size_t>(jobs) : 1;
  std::vector<Unit> units;
  for (std::size_t p = begin; p < end; ++p) {
    const std::size_t low = std::max(first, p * runs), high = std::min(last, (p + 1) * runs);
    const std::size_t parts = std::min(wanted, high - low);
    for (std::size_t k = 0; k < parts; ++k)
      units.push_back({low + (high - low) * k / parts, low + (high - low) * (k + 1) / parts});
  }
  return units;
}

using Clock = std::chrono::steady_clock;

struct Worker {
  pid_t pid = 0;
  wire::Descriptor fd;
  Unit rest;  // what it has not finished
  Unit given;
  bool ready = false;             // its problem is set up
  Clock::time_point deadline;     // for setting it up
  double resident_before = 0;     // bytes
  std::optional<Verdict> breach;  // setting up the problem broke a limit
  std::string trouble;            // what it said when it gave up
  wire::FrameReader frames{kLongestMessage};
};

constexpr int kWatchMs = 20;       // between two looks at workers that set up their problems
constexpr int kPatienceMs = 1000;  // otherwise: time to notice an interrupt

class SuiteRun {
 public:
  SuiteRun(const Suite& suite, const Registry& registry, const SuiteRunOptions& options)
      : options_(options),
        columns_(run_columns(registry.metrics)),
        session_(suite, registry.planners, registry.metrics, options),
        metrics_(options.folder, "metrics.csv", kMetricsHeader, rewrites()),
        trace_(options.folder, "trace.csv", kTraceHeader, rewrites()),
        cells_(cells_of(suite)),
        range_(options.shard.range(cells_.size())),
        earlier_(summary(session_)),
        work_{suite, registry, options_, cells_, earlier_, known_maps_},
        progress_(range_.second - range_.first, options.progress),
        next_(range_.first) {
    for (const MapSpec& map : suite.maps) {
      if (!map.content) continue;
      for (const std::string& remark : map.content->remarks) progress_.remark(fmt::format("{}: {}", map.file, remark));
    }
    if (const double load = load_average(); load > 0.5)
      progress_.remark(fmt::format("the machine is busy (load {:.1f}): times will be less certain", load));
    for (const Unit& unit : units_of(suite, cells_.size(), options.jobs, range_)) waiting_.push_back(unit);
  }

  ~SuiteRun() { stop(); }
  SuiteRun(const SuiteRun&) = delete;

  void run() {
    const Interrupts guard;
    while ((!waiting_.empty() || !workers_.empty()) && interrupted == 0) {
      while (!waiting_.empty() && workers_.size() < static_cast<std::size_t>(options_.jobs)) start_worker();
      listen();
      write_ready();
    }
    if (interrupted != 0) give_up();
    if (rewrites()) put_in_order();
  }

 private:
  struct Run {
    bool begun = false, done = false, kept = false;
    std::string id;
    Row row;                                  // what is known of it so far
    std::vector<std::string> metrics, trace;  // lines of metrics.csv and trace.csv
  };

  /// There are rows of earlier sessions, among which the new ones are put in order at the end.
  bool rewrites() const { return !session_.earlier().empty(); }

  static std::map<std::string, Earlier> summary(const Session& session) {
    std::map<std::string, Earlier> all;
    for (const auto& [id, rows] : session.earlier()) {
      const Outcome last = rows.back().outcome();
      all[id] = {static_cast<int>(rows.size()), !is_unfinished(last)};
    }
    return all;
  }

  void start_worker() {
    const Unit unit = waiting_.front();
    wire::Pipe pipe = wire::make_pipe();
    std::fflush(nullptr);
    const pid_t parent = ::getpid();
    // A SIGTERM that comes before the child has its own handler must wait for it.
    sigset_t term, before;
    sigemptyset(&term);
    sigaddset(&term, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &term, &before);
    const pid_t pid = ::fork();
    if (pid == 0) std::signal(SIGTERM, end_worker);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    if (pid < 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
    if (pid == 0) be_worker(unit, parent, pipe.write.number());
    waiting_.pop_front();
    Worker& worker = workers_.emplace_back();
    worker.pid = pid;
    worker.fd = std::move(pipe.read);
    worker.rest = worker.given = unit;
    worker.resident_before = resident_bytes(parent);
    worker.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                         std::chrono::duration<double>(work_.suite.limits.wall_s));
  }

  [[noreturn]] void be_worker(const Unit& unit, pid_t parent, int fd) const {
    std::signal(SIGINT, SIG_IGN);  // the parent decides
    ::setpgid(0, 0);               // a planner that kills its parent's group must not end the whole suite
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1);
    ::close_range(3, static_cast<unsigned>(fd) - 1, 0);
    ::close_range(static_cast<unsigned>(fd) + 1, ~0U, 0);
    int code = 0;
    try {
      run_unit(work_, unit, fd);
    } catch (const std::exception& e) {
      code = 1;
      try {
        send_message(fd, messages::kBroken, 0, e.what());
      } catch (const std::exception&) {
        code = 2;  // the pipe is closed: only the exit code is left
      }
    }
    ::_exit(code);
  }

  /// Stops workers whose problem takes too long or too much memory to set up.
  void check_limits() {
    const Limits& limits = work_.suite.limits;
    for (Worker& worker : workers_) {
      if (worker.ready || worker.breach) continue;
      const std::string what = "setting up the problem: ";
      if (Clock::now() >= worker.deadline)
        worker.breach = {Outcome::timeout, what + fmt::format("no result after {} s", to_decimal(limits.wall_s))};
      else if (limits.cpu_s > 0 && cpu_seconds(worker.pid) > limits.cpu_s)
        worker.breach = {Outcome::timeout,
                         what + fmt::format("no result after {} s of processor time", to_decimal(limits.cpu_s))};
      else if (resident_bytes(worker.pid) - worker.resident_before > limits.memory_mb * kMega)
        worker.breach = {Outcome::out_of_memory,
                         what + fmt::format("needs more than {} MB of memory", to_decimal(limits.memory_mb))};
      if (worker.breach) ::kill(worker.pid, SIGKILL);  // its pipe closes then, which listen() notices
    }
  }

  void listen() {
    std::vector<pollfd> fds;
    for (const Worker& worker : workers_) fds.push_back({worker.fd.number(), POLLIN, 0});
    const bool all_ready = std::all_of(workers_.begin(), workers_.end(), [](const Worker& w) { return w.ready; });
    const int changed = ::poll(fds.data(), fds.size(), all_ready ? kPatienceMs : kWatchMs);
    if (!all_ready) check_limits();
    if (changed <= 0) return;
    std::size_t i = 0;
    for (auto worker = workers_.begin(); worker != workers_.end(); ++i) {
      const bool ready = fds[i].revents != 0;
      if (ready && receive(*worker) == wire::FrameReader::State::closed) {
        reap(*worker);
        worker = workers_.erase(worker);
      } else {
        ++worker;
      }
    }
  }

  wire::FrameReader::State receive(Worker& worker) {
    return worker.frames.read(worker.fd.number(), [&](char type, std::string_view payload) {
      const auto index = static_cast<std::size_t>(wire::take<std::uint64_t>(payload));
      if (type == messages::kBroken)
        worker.trouble = payload;
      else if (type == messages::kRemark)
        progress_.remark(std::string(payload));
      else if (type == messages::kReady)
        worker.ready = true;
      else
        take(worker, index, type, payload);
    });
  }

  void take(Worker& worker, std::size_t index, char type, std::string_view payload) {
    Run& run = runs_[index];
    if (type == messages::kBegun) {
      run.begun = true;
      run.row = row_from(payload);
      if (!run.row.get("map_sha256").empty()) known_maps_.emplace(cells_[index].map, map_cells_of(run.row));
    } else if (type == messages::kMetrics || type == messages::kTrace) {
      (type == messages::kMetrics ? run.metrics : run.trace) = lines_from(payload);
    } else if (type == messages::kKept) {
      run.done = run.kept = true;
      run.id = payload;
      worker.rest.first = index + 1;
      progress_.kept();
    } else if (Row row = row_from(payload); !ended_with_us(row)) {
      run.done = true;
      run.row = std::move(row);
      run.id = run.row.get("run_id");
      worker.rest.first = index + 1;
      progress_.ran(run.row.outcome());
    }
  }

  // The worker has closed its pipe: it has finished, or it died.
  void reap(Worker& worker) {
    int status = 0;
    while (::waitpid(worker.pid, &status, 0) < 0 && errno == EINTR) {}
    worker.pid = 0;
    std::vector<pid_t> others;
    for (const Worker& other : workers_)
      if (other.pid > 0) others.push_back(other.pid);
    orphans_.kill_all(others);
    if (worker.breach) {
      for (; worker.rest.first < worker.rest.last; ++worker.rest.first)
        finish(worker.rest.first, worker.breach->outcome, worker.breach->reason);
      return;
    }
    if (worker.rest.first >= worker.rest.last) return;
    std::string reason = "oxturn's own process ended early";
    if (WIFSIGNALED(status)) reason = fmt::format("oxturn's own process was killed by signal {}", WTERMSIG(status));
    if (WIFEXITED(status)) reason = fmt::format("oxturn's own process exited with code {}", WEXITSTATUS(status));
    if (!worker.trouble.empty()) reason += ": " + worker.trouble;
    const bool in_a_run = runs_[worker.rest.first].begun;
    // Died before its first run: making the problem did it, and would do it again.
    const bool hopeless = !in_a_run && worker.rest.first == worker.given.first;
    const std::size_t lost = hopeless ? worker.rest.last : worker.rest.first + 1;
    for (; worker.rest.first < lost; ++worker.rest.first) finish(worker.rest.first, Outcome::infrastructure, reason);
    if (worker.rest.first < worker.rest.last) waiting_.push_front(worker.rest);
  }

  void finish(std::size_t index, Outcome outcome, const std::string& reason) {
    Run& run = runs_[index];
    if (!run.begun) run.row = blank_row(work_, index);
    run.row.cells.set("outcome", to_text(outcome));
    run.row.cells.set("reason", reason);
    run.done = true;
    run.id = run.row.get("run_id");
    progress_.ran(outcome);
  }

  void append(const Run& run) {
    metrics_.append(run.id, run.metrics);
    trace_.append(run.id, run.trace);
    session_.append(csv_line(run.row, columns_));
  }

  void write_ready() {
    for (auto at = runs_.find(next_); at != runs_.end() && at->second.done; at = runs_.find(++next_)) {
      if (!at->second.kept) append(at->second);
      if (!rewrites()) runs_.erase(at);  // so that memory does not grow with the rows
    }
  }

  void stop() {
    for (Worker& worker : workers_) ::kill(worker.pid, SIGTERM);
    for (Worker& worker : workers_) {
      while (::waitpid(worker.pid, nullptr, 0) < 0 && errno == EINTR) {}
    }
    workers_.clear();
    orphans_.kill_all({});
    remove_stale_control_groups();
  }

  [[noreturn]] void give_up() {
    stop();
    std::size_t written = next_ - range_.first;
    for (auto& [i, run] : runs_) {
      if (i < next_) continue;
      if (run.done) ++written;
      if (!run.done && run.begun) finish(i, Outcome::cancelled, "interrupted");
      if (run.done && !run.kept) append(run);
    }
    throw Interrupted(fmt::format("interrupted after {} of {} runs; the same command with --resume does the rest",
                                  written, range_.second - range_.first));
  }

  void put_in_order() {
    std::string lines;
    std::size_t lost = 0;
    for (const auto& [id, earlier] : earlier_) lost += earlier.done ? 1 : 0;
    for (std::size_t i = range_.first; i < range_.second; ++i) {
      const Run& run = runs_[i];
      const auto before = session_.earlier().find(run.id);
      if (before != session_.earlier().end()) {
        if (earlier_.at(run.id).done) --lost;
        for (const Row& row : before->second) lines += csv_line(row, columns_);
      }
      if (!run.kept) lines += csv_line(run.row, columns_);
    }
    if (lost > 0) progress_.remark(fmt::format("dropped the rows of {} runs whose maps have changed since", lost));
    session_.rewrite(lines);
    std::vector<std::string> ids;
    for (std::size_t i = range_.first; i < range_.second; ++i) ids.push_back(runs_[i].id);
    metrics_.put_in_order(ids);
    trace_.put_in_order(ids);
  }

  const Orphans orphans_;
  const SuiteRunOptions& options_;
  Columns columns_;
  Session session_;
  RunLines metrics_, trace_;
  std::vector<SuiteCell> cells_;
  std::pair<std::size_t, std::size_t> range_;  // of the shard: first run, and one past the last
  std::map<std::size_t, Run> runs_;            // begun, and not yet written; all of them if rewrites()
  std::map<std::string, Earlier> earlier_;
  std::map<std::size_t, MapCells> known_maps_;  // by index, for the workers that start later
  Work work_;
  Progress progress_;
  std::deque<Unit> waiting_;
  std::list<Worker> workers_;
  std::size_t next_;  // the first run that is not written
};

}  // namespace

void run_suite_into_folder(const Suite& suite, const Registry& registry, const SuiteRunOptions& options) {
  if (options.jobs < 1) throw std::invalid_argument(fmt::format("jobs is {}, expected 1 or more", options.jobs));
  if (options.folder.empty()) throw std::invalid_argument("no folder for the results; name one with -o");
  Suite named = suite;
  name_maps(named.maps);
  Registry all_planners = registry;
  for (const PlannerInfo& program : suite.programs) all_planners.planners.add(program);
  for (const PlannerSpec& spec : named.planners) all_planners.planners.find(spec.name);
  SuiteRun(named, all_planners, options).run();
}

Results run_suite(const Suite& suite, const Registry& registry, const SuiteRunOptions& options) {
  run_suite_into_folder(suite, registry, options);
  return read_results(options.folder);
}

}  // namespace oxturn

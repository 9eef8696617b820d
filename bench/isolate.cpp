#include "bench/isolate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "base/heap.hpp"
#include "base/text.hpp"
#include "bench/process_info.hpp"
#include "bench/wire.hpp"

namespace oxturn {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kProgress{50};  // least time between two progress messages
constexpr double kDeadline = 0.95;                  // of which planners are told, of the wall time

/// Types of the frames (wire.hpp) that a planning child sends.
namespace frames {
constexpr char kPublished = 'P';   // path
constexpr char kResult = 'R';      // path
constexpr char kNothing = 'N';     // no path by the deadline
constexpr char kEnded = 'L';       // the path is what there was at the deadline
constexpr char kMeasures = 'M';    // wall s, cpu s, growth of resident memory in bytes: plan() is over
constexpr char kTrace = 'D';       // one trace
constexpr char kRecorded = 'V';    // value, name: Context::record
constexpr char kProgressed = 'G';  // fraction
constexpr char kPromised = 'Q';    // region
constexpr char kMapFile = 'F';     // a map's file
}  // namespace frames

/// A planner may record and draw without end; what goes beyond the bounds is not sent.
class PlannerChild {
 public:
  PlannerChild(int fd, const IsolationOptions& options) : fd_(fd), options_(options) {}

  void run(const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem) {
    const auto planner = make();
    for (int i = 0; i < options_.warm_ups; ++i) {
      Context context(options_.seed, deadline_s());
      (void)planner->plan(problem, context);
      wire::send(fd_, child_frames::kRestart, "");
    }
    Context context(options_.seed, deadline_s(), sinks());
    start_measuring();
    try {
      const Path path = planner->plan(problem, context);
      send_measures();
      if (promised_) wire::send(fd_, frames::kPromised, wire::pack(promised_()));
      const bool ended = context.cancelled();
      if (ended) wire::send(fd_, frames::kEnded, "");
      if (path.legs.empty() && ended)
        wire::send(fd_, frames::kNothing, "");
      else
        wire::send_path(fd_, frames::kResult, path);
    } catch (...) {
      send_measures();
      throw;
    }
  }

 private:
  double deadline_s() const { return kDeadline * options_.limits.wall_s; }

  void start_measuring() {
    reset_peak();
    peak_memory_.reset();
    resident_before_ = resident_bytes(::getpid());
    cpu_before_ = own_cpu_seconds();
    // Programs that were started before and are waited for later count with all of their time then.
    for (const pid_t p : descendants(::getpid())) cpu_before_ += precise_cpu_seconds(p);
    wall_before_ = Clock::now();
  }

  Context::Sinks sinks() {
    Context::Sinks sinks;
    sinks.publish = [this](const Path& path) { wire::send_path(fd_, frames::kPublished, path); };
    sinks.record = [this](const std::string& name, double value) {
      std::string message;
      wire::put(message, value);
      wire::send(fd_, frames::kRecorded, message + name);
    };
    if (options_.progress) sinks.progress = [this](double fraction) { send_progress(fraction); };
    if (options_.traces) sinks.trace = [this](const Trace& trace) { send_trace(trace); };
    sinks.promise = [this](std::function<Region()> region) { promised_ = std::move(region); };
    sinks.begin = [this] {
      wire::send(fd_, child_frames::kRestart, "");
      start_measuring();
    };
    sinks.peak_memory = [this](double bytes) { peak_memory_ = bytes; };
    return sinks;
  }

  void send_progress(double fraction) {
    if (Clock::now() - last_progress_ < kProgress) return;
    last_progress_ = Clock::now();
    std::string message;
    wire::put(message, fraction);
    wire::send(fd_, frames::kProgressed, message);
  }

  void send_trace(const Trace& trace) {
    if (trace_bytes_ > kMostTraceBytes) return;
    const std::string packed = wire::pack(trace);
    trace_bytes_ += packed.size();
    if (trace_bytes_ <= kMostTraceBytes) wire::send(fd_, frames::kTrace, packed);
  }

  void send_measures() {
    const double wall = std::chrono::duration<double>(Clock::now() - wall_before_).count();
    const double cpu = own_cpu_seconds() - cpu_before_;
    const double growth = peak_memory_.value_or(std::max(0.0, peak_bytes() - resident_before_));
    const double values[3] = {wall, cpu, growth};
    wire::send(fd_, frames::kMeasures, {reinterpret_cast<const char*>(values), sizeof values});
    wire::send(fd_, child_frames::kRestart, "");
  }

  int fd_;
  const IsolationOptions& options_;
  std::function<Region()> promised_;
  Clock::time_point last_progress_, wall_before_;
  std::size_t trace_bytes_ = 0;
  double resident_before_ = 0, cpu_before_ = 0;
  std::optional<double> peak_memory_;
};

/// The parent's side: gathers what the child sends.
class PlannerParent {
 public:
  explicit PlannerParent(const IsolationOptions& options) : options_(options) {}

  void take(char type, std::string_view payload) {
    switch (type) {
      case frames::kPublished:
        planned_.path.reset();  // its memory first
        planned_.path = wire::path_from(payload);
        break;
      case frames::kResult:
        planned_.path.reset();
        result_ = wire::path_from(payload);
        break;
      case frames::kNothing:
        nothing_ = true;
        break;
      case frames::kEnded:
        ended_ = true;
        break;
      case frames::kMeasures:
        planned_.wall_s = wire::take<double>(payload);
        planned_.cpu_s = wire::take<double>(payload);
        planned_.peak_rss_bytes = wire::take<double>(payload);
        break;
      case frames::kTrace:
        planned_.traces.push_back(wire::trace_from(payload));
        break;
      case frames::kRecorded: {
        const double value = wire::take<double>(payload);
        record(std::string(payload), value);
        break;
      }
      case frames::kProgressed:
        if (options_.progress) options_.progress(wire::take<double>(payload));
        break;
      case frames::kPromised:
        planned_.promised = wire::region_from(payload);
        break;
      default:
        throw std::runtime_error("a message of unknown type " + std::to_string(static_cast<int>(type)));
    }
  }

  Planned conclude(const ChildReport& report) {
    planned_.outcome = report.outcome;
    planned_.reason = report.reason;
    planned_.exit_code = report.exit_code;
    planned_.signal = report.signal;
    if (result_) {
      planned_.path = std::move(result_);
      if (ended_ && report.outcome == Outcome::ok)
        planned_.reason = fmt::format("planning ended at the limit of {} s", to_decimal(options_.limits.wall_s));
    } else if (report.outcome == Outcome::ok && nothing_) {
      planned_.outcome = Outcome::timeout;
      planned_.reason = fmt::format("no result after {} s", to_decimal(options_.limits.wall_s));
    } else if (report.outcome == Outcome::ok) {
      planned_.outcome = Outcome::error;
      planned_.reason = "its process ended without a result";
    }
    const bool kept = planned_.outcome == Outcome::ok || planned_.outcome == Outcome::timeout;
    if (!kept) planned_.path.reset();
    return std::move(planned_);
  }

 private:
  void record(std::string name, double value) {
    const auto known = index_.find(name);
    if (known != index_.end()) {
      planned_.records[known->second].second = value;
    } else if (planned_.records.size() < kMostRecords) {
      index_.emplace(name, planned_.records.size());
      planned_.records.emplace_back(std::move(name), value);
    }
  }

  const IsolationOptions& options_;
  Planned planned_;
  std::optional<Path> result_;
  bool nothing_ = false, ended_ = false;      // kNothing or kEnded has come
  std::map<std::string, std::size_t> index_;  // of records
};

}  // namespace

Planned plan_isolated(const std::function<std::unique_ptr<CoveragePlanner>()>& make, const Problem& problem,
                      const IsolationOptions& options) {
  give_back_freed_memory();  // else it would not count when the planner takes it
  PlannerParent parent(options);
  ChildTask task;
  task.limits = options.limits;
  task.log_file = options.log_file;
  task.work = [&](int fd) { PlannerChild(fd, options).run(make, problem); };
  task.receive = [&](char type, std::string_view payload) { parent.take(type, payload); };
  return parent.conclude(run_child(task));
}

ReadResult read_map_isolated(const std::string& file, const Settings& settings, const MapFormats& formats,
                             const Limits& limits) {
  ReadResult result;
  ChildTask task;
  task.limits = limits;
  task.what = "reading " + file;
  task.work = [&](int fd) { wire::send(fd, frames::kMapFile, wire::pack(read_map(file, settings, formats))); };
  task.receive = [&](char, std::string_view payload) { result.file = wire::map_file_from(payload); };
  result.report = run_child(task);
  if (result.report.outcome != Outcome::ok) result.file.reset();
  return result;
}

}  // namespace oxturn

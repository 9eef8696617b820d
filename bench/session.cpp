#include "bench/session.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/files.hpp"
#include "bench/build_info.hpp"
#include "bench/run_id.hpp"
#include "maps/formats.hpp"

namespace oxturn {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const std::string& what, int error) {
  throw std::runtime_error(fmt::format("cannot write '{}': {}", what, std::strerror(error)));
}

// Up to the last line break outside of quotes: what a sweep that was killed while writing has left whole.
std::string whole_lines(const std::string& text) {
  std::size_t end = 0;
  bool in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') in_quotes = !in_quotes;
    if (text[i] == '\n' && !in_quotes) end = i + 1;
  }
  return text.substr(0, end);
}

/// The planners from outside that take part in the suite.
std::vector<OutsideEntry> programs_of(const Suite& suite, const Planners& planners) {
  std::map<std::string, OutsideEntry> programs;
  for (const PlannerSpec& spec : suite.planners)
    for (const PlannerInfo* planner : from_outside(planners.find(spec.name), spec.settings, planners))
      programs[planner->name] = {planner->name, planner->origin, planner->identity};
  std::vector<OutsideEntry> all;
  for (const auto& [name, program] : programs) all.push_back(program);
  return all;
}

std::vector<OutsideEntry> from_plugins(const Metrics& metrics) {
  std::vector<OutsideEntry> all;
  for (const Metric& m : metrics)
    if (!m.identity.empty()) all.push_back({m.name, m.origin, m.identity});
  return all;
}

}  // namespace

void lock_results(const wire::Descriptor& runs_csv, const std::string& folder) {
  if (::flock(runs_csv.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw std::invalid_argument(
        fmt::format("another process is writing to '{}'; wait for it, or choose another folder", folder));
}

Session::Session(const Suite& suite, const Planners& planners, const Metrics& metrics, const SuiteRunOptions& options)
    : columns_(run_columns(metrics)),
      folder_(options.folder),
      file_(options.folder + "/runs.csv"),
      suite_identity_(suite_identity(suite, planners)),
      shard_(options.shard),
      programs_(programs_of(suite, planners)),
      metrics_(from_plugins(metrics)) {
  const bool there = fs::exists(file_);
  if (there && !options.resume)
    throw std::invalid_argument(fmt::format(
        "'{}' already holds results; choose another folder, or --resume to complete or extend them", folder_));
  if (there) take_up(suite);
  std::error_code error;
  const bool tethers =
      std::any_of(suite.robots.begin(), suite.robots.end(), [](const Robot& r) { return r.tether.has_value(); });
  std::vector<std::string> folders{"", "/paths", "/maps", "/logs"};
  if (options.pictures) folders.push_back("/pictures");
  if (options.traces) folders.push_back("/traces");
  if (tethers) folders.push_back("/tethers");
  for (const std::string& folder : folders) {
    fs::create_directories(folder_ + folder, error);
    if (error) cannot_write(folder_ + folder, error.value());
  }
  open();
  describe(suite, options);
}

void Session::open() {
  out_ = wire::Descriptor(::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (!out_.open()) cannot_write(file_, errno);
  lock_results(out_, folder_);
  struct stat about {};
  if (::fstat(out_.number(), &about) == 0 && about.st_size == 0) append(csv_header(columns_));
}

void Session::take_up(const Suite& suite) {
  const SessionFile before = read_session_file(folder_);
  if (before.suite != suite.name)
    throw std::invalid_argument(fmt::format("'{}' holds results of the suite '{}', not of '{}'; choose another folder",
                                            folder_, before.suite, suite.name));
  if (before.build_identity() != build_identity())
    throw std::invalid_argument(
        fmt::format("'{}' holds results of another build of oxturn ({}, this is {}); choose another folder, or "
                    "`oxturn rescore` for new metrics of stored paths",
                    folder_, before.build_identity(), build_identity()));
  if (before.scoring_identity() != build_identity())
    throw std::invalid_argument(fmt::format(
        "'{}' was scored again by another build of oxturn ({}, this is {}); `oxturn rescore` it with this build first",
        folder_, before.scoring_identity(), build_identity()));
  compare("planner", programs_, before.programs);
  compare("metric", metrics_, before.metrics);
  if (before.shard != shard_)
    throw std::invalid_argument(fmt::format("'{}' holds shard {} of the suite, not {}; choose another folder", folder_,
                                            before.shard.text(), shard_.text()));
  sessions_ = before.sessions;
  const std::string text = read_file(file_);
  const std::string whole = whole_lines(text);
  if (whole.size() != text.size()) { write_file(file_, whole); }
  if (whole.empty()) return;
  if (whole.substr(0, whole.find('\n') + 1) != csv_header(columns_))
    throw std::invalid_argument(
        fmt::format("{}: its columns are not those of this version of oxturn; choose another folder", file_));
  for (Row& row : rows_from_csv(whole, file_)) earlier_[row.get("run_id")].push_back(std::move(row));
}

void Session::compare(const char* kind, const std::vector<OutsideEntry>& entries,
                      const std::vector<OutsideEntry>& before) const {
  for (const OutsideEntry& now : entries) {
    for (const OutsideEntry& then : before) {
      if (then.name != now.name || then.identity == now.identity) continue;
      const std::string was = then.origin == now.origin ? "" : fmt::format(" (`{}`)", then.origin);
      throw std::invalid_argument(
          fmt::format("'{}' holds results of another version of {} '{}'{}: `{}`, its description or a file that it "
                      "names has changed since; choose another folder",
                      folder_, kind, now.name, was, now.origin));
    }
  }
}

void Session::append(const std::string& line) {
  struct stat about {};
  if (::fstat(out_.number(), &about) != 0) cannot_write(file_, errno);
  std::size_t done = 0;
  while (done < line.size()) {
    const ssize_t put = ::write(out_.number(), line.data() + done, line.size() - done);
    if (put >= 0) {
      done += static_cast<std::size_t>(put);
    } else if (errno != EINTR) {
      const int error = errno;
      [[maybe_unused]] const int cut = ::ftruncate(out_.number(), about.st_size);
      cannot_write(file_, error);
    }
  }
}

void Session::rewrite(const std::string& lines) { write_file(file_, csv_header(columns_) + lines); }

void Session::describe(const Suite& suite, const SuiteRunOptions& options) {
  SessionFile session{suite.name, suite.file, suite.limits, suite.warm_ups, suite.target_coverage,
                      {},         {},         programs_,    metrics_,       sessions_};
  session.shard = shard_;
  session.suite_identity = suite_identity_;
  session.runs = run_count(suite);
  for (const Robot& robot : suite.robots) session.robots.emplace_back(robot.name, canonical_text(robot));
  session.build = build_description();
  session.sessions.push_back({fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))),
                              machine_description(), options.jobs, options.command_line, confinement()});
  write_session_file(folder_, session);
  write_file(folder_ + "/columns.json", to_json(columns_));
}

std::string to_json(const Columns& columns) {
  auto all = nlohmann::ordered_json::array();
  for (const Column& c : columns) {
    all.push_back({{"name", c.name},
                   {"type", c.type},
                   {"unit", c.unit},
                   {"better", c.better},
                   {"help", c.help},
                   {"empty", c.empty},
                   {"timing", c.timing}});
  }
  return json_text(all);
}

}  // namespace oxturn

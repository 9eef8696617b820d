#include "bench/rescore.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/sha256.hpp"
#include "bench/build_info.hpp"
#include "bench/finish.hpp"
#include "bench/progress.hpp"
#include "bench/run_id.hpp"
#include "bench/run_lines.hpp"
#include "bench/session.hpp"
#include "bench/session_file.hpp"
#include "bench/verdict.hpp"
#include "maps/path_file.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;

/// The lock on a results folder.
wire::Descriptor locked(const std::string& folder) {
  wire::Descriptor runs(::open((folder + "/runs.csv").c_str(), O_RDONLY | O_CLOEXEC));
  if (runs.open()) lock_results(runs, folder);
  return runs;  // not open: reading the results says why
}

/// A file of the results folder, for reading.
std::string existing(const std::string& folder, const std::string& name, const std::string& run_id) {
  const std::string file = folder + "/" + name;
  if (!fs::exists(file))
    throw std::invalid_argument(fmt::format("no such file: '{}', which run {} needs", file, run_id));
  if (!is_within(folder, name))
    throw std::invalid_argument(
        fmt::format("'{}' is a symbolic link that leads out of the folder; put the file itself there", file));
  return file;
}

/// New files, beside the results until all of them are there.
class Staging {
 public:
  explicit Staging(const std::string& folder) : folder_(folder), path_(folder + "/.rescore") {
    for (const char* kind : kKinds)
      if (fs::exists(folder_ / kind) && !is_within(folder, kind))
        throw std::invalid_argument(
            fmt::format("'{}/{}' is a symbolic link that leads out of the folder; put the files there", folder, kind));
    fs::remove_all(path_);  // of a process that was killed
    for (const char* kind : kKinds) fs::create_directories(path_ / kind);
  }
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Staging(const Staging&) = delete;

  std::string path() const { return path_.string(); }
  void move_into_folder() const {
    for (const char* kind : kKinds) {
      for (const auto& file : fs::directory_iterator(path_ / kind)) {
        fs::create_directories(folder_ / kind);
        fs::rename(file.path(), folder_ / kind / file.path().filename());
      }
    }
  }

 private:
  static constexpr const char* kKinds[] = {"paths", "pictures", "tethers"};
  fs::path folder_, path_;
};

bool has_path(const Row& row) { return !row.get("path_file").empty(); }

/// Planning ended at a limit on time, after a path had been published. If scoring that path broke a limit, too, the
/// reason tells of the scoring; but then, plan() was not finished.
bool timed_out(const Row& row) {
  return row.outcome() == Outcome::timeout &&
         (row.get("reason").starts_with("no result after") || row.get("plan_wall_s").empty());
}

/// With which the reason of a path goes on that is what there was at the limit on time.
constexpr const char* kEnded = "planning ended at the limit of ";

/// What is known of the run without planning.
Planned planned_of(const std::string& folder, const Row& row) {
  Planned planned;
  if (timed_out(row)) {
    const std::string& reason = row.get("reason");
    planned.outcome = Outcome::timeout;
    planned.reason = reason.starts_with("no result after") ? reason.substr(0, reason.find(';')) : "no result in time";
  }
  if (const auto ended = row.get("reason").find(kEnded); ended != std::string::npos)
    planned.reason = row.get("reason").substr(ended);
  const std::string file = existing(folder, path_name(row.get("run_id")), row.get("run_id"));
  planned.path = read_path(file);
  if (sha256(to_geojson(*planned.path)) != row.get("path_sha256"))
    throw std::invalid_argument(fmt::format(
        "{}: not the path that run {} left (its hash is not path_sha256); restore it, or judge it with `oxturn score`",
        file, row.get("run_id")));
  return planned;
}

Promise promise_of(const Row& row) {
  return row.get("promise") == to_text(Promise::target) ? Promise::target : Promise::nothing;
}

/// `params` is "name=value;name=value".
bool ignores_tether(const Row& row) {
  const std::string wanted = fmt::format(";{}=true;", kIgnoreTether);
  return (";" + row.get("params") + ";").find(wanted) != std::string::npos;
}

class Rescoring {
 public:
  Rescoring(const std::string& folder, const Registry& registry, bool progress)
      : registry_(registry),
        lock_(locked(folder)),
        results_(read_results(folder)),
        session_(read_session_file(folder)),
        trace_(folder, "trace.csv", kTraceHeader),
        progress_(static_cast<std::size_t>(std::count_if(results_.rows.begin(), results_.rows.end(), has_path)),
                  progress),
        staging_(folder) {
    options_.folder = staging_.path();
    options_.pictures = fs::is_directory(folder + "/pictures");
  }

  void run() {
    for (Row& row : results_.rows)
      if (has_path(row)) score_again(row);
    replace_files();
  }

 private:
  /// Rows of one problem follow each other: only the last problem is kept.
  const Problem& problem_of(const Row& row) {
    const std::string& hash = row.get("problem_sha256");
    if (problem_ && hash == problem_hash_) return *problem_;
    const std::string name = existing(results_.folder, problem_name(hash), row.get("run_id"));
    const MapFile file = read_map(name, {}, registry_.formats);
    problem_.emplace(file.map, file.robot.value_or(Robot{}), file.start, file.anchor);
    problem_hash_ = hash;
    if (problem_->content_hash() != hash)
      throw std::invalid_argument(fmt::format(
          "{}: not the problem of run {} (its hash is not problem_sha256): it was changed, or is of another version of "
          "oxturn; `oxturn score` judges single paths",
          name, row.get("run_id")));
    build_scoring_parts(*problem_);
    return *problem_;
  }

  void score_again(Row& row) {
    const std::string run = row.get("run_id"), kept = row.get("promise_coverage");
    const Problem& problem = problem_of(row);
    const Planned planned = planned_of(results_.folder, row);
    const ScoreOptions scoring = score_options(planned, promise_of(row), !ignores_tether(row));
    const FinishTask task{problem, planned, registry_.metrics, options_, problem_name(problem_hash_), run, scoring};
    const Finished finished = finish_isolated(task, session_.limits);
    for (const Metric& metric : registry_.metrics) row.cells.erase(metric.name);
    for (const auto& [column, cell] : finished.cells) row.cells.set(column, cell);
    if (row.get("promise") == to_text(Promise::cells) && !kept.empty()) row.cells.set("promise_coverage", kept);
    const Verdict verdict =
        finished.breach ? *finished.breach : judge(planned, finished.score, session_.target_coverage);
    row.cells.set("outcome", to_text(verdict.outcome));
    row.cells.set("reason", verdict.reason);
    trace_.set(run, finished.trace);
    for (const std::string& remark : finished.remarks)
      progress_.remark(fmt::format("{} on {}: {}", row.get("variant"), row.get("map"), remark));
    progress_.ran(verdict.outcome);
  }

  void replace_files() {
    const Columns columns = run_columns(registry_.metrics);
    std::vector<std::string> ids;
    std::string text = csv_header(columns);
    for (const Row& row : results_.rows) {
      ids.push_back(row.get("run_id"));
      text += csv_line(row, columns);
    }
    staging_.move_into_folder();
    trace_.put_in_order(ids);
    write_file(results_.folder + "/columns.json", to_json(columns));
    session_.rescored = session_.build_identity() == build_identity() ? nullptr : build_description();
    write_session_file(results_.folder, session_);
    write_file(results_.folder + "/runs.csv", text);
  }

  const Registry& registry_;
  const wire::Descriptor lock_;
  Results results_;
  SessionFile session_;
  SuiteRunOptions options_;
  RunLines trace_;
  Progress progress_;
  const Staging staging_;
  std::optional<Problem> problem_;
  std::string problem_hash_;
};

}  // namespace

Results rescore(const std::string& folder, const Registry& registry, bool progress) {
  Rescoring(folder, registry, progress).run();
  return read_results(folder);
}

}  // namespace oxturn

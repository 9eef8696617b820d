#include "bench/rescore.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "bench/finish.hpp"
#include "bench/run_id.hpp"
#include "bench/run_lines.hpp"
#include "bench/verdict.hpp"
#include "maps/path_file.hpp"

namespace oxturn {
namespace {

struct Limited {
  Limits limits;
  double target_coverage = 0.99;
};

Limited read_session(const std::string& folder) {
  const std::string file = folder + "/session.json";
  try {
    const auto json = nlohmann::json::parse(read_file(file));
    Limited session;
    session.limits = {json.at("limits").at("wall_s"), json.at("limits").at("cpu_s"), json.at("limits").at("memory_mb")};
    session.target_coverage = json.at("target_coverage");
    return session;
  } catch (const nlohmann::json::exception& e) {
    throw std::invalid_argument(fmt::format("{}: not what `oxturn run` writes ({})", file, e.what()));
  }
}

/// The problems of a folder, by their hashes. Only the last one is kept: rows of one problem follow each other.
class Problems {
 public:
  Problems(const std::string& folder, const MapFormats& formats) : folder_(folder), formats_(formats) {}
  static std::string file_of(const std::string& hash) { return fmt::format("maps/{}.geojson", hash); }
  const Problem& operator()(const std::string& hash) {
    if (hash != hash_) {
      const MapFile file = read_map(fmt::format("{}/{}", folder_, file_of(hash)), {}, formats_);
      problem_.emplace(file.map, file.robot.value_or(Robot{}), file.start, file.anchor);
      hash_ = hash;
    }
    return *problem_;
  }

 private:
  const std::string& folder_;
  const MapFormats& formats_;
  std::optional<Problem> problem_;
  std::string hash_;
};

bool has_path(const Row& row) { return !row.get("path_file").empty(); }

/// What is known of the run without planning.
Planned planned_of(const std::string& folder, const Row& row) {
  Planned planned;
  if (row.outcome() == Outcome::timeout) {
    planned.outcome = Outcome::timeout;
    planned.reason = row.get("reason").substr(0, row.get("reason").find(';'));
  }
  planned.path = read_path(fmt::format("{}/{}", folder, row.get("path_file")));
  return planned;
}

Promise promise_of(const Row& row) {
  return row.get("promise") == to_text(Promise::target) ? Promise::target : Promise::nothing;
}

class Rescoring {
 public:
  Rescoring(const std::string& folder, const Registry& registry)
      : registry_(registry),
        results_(read_results(folder)),
        session_(read_session(folder)),
        problems_(results_.folder, registry.formats),
        trace_(folder, "trace.csv", kTraceHeader) {
    options_.folder = folder;
  }

  Results run() {
    for (Row& row : results_.rows) {
      if (has_path(row)) score_again(row);
      ids_.push_back(row.get("run_id"));
    }
    const Columns columns = run_columns(registry_.metrics);
    std::string text = csv_header(columns);
    for (const Row& row : results_.rows) text += csv_line(row, columns);
    write_file(options_.folder + "/columns.json", to_json(columns));
    write_file(options_.folder + "/runs.csv", text);
    trace_.put_in_order(ids_);
    return read_results(options_.folder);
  }

 private:
  void score_again(Row& row) {
    const std::string hash = row.get("problem_sha256"), kept = row.get("promise_coverage");
    const Planned planned = planned_of(options_.folder, row);
    const bool tether_counts = row.get("params").find(std::string(kIgnoreTether) + "=true") == std::string::npos;
    const FinishTask task{problems_(hash),
                          planned,
                          registry_.metrics,
                          options_,
                          Problems::file_of(hash),
                          row.get("run_id"),
                          score_options(planned, promise_of(row), tether_counts)};
    const Finished finished = finish_isolated(task, session_.limits);
    for (const Metric& metric : registry_.metrics) row.cells.erase(metric.name);
    for (const auto& [column, cell] : finished.cells) row.cells[column] = cell;
    if (row.get("promise") == to_text(Promise::cells) && !kept.empty()) row.cells["promise_coverage"] = kept;
    const Verdict verdict =
        finished.breach ? *finished.breach : judge(planned, finished.score, session_.target_coverage);
    row.cells["outcome"] = to_text(verdict.outcome);
    row.cells["reason"] = verdict.reason;
    trace_.append(row.get("run_id"), finished.trace);
  }

  const Registry& registry_;
  Results results_;
  Limited session_;
  SuiteRunOptions options_;
  Problems problems_;
  RunLines trace_;
  std::vector<std::string> ids_;
};

}  // namespace

Results rescore(const std::string& folder, const Registry& registry) { return Rescoring(folder, registry).run(); }

}  // namespace oxturn

#include "bench/finish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/files.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "bench/run_picture.hpp"
#include "bench/wire.hpp"
#include "maps/path_file.hpp"
#include "metrics/tether_trace.hpp"

namespace oxturn {
namespace {

/// Types of the frames that the child sends.
namespace frames {
constexpr char kStage = 'S';   // name of the stage that begins
constexpr char kCells = 'C';   // column, cell, column, cell, ...
constexpr char kScore = 'M';   // flaw, then name, has value, value of each metric
constexpr char kCurve = 'V';   // the run's lines of trace.csv
constexpr char kRemark = 'N';  // a stage after scoring failed
}  // namespace frames

/// GeoJSON has no NaN, and its LineStrings have at least two points (RFC 7946, section 3.1.4).
bool can_be_written(const Path& path) {
  return !path.legs.empty() && std::all_of(path.legs.begin(), path.legs.end(), [](const Leg& leg) {
    return leg.points.size() >= 2 &&
           std::all_of(leg.points.begin(), leg.points.end(), [](const Point& p) { return finite(p); });
  });
}

std::string pack(const Score& score) {
  std::string bytes;
  wire::put_text(bytes, score.flaw);
  for (const MetricValue& metric : score.values) {
    wire::put_text(bytes, metric.name);
    wire::put(bytes, static_cast<char>(metric.value.has_value()));
    wire::put(bytes, metric.value.value_or(0));
  }
  return bytes;
}

Score score_from(std::string_view bytes) {
  Score score;
  score.flaw = wire::take_text(bytes);
  while (!bytes.empty()) {
    std::string name = wire::take_text(bytes);
    const bool has_value = wire::take<char>(bytes) != 0;
    const double value = wire::take<double>(bytes);
    score.values.push_back({std::move(name), has_value ? std::optional<double>(value) : std::nullopt});
  }
  return score;
}

std::string to_json(const std::vector<Trace>& traces) {
  auto json = nlohmann::ordered_json::array();
  for (const Trace& trace : traces) {
    auto lines = nlohmann::ordered_json::array();
    for (const Polyline& line : trace.lines) {
      auto points = nlohmann::ordered_json::array();
      for (const Point& p : line) points.push_back({p.x(), p.y()});
      lines.push_back(std::move(points));
    }
    json.push_back({{"name", trace.name}, {"lines", std::move(lines)}});
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// The child's side: stage after stage.
class FinishChild {
 public:
  FinishChild(const FinishTask& task, int fd) : task_(task), fd_(fd) {}

  void run() {
    if (is_scored(task_.planned)) {
      const Path& path = *task_.planned.path;
      begin("storing the path");
      store(path);
      begin("scoring");
      score_path(path);
      if (task_.problem.tether()) optional("following the tether", [&] { write_tether(path); });
      if (stored_ && task_.options.pictures) optional("drawing", [&] { draw(path); });
    }
    if (!task_.planned.traces.empty())
      optional("storing traces",
               [&] { write(fmt::format("traces/{}.json", task_.run_id), to_json(task_.planned.traces)); });
  }

 private:
  void begin(const std::string& stage) {
    wire::send(fd_, frames::kStage, stage);
    wire::send(fd_, child_frames::kRestart, "");
  }

  template <class Work>
  void optional(const std::string& stage, Work work) {
    begin(stage);
    try {
      work();
    } catch (const std::exception& e) { wire::send(fd_, frames::kRemark, stage + ": " + e.what()); }
  }

  void cell(const std::string& column, const std::string& text) {
    wire::put_text(cells_, column);
    wire::put_text(cells_, text);
  }
  void send_cells() { wire::send(fd_, frames::kCells, std::exchange(cells_, {})); }

  void write(const std::string& name, const std::string& content) const {
    write_file(fmt::format("{}/{}", task_.options.folder, name), content);
  }

  /// With the name of its problem, so that it can be drawn and scored again by itself.
  void store(const Path& path) {
    if (!can_be_written(path)) return;  // the verdict says what is wrong
    std::string text = to_geojson(path);
    cell("path_sha256", sha256(text));
    write(path_name(task_.run_id),
          with_problem(std::move(text), path_problem(task_.problem, {.file = "../" + task_.problem_file})));
    cell("path_file", path_name(task_.run_id));
    send_cells();
    stored_ = true;
  }

  void score_path(const Path& path) {
    const double before = own_cpu_seconds();
    ScoreOptions scoring = task_.scoring;
    if (!stored_ || !task_.options.pictures) scoring.outlines = MissedOutlines::left_out;
    score_ = score(task_.problem, path, task_.metrics, scoring);
    cell("score_s", to_decimal(own_cpu_seconds() - before));
    for (const MetricValue& metric : score_->values)
      if (metric.value) cell(metric.name, to_decimal(*metric.value));
    send_cells();
    std::string curve;
    for (const CurvePoint& p : score_->curve)
      wire::put_text(curve,
                     fmt::format("{},{},{}", to_decimal(p.path_m), to_decimal(p.mission_s), to_decimal(p.coverage)));
    wire::send(fd_, frames::kCurve, curve);
    wire::send(fd_, frames::kScore, pack(*score_));
  }

  /// The tether's length, bends and angle along the path.
  void write_tether(const Path& path) const {
    write(fmt::format("tethers/{}.csv", task_.run_id),
          to_csv(tether_trace(task_.problem, path, task_.problem.robot().tool_width)));
  }

  void draw(const Path& path) const {
    write(picture_name(task_.run_id), run_picture(task_.problem, &path, score_, task_.planned.traces));
  }

  const FinishTask& task_;
  int fd_;
  std::string cells_;  // not yet sent
  bool stored_ = false;
  std::optional<Score> score_;
};

}  // namespace

void build_scoring_parts(const Problem& problem) {
  problem.walls();
  problem.map_edges();
  problem.target_excess();  // and the target
  if (problem.tether()) problem.tether()->taut_space();
}

Finished finish_isolated(const FinishTask& task, const Limits& limits) {
  Finished finished;
  if (!is_scored(task.planned) && task.planned.traces.empty()) return finished;
  std::string stage;
  ChildTask child;
  child.limits = limits;
  child.control_group = false;  // which takes its time, and what runs here is no planner
  child.writes_results = true;
  child.work = [&](int fd) { FinishChild(task, fd).run(); };
  child.receive = [&](char type, std::string_view payload) {
    if (type == frames::kStage) {
      stage = payload;
    } else if (type == frames::kCells) {
      while (!payload.empty()) {
        const std::string column = wire::take_text(payload);
        finished.cells[column] = wire::take_text(payload);
      }
    } else if (type == frames::kCurve) {
      while (!payload.empty()) finished.trace.push_back(wire::take_text(payload));
    } else if (type == frames::kScore) {
      finished.score = score_from(payload);
    } else {
      finished.remarks.emplace_back(payload);
    }
  };
  const ChildReport report = run_child(child);
  if (report.outcome == Outcome::ok) return finished;
  const std::string reason = stage + ": " + report.reason;
  if (is_scored(task.planned) && !finished.score) {
    const bool limit = report.outcome == Outcome::timeout || report.outcome == Outcome::out_of_memory;
    finished.breach = Verdict{limit ? report.outcome : Outcome::infrastructure, reason};
  } else {
    finished.remarks.push_back(reason);
  }
  return finished;
}

}  // namespace oxturn

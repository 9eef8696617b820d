#include "bench/worker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/run_id.hpp"
#include "bench/wire.hpp"
#include "maps/formats.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "metrics/tether_trace.hpp"
#include "base/files.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "geometry/trace.hpp"
#include "maps/path_file.hpp"

namespace oxturn {

namespace {

constexpr std::size_t kLongestReason = 500;

// One line, printable, not endless: it comes from anybody's exception.
std::string as_reason(const std::string& text) {
  std::string out;
  for (const char c : text) out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  while (!out.empty() && out.back() == ' ') out.pop_back();
  if (out.size() > kLongestReason) {
    std::size_t end = kLongestReason;
    while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0) == 0x80) --end;  // not within a UTF-8 letter
    out = out.substr(0, end) + " ...";
  }
  return out;
}

void end(Row& row, Outcome outcome, const std::string& reason) {
  row.cells["outcome"] = to_text(outcome);
  row.cells["reason"] = as_reason(reason);
}

bool is_finite(const Path& path) {
  return std::all_of(path.legs.begin(), path.legs.end(), [](const Leg& leg) {
    return std::all_of(leg.points.begin(), leg.points.end(), [](const Point& p) { return finite(p); });
  });
}

struct Setting {
  std::optional<Map> map;
  std::optional<Problem> problem;
  mutable std::optional<Problem> loose;  // without the tether, for who ignores it; made for the first of them
  std::string map_hash;
  std::string hash;  // of the problem, or what stands for it
  Outcome outcome = Outcome::ok;
  std::string reason;  // why there is no problem
  std::string problem_file;
};

Setting set_up(const Work& work, const SuiteCell& cell) {
  Setting s;
  const MapSpec& spec = work.suite.maps[cell.map];
  const Robot& robot = work.suite.robots[cell.robot];
  try {
    std::optional<Location> start = spec.start, anchor = spec.anchor;
    if (spec.generator.empty()) {
      const MapFile content = spec.content ? *spec.content : read_map(spec.file, spec.read);
      s.map = content.map;
      if (!start && content.start) start = Location{"", *content.start};
      if (!anchor && content.anchor) anchor = Location{"", *content.anchor};
    } else {
      s.map = generate(spec.generator, spec.settings, spec.seed);
    }
    s.map->name = spec.name;
    s.map_hash = content_hash(*s.map);
    const StartAndAnchor places = resolve(*s.map, robot, start, anchor);
    s.problem.emplace(*s.map, robot, places.start, places.anchor);
    s.hash = s.problem->content_hash();
    // Scoring needs these, and would build them for the second planner but not for the first.
    s.problem->walls();
    s.problem->target();
    if (robot.tether) s.problem->tether()->taut_space();
    s.problem_file = fmt::format("maps/{}.geojson", s.hash);
    const std::string file = fmt::format("{}/{}", work.options.folder, s.problem_file);
    if (!std::filesystem::exists(file)) write_file(file, to_geojson(*s.problem));
    return s;
  } catch (const std::invalid_argument& e) {
    s.outcome = Outcome::infeasible;
    s.reason = e.what();
  } catch (const std::bad_alloc&) {
    s.outcome = Outcome::infrastructure;
    s.reason = "the problem does not fit into memory";
  } catch (const std::exception& e) {
    s.outcome = Outcome::infrastructure;
    s.reason = fmt::format("the problem could not be set up: {}", e.what());
  }
  s.problem.reset();
  s.hash = s.reason;
  return s;
}

/// What the planner is given: the problem itself, or for one that ignores the tether the same without.
const Problem& given(const Setting& setting, const PlannerSpec& spec) {
  if (!spec.ignore_tether || !setting.problem->robot().tether) return *setting.problem;
  if (!setting.loose) {
    Robot robot = setting.problem->robot();
    robot.tether.reset();
    setting.loose.emplace(*setting.map, robot, setting.problem->start(), setting.problem->anchor());
    // As the problem itself: all planners find the same things built.
    setting.loose->walls();
    setting.loose->target();
  }
  return *setting.loose;
}

Row row_of(const Work& work, std::size_t index, const Setting& setting) {
  const SuiteCell& cell = work.cells[index];
  const PlannerSpec& spec = work.suite.planners[cell.planner];
  const PlannerInfo& planner = find_planner(work.planners, spec.name);
  const std::string& robot = work.suite.robots[cell.robot].name;
  const std::uint64_t seed = run_seed(work.suite.seed, spec.name, setting.hash, cell.repeat);
  Row row;
  const std::string& map = work.suite.maps[cell.map].name;
  row.cells = {
      {"schema", "1"},
      {"run_id", run_id(map, robot, setting.hash, planner, spec.settings, seed, cell.repeat, spec.ignore_tether)},
      {"attempt", "1"},
      {"suite", work.suite.name},
      {"map", map},
      {"planner", spec.name},
      {"planner_family", planner.family},
      {"variant", spec.variant()},
      {"params", settings_text(spec.said())},
      {"robot", robot},
      {"repeat", std::to_string(cell.repeat)}};
  if (setting.problem) row.cells["seed"] = std::to_string(seed);
  if (setting.map) {
    row.cells["map_family"] = setting.map->family;
    row.cells["map_sha256"] = setting.map_hash;
  }
  return row;
}

void write_traces(const Work& work, const std::string& id, const std::vector<Trace>& traces) {
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
  write_file(fmt::format("{}/traces/{}.json", work.options.folder, id), json.dump() + "\n");
}

// Writes the path with the name of its problem as a foreign member (RFC 7946, 6.1), so that it can be drawn and
// scored again by itself.
void keep_path(const Work& work, const Setting& setting, const Path& path, Row& row) {
  if (path.legs.empty() || !is_finite(path)) return;  // JSON has no NaN; `reason` says what was wrong
  std::string text = to_geojson(path);
  row.cells["path_sha256"] = sha256(text);
  row.cells["path_file"] = fmt::format("paths/{}.geojson", row.get("run_id"));
  text.insert(text.find('{') + 1, fmt::format("\"problem\":\"{}\",", setting.problem_file));
  write_file(fmt::format("{}/{}", work.options.folder, row.get("path_file")), text);
}

// The tether's length, bends and angle along the path, beside it.
void keep_tether(const Work& work, const Problem& problem, const Path& path, const Row& row) {
  if (!problem.robot().tether) return;
  write_file(fmt::format("{}/tethers/{}.csv", work.options.folder, row.get("run_id")),
             to_csv(tether_trace(problem, path, problem.robot().tool_width)));
}

// Adds the score to the row; returns the flaw ("" if the path is valid).
std::string score_into(const Problem& problem, const Path& path, bool tether_counts, Row& row) {
  const auto before = std::chrono::steady_clock::now();
  ScoreOptions options;
  options.tether_counts = tether_counts;
  const Score result = score(problem, path, options);
  row.cells["score_s"] = to_decimal(std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
  for (std::size_t i = 0; i < metrics().size() && i < result.values.size(); ++i) {
    if (result.values[i]) row.cells[metrics()[i]->name] = to_decimal(*result.values[i]);
  }
  return result.flaw;
}

void judge(const Work& work, const Setting& setting, const Planned& planned, bool tether_counts, Row& row) {
  end(row, planned.outcome, planned.reason);
  if (planned.exit_code != 0) row.cells["exit_code"] = std::to_string(planned.exit_code);
  if (planned.signal != 0) row.cells["signal"] = std::to_string(planned.signal);
  if (planned.wall_s > 0) {
    row.cells["plan_wall_s"] = to_decimal(planned.wall_s);
    row.cells["plan_cpu_s"] = to_decimal(planned.cpu_s);
    row.cells["peak_rss_bytes"] = to_decimal(planned.peak_rss_bytes);
  }
  const bool scored = planned.path && (planned.outcome == Outcome::ok || planned.outcome == Outcome::timeout);
  if (!scored) return;
  keep_path(work, setting, *planned.path, row);
  const std::string flaw = score_into(*setting.problem, *planned.path, tether_counts, row);
  keep_tether(work, *setting.problem, *planned.path, row);
  if (planned.outcome == Outcome::timeout) {
    end(row, Outcome::timeout,
        flaw.empty() ? planned.reason + "; scored is the last path it published"
                     : fmt::format("{}; the last path it published is invalid: {}", planned.reason, flaw));
    return;
  }
  if (!flaw.empty()) return end(row, Outcome::invalid, flaw);
  const double covered = row.number("coverage_lower").value_or(0);
  if (covered >= work.suite.target_coverage) return end(row, Outcome::ok, "");
  end(row, Outcome::partial,
      fmt::format("coverage {:.4f} is below {}", covered, to_decimal(work.suite.target_coverage)));
}

/// `reports` takes what the planner reported of itself, packed.
void run_one(const Work& work, const Setting& setting, std::size_t index, Row& row, std::string& reports) {
  const PlannerSpec& spec = work.suite.planners[work.cells[index].planner];
  const PlannerInfo& planner = find_planner(work.planners, spec.name);
  if (!setting.problem) return end(row, setting.outcome, setting.reason);
  try {
    const std::string lacking = missing_capability(planner, given(setting, spec));
    if (!lacking.empty()) return end(row, Outcome::unsupported, lacking);
    IsolationOptions options;
    options.limits = work.suite.limits;
    options.seed = run_seed(work.suite.seed, spec.name, setting.hash, work.cells[index].repeat);
    options.traces = work.options.traces;
    options.log_file = fmt::format("{}/logs/{}.log", work.options.folder, row.get("run_id"));
    const Planned planned = plan_isolated(planner, spec.settings, given(setting, spec), options);
    judge(work, setting, planned, !spec.ignore_tether, row);
    for (const auto& [name, value] : planned.reports) {
      wire::put(reports, value);
      wire::put_text(reports, name);
    }
    if (!planned.traces.empty()) write_traces(work, row.get("run_id"), planned.traces);
  } catch (const std::exception& e) {
    // Ours: a full disk, no more processes, a scorer that throws.
    end(row, Outcome::infrastructure, e.what());
  }
}

}  // namespace

void tell(int fd, char type, std::size_t index, const std::string& text) {
  std::string message;
  wire::put(message, static_cast<std::uint64_t>(index));
  message += text;
  // Nobody listens any more: the sweep is over.
  if (!wire::send(fd, type, message)) throw std::runtime_error("the sweep is gone");
}

std::vector<SuiteCell> cells_of(const Suite& suite) {
  std::vector<SuiteCell> cells;
  for (std::size_t m = 0; m < suite.maps.size(); ++m) {
    for (std::size_t r = 0; r < suite.robots.size(); ++r) {
      for (std::size_t p = 0; p < suite.planners.size(); ++p) {
        for (int repeat = 1; repeat <= suite.repeats; ++repeat) cells.push_back({m, r, p, repeat});
      }
    }
  }
  return cells;
}

Row blank_row(const Work& work, std::size_t index) {
  Setting unknown;
  unknown.hash = "unknown";
  return row_of(work, index, unknown);
}

void run_unit(const Work& work, const Unit& unit, int fd) {
  const SuiteCell& first = work.cells[unit.first];
  const Setting setting = set_up(work, first);
  for (std::size_t index = unit.first; index < unit.last; ++index) {
    Row row = row_of(work, index, setting);
    const auto earlier = work.earlier.find(row.get("run_id"));
    if (earlier != work.earlier.end()) {
      if (earlier->second.done) {
        tell(fd, messages::kKept, index, row.get("run_id"));
        continue;
      }
      row.cells["attempt"] = std::to_string(earlier->second.attempts + 1);
    }
    tell(fd, messages::kBegun, index, csv_line(row));
    std::string reports;
    run_one(work, setting, index, row, reports);
    if (!reports.empty()) tell(fd, messages::kRecords, index, reports);
    tell(fd, messages::kDone, index, csv_line(row));
  }
}

}  // namespace oxturn

#include "bench/worker.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>

#include "base/files.hpp"
#include "base/text.hpp"
#include "bench/build_info.hpp"
#include "bench/finish.hpp"
#include "bench/isolate.hpp"
#include "bench/run_id.hpp"
#include "bench/verdict.hpp"
#include "bench/wire.hpp"
#include "maps/map_features.hpp"
#include "maps/map_source.hpp"

namespace oxturn {

namespace {

constexpr std::size_t kLongestReason = 500;

// One printable line of bounded length: the text may come from any exception.
std::string as_reason(const std::string& text) {
  std::string out = printable(text);
  while (!out.empty() && out.back() == ' ') out.pop_back();
  if (out.size() <= kLongestReason) return out;
  std::size_t end = kLongestReason;
  while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0) == 0x80) --end;  // not within a UTF-8 sequence
  return out.substr(0, end) + " ...";
}

void end(Row& row, Outcome outcome, const std::string& reason) {
  row.cells.set("outcome", to_text(outcome));
  row.cells.set("reason", as_reason(reason));
}

struct Setting {
  std::optional<Map> map;
  std::optional<Problem> problem;
  mutable std::optional<Problem> loose;  // without the tether, for planners that ignore it; made for the first of them
  std::map<std::string, std::string> cells;  // that describe map and robot, the same for all runs
  std::string hash;                          // of the problem, or what stands for it
  Outcome outcome = Outcome::ok;
  std::string reason;  // why there is no problem
  std::string problem_file;
};

constexpr const char* kAreaTools = "map_area_tools";  // the one that depends on the robot

MapCells map_cells(const MapSpec& spec, const Map& map) {
  const MapFeatures features = map_features(map);
  MapCells cells{{"map_family", map.family},
                 {"map_sha256", content_hash(map)},
                 {"map_params", to_text(spec.generator.empty() ? spec.read : spec.settings)},
                 {"map_area_m2", to_decimal(features.area_m2)},
                 {"map_perimeter_m", to_decimal(features.perimeter_m)},
                 {"map_holes", std::to_string(features.holes)},
                 {"map_reflex_vertices", std::to_string(features.reflex_vertices)}};
  if (features.narrowest_m) cells["map_narrowest_m"] = to_decimal(*features.narrowest_m);
  return cells;
}

MapSource source_of(const MapSpec& spec) {
  const bool generated = !spec.generator.empty();
  return {spec.file, spec.generator, generated ? spec.settings : spec.read, spec.seed};
}

/// What each process would build for itself. Of several planners most need the triangulation for shortest paths, or for
/// tethered robots the cut locus.
void build_shared_parts(const Suite& suite, const Problem& problem) {
  build_scoring_parts(problem);
  if (suite.planners.size() < 2) return;
  if (const TetherModel* tether = problem.tether())
    tether->geodesics().find_cut_locus();
  else
    problem.transit();
}

Setting set_up(const Work& work, const SuiteCell& cell) {
  Setting s;
  const MapSpec& spec = work.suite.maps[cell.map];
  const Robot& robot = work.suite.robots[cell.robot];
  const Registry& registry = work.registry;
  try {
    std::optional<Location> start = spec.start, anchor = spec.anchor;
    MapFile content = spec.content ? *spec.content : load_map(source_of(spec), registry.generators, registry.formats);
    s.map = std::move(content.map);
    if (spec.target_area) s.map->target_area = spec.target_area;
    if (!start && content.start) start = Location{"", *content.start};
    if (!anchor && content.anchor) anchor = Location{"", *content.anchor};
    s.map->name = spec.name;
    const auto known = work.known_maps.find(cell.map);
    s.cells = known != work.known_maps.end() ? known->second : map_cells(spec, *s.map);
    s.cells[kAreaTools] = to_decimal(area(s.map->free) / (robot.tool_width * robot.tool_width));
    const StartAndAnchor located = resolve(*s.map, robot, start, anchor);
    s.problem.emplace(*s.map, robot, located.start, located.anchor);
    s.hash = s.problem->content_hash();
    build_shared_parts(work.suite, *s.problem);
    s.problem_file = problem_name(s.hash);
    const std::string file = fmt::format("{}/{}", work.options.folder, s.problem_file);
    if (!std::filesystem::exists(file)) write_file(file, to_geojson(*s.problem));
    return s;
  } catch (const std::invalid_argument& e) {
    s.outcome = Outcome::infeasible;
    s.reason = e.what();
  } catch (const std::bad_alloc&) {
    s.outcome = Outcome::out_of_memory;
    s.reason = "setting up the problem: there is not enough memory";
  } catch (const std::exception& e) {
    s.outcome = Outcome::infrastructure;
    s.reason = fmt::format("the problem could not be set up: {}", e.what());
  }
  s.problem.reset();
  s.hash = s.reason;
  return s;
}

/// What the planner is given: the problem itself, or for one that ignores the tether the same without.
const Problem& given(const Suite& suite, const Setting& setting, const PlannerSpec& spec) {
  if (!spec.ignore_tether || !setting.problem->robot().tether) return *setting.problem;
  if (!setting.loose) {
    Robot robot = setting.problem->robot();
    robot.tether.reset();
    setting.loose.emplace(*setting.map, robot, setting.problem->start(), setting.problem->anchor());
    build_shared_parts(suite, *setting.loose);
  }
  return *setting.loose;
}

Row row_of(const Work& work, std::size_t index, const Setting& setting) {
  const SuiteCell& cell = work.cells[index];
  const PlannerSpec& spec = work.suite.planners[cell.planner];
  const PlannerInfo& planner = work.registry.planners.find(spec.name);
  const Robot& robot = work.suite.robots[cell.robot];
  const std::uint64_t seed = run_seed(work.suite.seed, spec.name, setting.hash, cell.repeat);
  Settings settings = full_settings(planner, spec.settings, work.registry.planners);
  if (spec.ignore_tether) settings[kIgnoreTether] = true;
  Row row;
  const std::string& map = work.suite.maps[cell.map].name;
  row.cells = {{"schema", "1"},
               {"run_id", run_id(map, robot.name, setting.hash, identified(planner, settings, work.registry.planners),
                                 settings, seed, cell.repeat, build_identity())},
               {"attempt", "1"},
               {"suite", work.suite.name},
               {"map", map},
               {"planner", spec.name},
               {"planner_family", planner.family},
               {"variant", spec.variant()},
               {"params", to_text(spec.said())},
               {"promise", to_text(planner.promised(spec.settings, robot))},
               {"robot", robot.name},
               {"tool_width_m", to_decimal(robot.tool_width)},
               {"repeat", std::to_string(cell.repeat)}};
  for (const auto& [column, value] : setting.cells) row.cells.set(column, value);
  if (robot.footprint.empty()) row.cells.set("robot_radius_m", to_decimal(robot.radius));
  if (setting.problem) {
    row.cells.set("seed", std::to_string(seed));
    row.cells.set("problem_sha256", setting.hash);
  }
  return row;
}

void write_process(const Planned& planned, Row& row) {
  if (planned.exit_code != 0) row.cells.set("exit_code", std::to_string(planned.exit_code));
  if (planned.signal != 0) row.cells.set("signal", std::to_string(planned.signal));
  if (planned.wall_s <= 0) return;
  row.cells.set("plan_wall_s", to_decimal(planned.wall_s));
  row.cells.set("plan_cpu_s", to_decimal(planned.cpu_s));
  row.cells.set("peak_rss_bytes", to_decimal(planned.peak_rss_bytes));
}

/// Lines of metrics.csv; empty means not applicable.
std::vector<std::string> metric_lines(const Records& records) {
  std::vector<std::string> lines;
  for (const auto& [name, value] : records)
    lines.push_back(fmt::format("{},{}", name, std::isfinite(value) ? to_decimal(value) : ""));
  return lines;
}

/// Of a suite with `scoring = false`.
void end_unscored(const Planned& planned, Row& row) {
  const bool returned = planned.outcome == Outcome::ok;
  end(row, planned.outcome, returned ? "the path is not scored" : planned.reason);
}

/// Scores and stores what came of planning, in a process of its own.
void finish_run(const Work& work, const Setting& setting, std::size_t index, const Planned& planned, int fd, Row& row) {
  const PlannerSpec& spec = work.suite.planners[work.cells[index].planner];
  const Promise promise = work.registry.planners.find(spec.name).promised(spec.settings, setting.problem->robot());
  const ScoreOptions scoring = score_options(planned, promise, !spec.ignore_tether);
  const FinishTask task{*setting.problem,  planned, work.registry.metrics, work.options, setting.problem_file,
                        row.get("run_id"), scoring};
  const Finished finished = finish_isolated(task, work.suite.limits);
  for (const auto& [column, cell] : finished.cells) row.cells.set(column, cell);
  const Verdict verdict =
      finished.breach ? *finished.breach : judge(planned, finished.score, work.suite.target_coverage);
  end(row, verdict.outcome, verdict.reason);
  if (planned.outcome == Outcome::ok) row.cells.set("promise", to_text(scoring.promise));
  if (!planned.records.empty()) send_message(fd, messages::kMetrics, index, joined(metric_lines(planned.records)));
  if (!finished.trace.empty()) send_message(fd, messages::kTrace, index, joined(finished.trace));
  for (const std::string& remark : finished.remarks)
    send_message(fd, messages::kRemark, 0, fmt::format("{} on {}: {}", row.get("variant"), row.get("map"), remark));
}

void run_one(const Work& work, const Setting& setting, std::size_t index, int fd, Row& row) {
  const PlannerSpec& spec = work.suite.planners[work.cells[index].planner];
  const PlannerInfo& planner = work.registry.planners.find(spec.name);
  if (!setting.problem) return end(row, setting.outcome, setting.reason);
  try {
    const Problem& problem = given(work.suite, setting, spec);
    const std::string missing = missing_capability(planner, problem);
    if (!missing.empty()) return end(row, Outcome::unsupported, missing);
    IsolationOptions options;
    options.limits = work.suite.limits;
    options.seed = run_seed(work.suite.seed, spec.name, setting.hash, work.cells[index].repeat);
    options.warm_ups = work.suite.warm_ups;
    options.traces = work.options.traces;
    if (const double load = load_average(); load >= 0) row.cells.set("load", to_decimal(load));
    options.log_file = fmt::format("{}/logs/{}.log", work.options.folder, row.get("run_id"));
    const auto make = [&] { return planner.make(spec.settings, work.registry.planners); };
    const Planned planned = plan_isolated(make, problem, options);
    write_process(planned, row);
    if (work.suite.scoring)
      finish_run(work, setting, index, planned, fd, row);
    else
      end_unscored(planned, row);
  } catch (const std::exception& e) {
    // A defect or limit of the harness: a full disk, no more processes, a metric that throws.
    end(row, Outcome::infrastructure, e.what());
  }
}

}  // namespace

void send_message(int fd, char type, std::size_t index, const std::string& payload) {
  std::string message;
  wire::put(message, static_cast<std::uint64_t>(index));
  message += payload;
  if (!wire::send(fd, type, message)) throw std::runtime_error("the parent process has closed the pipe");
}

std::string joined(const std::vector<std::string>& lines) {
  std::string bytes;
  for (const std::string& line : lines) wire::put_text(bytes, line);
  return bytes;
}

std::vector<std::string> lines_from(std::string_view bytes) {
  std::vector<std::string> lines;
  while (!bytes.empty()) lines.push_back(wire::take_text(bytes));
  return lines;
}

std::string pack(const Row& row) {
  std::string bytes;
  for (const auto& [column, cell] : row.cells.all()) {
    wire::put_text(bytes, column);
    wire::put_text(bytes, cell);
  }
  return bytes;
}

Row row_from(std::string_view bytes) {
  Row row;
  while (!bytes.empty()) {
    const std::string column = wire::take_text(bytes);
    row.cells.set(column, wire::take_text(bytes));
  }
  return row;
}

MapCells map_cells_of(const Row& row) {
  MapCells cells;
  for (const auto& [column, cell] : row.cells.all())
    if (column.starts_with("map_") && column != kAreaTools) cells[column] = cell;
  return cells;
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
  send_message(fd, messages::kReady, unit.first, "");
  for (std::size_t index = unit.first; index < unit.last; ++index) {
    Row row = row_of(work, index, setting);
    const auto earlier = work.earlier.find(row.get("run_id"));
    if (earlier != work.earlier.end()) {
      if (earlier->second.done) {
        send_message(fd, messages::kKept, index, row.get("run_id"));
        continue;
      }
      row.cells.set("attempt", std::to_string(earlier->second.attempts + 1));
    }
    send_message(fd, messages::kBegun, index, pack(row));
    run_one(work, setting, index, fd, row);
    send_message(fd, messages::kDone, index, pack(row));
  }
}

}  // namespace oxturn

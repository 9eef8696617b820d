#include "bench/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "bench/session_file.hpp"
#include "metrics/score.hpp"

namespace oxturn {

namespace {

constexpr std::array<std::pair<Outcome, const char*>, 11> kOutcomes{{{Outcome::ok, "ok"},
                                                                     {Outcome::partial, "partial"},
                                                                     {Outcome::invalid, "invalid"},
                                                                     {Outcome::infeasible, "infeasible"},
                                                                     {Outcome::unsupported, "unsupported"},
                                                                     {Outcome::timeout, "timeout"},
                                                                     {Outcome::out_of_memory, "out_of_memory"},
                                                                     {Outcome::crash, "crash"},
                                                                     {Outcome::error, "error"},
                                                                     {Outcome::cancelled, "cancelled"},
                                                                     {Outcome::infrastructure, "infrastructure"}}};

Column text(std::string name, std::string help, std::string empty = "") {
  return {std::move(name), "text", "", "", std::move(help), std::move(empty)};
}
Column whole(std::string name, std::string help, std::string empty = "") {
  return {std::move(name), "integer", "1", "", std::move(help), std::move(empty)};
}
Column real(std::string name, std::string unit, std::string help, std::string empty = "") {
  return {std::move(name), "real", std::move(unit), "", std::move(help), std::move(empty)};
}
Column timing(std::string name, std::string unit, std::string help) {
  return {std::move(name),
          "real",
          std::move(unit),
          "lower",
          std::move(help),
          "plan() was not called or not finished",
          true};
}

}  // namespace

Columns run_columns(const Metrics& metrics) {
  Columns all{whole("schema", "version of this table"),
              text("run_id", "hash of everything that determines the run"),
              whole("attempt", "1, and one more for each time the run was taken up again"),
              text("suite", "name of the suite"),
              text("map", "name of the map, unique within the suite"),
              text("map_family", "generator, or \"file\"", "the map could not be made"),
              text("map_sha256", "content address of the map's free space", "the map could not be made"),
              text("map_params", "of the generator or reader, k=v;k=v", "all defaults"),
              real("map_area_m2", "m2", "area of the free space", "the map could not be made"),
              real("map_perimeter_m", "m", "total length of its boundary", "the map could not be made"),
              whole("map_holes", "obstacles inside it", "the map could not be made"),
              whole("map_reflex_vertices", "vertices with an interior angle above pi", "the map could not be made"),
              real("map_narrowest_m", "m", "width of the narrowest passage", "none, or above 5000 vertices"),
              real("map_area_tools", "1", "area over the square of the tool width", "the map could not be made"),
              text("planner", "name of the planner"),
              text("planner_family", "family of the planner"),
              text("variant", "planner with the settings that are not the defaults"),
              text("params", "those settings, k=v;k=v", "all defaults"),
              text("promise", "what the planner promises to cover: target, cells or nothing"),
              text("robot", "name of the robot"),
              real("robot_radius_m", "m", "radius of the robot's disc", "the robot has a polygonal footprint"),
              real("tool_width_m", "m", "width of the tool"),
              text("problem_sha256", "hash of map, robot, start and anchor", "the problem could not be built"),
              whole("seed", "seed of the planner's random generator", "the problem could not be built"),
              whole("repeat", "1 .. repeats"),
              text("outcome", "how the run ended"),
              text("reason", "why it ended so, one sentence", "outcome is ok"),
              whole("exit_code", "of the planner's process", "it did not exit by itself with a code other than 0"),
              whole("signal", "that ended the planner's process", "no signal did")};
  for (const Metric& metric : metrics) {
    const std::string type = metric.unit == "count" ? "integer" : "real";
    const std::string better = metric.better == Better::neither ? "" : to_text(metric.better);
    all.push_back({metric.name, type, metric.unit, better, metric.help, "no path, or not applicable"});
  }
  all.push_back(timing("plan_wall_s", "s", "time that plan() took"));
  all.push_back(timing("plan_cpu_s", "s", "processor time that plan() took"));
  all.push_back(timing("peak_rss_bytes", "bytes", "growth of resident memory during plan(), at its peak"));
  all.push_back(timing("score_s", "s", "processor time that scoring the path took"));
  all.back().empty = "no path was scored";
  all.push_back(timing("load", "1", "processes ready to run on the machine, when the run began"));
  all.back().empty = "the system does not say";
  all.push_back(text("path_sha256", "hash of the path's legs as GeoJSON", "no path that could be written"));
  all.push_back(text("path_file", "path within the results folder", "no path that could be written"));
  return all;
}

std::string to_text(Outcome outcome) {
  for (const auto& [value, name] : kOutcomes) {
    if (value == outcome) return name;
  }
  throw std::logic_error("an outcome without a name");
}

std::optional<Outcome> outcome_from(const std::string& name) {
  for (const auto& [value, known] : kOutcomes) {
    if (known == name) return value;
  }
  return std::nullopt;
}

bool is_unfinished(Outcome outcome) { return outcome == Outcome::cancelled || outcome == Outcome::infrastructure; }

std::optional<double> Row::number(const std::string& column) const {
  const std::string cell = get(column);
  if (cell.empty()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) {
    throw std::invalid_argument(
        fmt::format("column '{}' of run {} holds '{}', expected a number or nothing", column, get("run_id"), cell));
  }
  return value;
}

Outcome Row::outcome() const {
  const auto outcome = outcome_from(get("outcome"));
  if (!outcome) {
    throw std::invalid_argument(fmt::format("unknown outcome '{}' of run {}", get("outcome"), get("run_id")));
  }
  return *outcome;
}

std::string csv_header(const Columns& columns) {
  std::vector<std::string> names;
  for (const Column& column : columns) names.push_back(column.name);
  return csv_line(names);
}

std::string csv_line(const Row& row, const Columns& columns) {
  std::vector<std::string> cells;
  for (const Column& column : columns) cells.push_back(row.get(column.name));
  return csv_line(cells);
}

namespace {

// What every report needs of a row; all else may be missing from a file of another version.
const char* const kNeeded[] = {"run_id", "suite", "map", "planner", "variant", "robot", "repeat", "outcome", "reason"};

Row row_of(const std::vector<std::string>& header, const std::vector<std::string>& cells, const std::string& source,
           std::size_t line) {
  if (cells.size() != header.size())
    throw std::invalid_argument(
        fmt::format("{}: row {} has {} cells, expected {}; `oxturn run --resume` mends a file that was cut off", source,
                    line, cells.size(), header.size()));
  Row row;
  for (std::size_t k = 0; k < header.size(); ++k)
    if (!cells[k].empty()) row.cells.set(header[k], cells[k]);
  if (!outcome_from(row.get("outcome")))
    throw std::invalid_argument(
        fmt::format("{}: row {} has outcome '{}', which is none", source, line, row.get("outcome")));
  return row;
}

void require_columns(const std::vector<std::string>& header, const std::string& source) {
  for (const char* name : kNeeded)
    if (std::find(header.begin(), header.end(), name) == header.end())
      throw std::invalid_argument(
          fmt::format("{}:1: there is no column '{}'; expected a file that `oxturn run` wrote", source, name));
}

}  // namespace

std::vector<Row> rows_from_csv(const std::string& text, const std::string& source) {
  std::vector<std::string> header;
  std::vector<Row> rows;
  for_each_csv_line(text, source, [&](std::vector<std::string> cells) {
    if (!header.empty()) return rows.push_back(row_of(header, cells, source, rows.size() + 1));
    header = std::move(cells);
    require_columns(header, source);
  });
  if (header.empty()) throw std::invalid_argument(fmt::format("{}: empty, expected a header line", source));
  return rows;
}

namespace {

std::string file_of_run(const char* kind, const std::string& run_id, const char* suffix) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (run_id.empty() || !std::all_of(run_id.begin(), run_id.end(), plain))
    throw std::invalid_argument(fmt::format("run_id '{}' is not made of letters, digits, - and _", run_id));
  return fmt::format("{}/{}{}", kind, run_id, suffix);
}

}  // namespace

std::string path_name(const std::string& run_id) { return file_of_run("paths", run_id, ".geojson"); }
std::string picture_name(const std::string& run_id) { return file_of_run("pictures", run_id, ".svg"); }

std::string problem_name(const std::string& hash) {
  const bool is_hash = hash.size() == 64 && hash.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!is_hash)
    throw std::invalid_argument(fmt::format("problem_sha256 '{}' is not made of 64 hexadecimal digits", hash));
  return fmt::format("maps/{}.geojson", hash);
}

bool is_within(const std::string& folder, const std::string& name) {
  std::error_code missing;
  const auto root = std::filesystem::canonical(folder, missing);
  if (missing) return false;
  const auto file = std::filesystem::canonical(root / name, missing);
  return !missing && std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

namespace {

/// Nothing if there is no session.json, or one of another version: the tables do without.
std::vector<std::string> session_summary(const std::string& folder) {
  try {
    return summary(read_session_file(folder));
  } catch (const std::invalid_argument&) { return {}; }
}

}  // namespace

Results read_results(const std::string& folder) {
  const std::string file = folder + "/runs.csv";
  if (!std::filesystem::is_directory(folder))
    throw std::invalid_argument(fmt::format("no such folder: '{}'; expected one that `oxturn run -o` made", folder));
  if (!std::filesystem::exists(file))
    throw std::invalid_argument(
        fmt::format("no runs.csv in '{}'; expected a folder that `oxturn run -o` made", folder));
  const std::string text = read_file(file);
  Results results;
  results.folder = folder;
  std::map<std::string, std::size_t> seen;  // run_id -> index in rows
  for (Row& row : rows_from_csv(text, file)) {
    const auto [known, fresh] = seen.emplace(row.get("run_id"), results.rows.size());
    if (fresh)
      results.rows.push_back(std::move(row));
    else
      results.rows[known->second] = std::move(row);
  }
  for (const Row& row : results.rows)
    if (const std::string name = picture_name(row.get("run_id")); is_within(folder, name))
      results.pictures[row.get("run_id")] = name;
  results.about = session_summary(folder);
  results.columns = parse_csv(text.substr(0, text.find('\n') + 1), file).at(0);
  return results;
}

}  // namespace oxturn

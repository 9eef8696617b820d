#include "cli/report_printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/colour.hpp"

namespace oxturn::cli {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

struct Line {
  std::string name, value, note;
};

void print_lines(const std::vector<Line>& lines, std::FILE* out) {
  std::size_t width = 0, value_width = 0;
  for (const Line& line : lines) {
    width = std::max(width, line.name.size());
    if (!line.note.empty()) value_width = std::max(value_width, line.value.size());
  }
  for (const Line& line : lines) {
    if (line.note.empty())
      fmt::print(out, "{:{}}  {}\n", line.name, width, line.value);
    else
      fmt::print(out, "{:{}}  {:{}}  {}\n", line.name, width, line.value, value_width, line.note);
  }
}

/// A metric's help without what it says of an empty value.
std::string meaning_of_value(const std::string& help) { return help.substr(0, help.find("; empty")); }

Json as_json(const Report& report, const Problem& problem) {
  Json json{{"outcome", to_text(report.verdict.outcome)}, {"reason", report.verdict.reason}};
  for (const auto& [name, value] : report.about) json[name] = value;
  json["map"] = problem.map().name;
  json["map_sha256"] = content_hash(problem.map());
  json["robot"] = {{"radius", problem.robot().radius}, {"tool_width", problem.robot().tool_width}};
  json["start"] = {problem.start().x(), problem.start().y()};
  if (problem.tether()) json["anchor"] = {problem.anchor().x(), problem.anchor().y()};
  if (report.tolerance) json["tolerance_m"] = *report.tolerance;
  json["metrics"] = Json::object();
  if (report.score)
    for (const MetricValue& metric : report.score->values) json["metrics"][metric.name] = number_or_null(metric.value);
  for (const auto& [name, value] : report.costs) json[name] = value;
  if (!report.records.empty()) json["records"] = Json::object();
  for (const auto& [name, value] : report.records) json["records"][name] = value;
  if (!report.remarks.empty()) json["remarks"] = report.remarks;
  return json;
}

void print_table(const Report& report, const Problem& problem, const Metrics& metrics, std::FILE* out) {
  std::vector<Line> lines{
      {"outcome", coloured(out, colour_of(report.verdict.outcome), to_text(report.verdict.outcome)), ""}};
  for (const auto& [name, value] : report.about)
    if (!value.empty()) lines.push_back({name, value, ""});
  const Region& free = problem.map().free;
  lines.push_back({"map",
                   fmt::format("{} ({:.6g} m2 free, {} vertices, {} holes)", problem.map().name, area(free),
                               vertex_count(free), hole_count(free)),
                   ""});
  if (report.tolerance)
    lines.push_back({"tolerance", fmt::format("{:.6g}", *report.tolerance),
                     "metres outside configuration space, and at start and joints, that count as rounding"});
  const Columns columns = run_columns(metrics);
  const auto help = [&](const std::string& name) {
    for (const Column& column : columns)
      if (column.name == name) return column.help;
    return std::string();
  };
  std::vector<std::string> empty;
  if (report.score) {
    for (const MetricValue& metric : report.score->values) {
      if (metric.value)
        lines.push_back({metric.name, fmt::format("{:.6g}", *metric.value), meaning_of_value(help(metric.name))});
      else
        empty.push_back(metric.name);
    }
  }
  for (const auto& [name, value] : report.costs) lines.push_back({name, fmt::format("{:.4g}", value), help(name)});
  for (const auto& [name, value] : report.records)
    lines.push_back({name, fmt::format("{:.6g}", value), "recorded by the planner"});
  if (!empty.empty())
    lines.push_back({"empty", fmt::format("{} (`oxturn list metrics` says when)", fmt::join(empty, ", ")), ""});
  print_lines(lines, out);
}

}  // namespace

int print(const Report& report, const Problem& problem, const Metrics& metrics, bool json, std::FILE* out) {
  if (json)
    fmt::print(out, "{}\n", as_json(report, problem).dump(2, ' ', false, Json::error_handler_t::replace));
  else
    print_table(report, problem, metrics, out);
  std::fflush(out);  // before what follows on standard error
  const Outcome outcome = report.verdict.outcome;
  if (outcome == Outcome::ok) return 0;
  say(fmt::format("{}: {}", to_text(outcome), report.verdict.reason));
  return outcome == Outcome::partial ? 0 : 1;
}

}  // namespace oxturn::cli

// cli/verdict.cpp
#include "cli/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/suite.hpp"
#include "cli/options.hpp"
#include "maps/formats.hpp"

namespace oxturn::cli {
namespace {

using Json = nlohmann::ordered_json;

const double kTargetCoverage = Suite{}.target_coverage;

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

struct Line {
  std::string name, value, note;
};

void print_lines(const std::vector<Line>& lines) {
  std::size_t width = 0, value_width = 0;
  for (const Line& line : lines) {
    width = std::max(width, line.name.size());
    if (!line.note.empty()) value_width = std::max(value_width, line.value.size());
  }
  for (const Line& line : lines) {
    if (line.note.empty())
      fmt::print("{:{}}  {}\n", line.name, width, line.value);
    else
      fmt::print("{:{}}  {:{}}  {}\n", line.name, width, line.value, value_width, line.note);
  }
}

Json as_json(const Verdict& verdict, const Problem& problem) {
  Json json{{"outcome", to_text(verdict.outcome)}, {"reason", verdict.reason}};
  for (const auto& [name, value] : verdict.about) json[name] = value;
  json["map"] = problem.map().name;
  json["map_sha256"] = content_hash(problem.map());
  json["robot"] = {{"radius", problem.robot().radius}, {"tool_width", problem.robot().tool_width}};
  json["start"] = {problem.start().x(), problem.start().y()};
  if (problem.robot().tether) json["anchor"] = {problem.anchor().x(), problem.anchor().y()};
  json["metrics"] = Json::object();
  if (verdict.score)
    for (std::size_t i = 0; i < metrics().size() && i < verdict.score->values.size(); ++i)
      json["metrics"][metrics()[i]->name] = number_or_null(verdict.score->values[i]);
  for (const auto& [name, value] : verdict.costs) json[name] = number_or_null(value);
  if (!verdict.reports.empty()) json["reports"] = Json::object();
  for (const auto& [name, value] : verdict.reports) json["reports"][name] = value;
  return json;
}

void print_table(const Verdict& verdict, const Problem& problem) {
  std::vector<Line> lines{{"outcome", to_text(verdict.outcome), ""}};
  for (const auto& [name, value] : verdict.about)
    if (!value.empty()) lines.push_back({name, value, ""});
  const Region& free = problem.map().free;
  lines.push_back({"map",
                   fmt::format("{} ({:.6g} m2 free, {} corners, {} holes)", problem.map().name, area(free),
                               vertex_count(free), hole_count(free)),
                   ""});
  if (verdict.score)
    for (std::size_t i = 0; i < metrics().size() && i < verdict.score->values.size(); ++i) {
      const auto& value = verdict.score->values[i];
      lines.push_back({metrics()[i]->name, value ? fmt::format("{:.6g}", *value) : "-", metrics()[i]->help});
    }
  for (const auto& [name, value] : verdict.costs) {
    std::string help;
    for (const Column& column : columns())
      if (column.name == name) help = column.help;
    lines.push_back({name, value ? fmt::format("{:.4g}", *value) : "-", help});
  }
  for (const auto& [name, value] : verdict.reports)
    lines.push_back({name, fmt::format("{:.6g}", value), "reported by the planner"});
  print_lines(lines);
}

}  // namespace

void judge(Verdict& verdict, const Problem& problem, const Path& path) {
  verdict.score = score(problem, path);
  const double covered = verdict.score->value("coverage_lower").value_or(0);
  if (!verdict.score->flaw.empty()) {
    verdict.outcome = Outcome::invalid;
    verdict.reason = verdict.score->flaw;
  } else if (covered < kTargetCoverage) {
    verdict.outcome = Outcome::partial;
    verdict.reason = fmt::format("coverage {:.4f} is below {:g}", covered, kTargetCoverage);
  } else {
    verdict.outcome = Outcome::ok;
    verdict.reason.clear();
  }
}

int tell(const Verdict& verdict, const Problem& problem, bool json) {
  if (json)
    fmt::print("{}\n", as_json(verdict, problem).dump(2, ' ', false, Json::error_handler_t::replace));
  else
    print_table(verdict, problem);
  std::fflush(stdout);  // before what follows on standard error
  if (verdict.outcome == Outcome::ok) return 0;
  say(fmt::format("{}: {}", to_text(verdict.outcome), verdict.reason));
  return verdict.outcome == Outcome::partial ? 0 : 1;
}

}  // namespace oxturn::cli

// oxturn list: what there is, from the descriptions themselves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "algorithms/coverage_planner.hpp"
#include "bench/results.hpp"
#include "cli/commands.hpp"
#include "cli/suites.hpp"
#include "maps/formats.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "reports/pages/pages.hpp"
#include "base/text.hpp"

namespace oxturn::cli {
namespace {

using Json = nlohmann::ordered_json;

// --- everything as data --------------------------------------------------------------------------------------

const char* type_name(const Value& value) {
  static constexpr const char* kNames[] = {"yes/no", "whole number", "number", "text"};
  return kNames[value.index()];
}

Json to_json(const Value& value) {
  return std::visit([](const auto& v) -> Json { return v; }, value);
}

Json to_json(const std::vector<ParameterInfo>& parameters) {
  Json all = Json::array();
  for (const ParameterInfo& p : parameters) {
    Json one{{"name", p.name}, {"type", type_name(p.fallback)}, {"default", to_json(p.fallback)}, {"help", p.help}};
    if (std::isfinite(p.range.least)) one["least"] = p.range.least;
    if (std::isfinite(p.range.most)) one["most"] = p.range.most;
    if (!p.choices.empty()) one["choices"] = p.choices;
    all.push_back(std::move(one));
  }
  return all;
}

std::string to_text(Better better) {
  return better == Better::lower ? "lower" : better == Better::higher ? "higher" : "neither";
}

Json planners() {
  Json all = Json::array();
  for (const PlannerInfo& p : zoo()) {
    Json capabilities = Json::array();
    for (const Capability c : p.capabilities) capabilities.push_back(oxturn::to_text(c));
    all.push_back({{"name", p.name},
                   {"family", p.family},
                   {"title", p.title},
                   {"citation", p.citation},
                   {"capabilities", capabilities},
                   {"guarantee", p.guarantee},
                   {"parameters", to_json(p.parameters)}});
  }
  return all;
}

Json maps() {
  Json all = Json::array();
  for (const GeneratorInfo& g : generators())
    all.push_back(
        {{"name", g.name}, {"title", g.title}, {"guarantee", g.guarantee}, {"parameters", to_json(g.parameters)}});
  return all;
}

Json formats() {
  Json all = Json::array();
  for (const MapFormat& f : map_formats())
    all.push_back({{"name", f.name}, {"title", f.title}, {"suffixes", f.suffixes}, {"direction", "read"}});
  all.push_back({{"name", "geojson"},
                 {"title", "GeoJSON: maps, problems, paths"},
                 {"suffixes", {".geojson", ".json"}},
                 {"direction", "write"}});
  all.push_back(
      {{"name", "svg"}, {"title", "picture of a map or a path"}, {"suffixes", {".svg"}}, {"direction", "write"}});
  return all;
}

Json all_metrics() {
  Json all = Json::array();
  for (const Metric* m : metrics())
    all.push_back({{"name", m->name}, {"unit", m->unit}, {"better", to_text(m->better)}, {"help", m->help}});
  return all;
}

Json suites() {
  Json all = Json::array();
  for (const SuiteFile& s : suite_files()) all.push_back({{"name", s.name}, {"file", s.file}, {"title", s.title}});
  return all;
}

Json all_pages() {
  Json all = Json::array();
  for (const Page& p : pages()) all.push_back({{"name", p.name}, {"title", p.title}});
  return all;
}

Json all_columns() { return Json::parse(columns_json()); }

// --- for people ----------------------------------------------------------------------------------------------

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::string limits_of(const Json& parameter) {
  if (parameter.contains("choices")) {
    std::string out;
    for (const Json& c : parameter["choices"]) out += (out.empty() ? "" : "|") + text_of(c);
    return out;
  }
  const bool low = parameter.contains("least"), high = parameter.contains("most");
  const auto number = [&](const char* key) { return fmt::format("{:g}", parameter[key].get<double>()); };
  if (low && high) return number("least") + " to " + number("most");
  if (low) return "from " + number("least");
  if (high) return "up to " + number("most");
  return "";
}

void print_parameters(const Json& parameters) {
  std::size_t name_width = 0, limits_width = 0;
  for (const Json& p : parameters) {
    name_width = std::max(name_width, text_of(p["name"]).size() + 1 + text_of(p["default"]).size());
    limits_width = std::max(limits_width, limits_of(p).size());
  }
  for (const Json& p : parameters)
    fmt::print("    --set {:{}}  {:{}}  {}\n", text_of(p["name"]) + "=" + text_of(p["default"]), name_width,
               limits_of(p), limits_width, text_of(p["help"]));
}

void print_described(const Json& all) {
  bool first = true;
  for (const Json& one : all) {
    if (!first) fmt::print("\n");
    first = false;
    fmt::print("{}{}: {}\n", text_of(one["name"]),
               one.contains("family") ? " (" + text_of(one["family"]) + ")" : std::string(), text_of(one["title"]));
    if (one.contains("citation")) fmt::print("    source: {}\n", text_of(one["citation"]));
    if (one.contains("capabilities") && !one["capabilities"].empty()) {
      std::string list;
      for (const Json& c : one["capabilities"]) list += (list.empty() ? "" : ", ") + text_of(c);
      fmt::print("    capabilities: {}\n", list);
    }
    fmt::print("    guarantee: {}\n", text_of(one["guarantee"]));
    print_parameters(one["parameters"]);
  }
}

/// The named members, aligned; a list is joined by blanks.
void print_aligned(const Json& all, const std::vector<std::string>& members) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> width(members.size(), 0);
  for (const Json& one : all) {
    std::vector<std::string> row;
    for (std::size_t i = 0; i < members.size(); ++i) {
      std::string cell;
      const Json& value = one.at(members[i]);
      if (value.is_array())
        for (const Json& part : value) cell += (cell.empty() ? "" : " ") + text_of(part);
      else
        cell = text_of(value);
      width[i] = std::max(width[i], cell.size());
      row.push_back(std::move(cell));
    }
    rows.push_back(std::move(row));
  }
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += i + 1 < row.size() ? fmt::format("{:{}}  ", row[i], width[i]) : row[i];
    while (!line.empty() && line.back() == ' ') line.pop_back();
    fmt::print("{}\n", line);
  }
}

struct Kind {
  const char* name;
  Json (*all)();
  void (*print)(const Json&);
};
const Kind kKinds[] = {
    {"planners", planners, print_described},
    {"maps", maps, print_described},
    {"formats", formats,
     [](const Json& j) {
       print_aligned(j, {"direction", "name", "suffixes", "title"});
     }},
    {"metrics", all_metrics,
     [](const Json& j) {
       print_aligned(j, {"name", "unit", "better", "help"});
     }},
    {"suites", suites,
     [](const Json& j) {
       print_aligned(j, {"name", "file", "title"});
     }},
    {"pages", all_pages,
     [](const Json& j) {
       print_aligned(j, {"name", "title"});
     }},
    {"columns", all_columns,
     [](const Json& j) {
       print_aligned(j, {"name", "type", "unit", "help"});
     }},
};

struct Options {
  std::string what;
  bool json = false;
};

int list(const Options& options) {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) {
    names.emplace_back(kind.name);
    if (options.what != kind.name) continue;
    const Json all = kind.all();
    if (options.json)
      fmt::print("{}\n", all.dump(2));
    else
      kind.print(all);
    return 0;
  }
  throw std::invalid_argument(fmt::format("nothing to list called '{}'; did you mean '{}'? There are: {}", options.what,
                                          nearest_name(options.what, names), fmt::join(names, ", ")));
}

std::function<int()> attach(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("WHAT", options->what, "planners, maps, formats, metrics, suites, pages or columns")->required();
  app.add_flag("--json", options->json, "for machines");
  return [options] { return list(*options); };
}

}  // namespace

Command list_command() {
  return {"list", "what there is: planners, maps, formats, metrics, suites, pages, columns",
          "  oxturn list planners\n  oxturn list maps --json\n", attach};
}

}  // namespace oxturn::cli

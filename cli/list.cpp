// oxturn list: what there is, from the descriptions themselves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text.hpp"
#include "bench/results.hpp"
#include "cli/commands.hpp"
#include "cli/programs.hpp"
#include "cli/suites.hpp"

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

Json planners(const Registry& registry) {
  Json all = Json::array();
  for (const PlannerInfo& p : registry.planners) {
    Json capabilities = Json::array();
    for (const Capability c : p.capabilities) capabilities.push_back(to_text(c));
    Json symmetries = Json::array();
    for (const Symmetry s : p.symmetries) symmetries.push_back(to_text(s));
    all.push_back({{"name", p.name},
                   {"family", p.family},
                   {"title", p.title},
                   {"citation", p.citation},
                   {"capabilities", capabilities},
                   {"guarantee", p.guarantee},
                   {"promise", to_text(p.promise)},
                   {"symmetries", symmetries},
                   {"parameters", to_json(p.parameters)}});
    if (!p.origin.empty()) all.back()["origin"] = p.origin;
  }
  return all;
}

Json maps(const Registry& registry) {
  Json all = Json::array();
  for (const GeneratorInfo& g : registry.generators)
    all.push_back(
        {{"name", g.name}, {"title", g.title}, {"guarantee", g.guarantee}, {"parameters", to_json(g.parameters)}});
  return all;
}

Json formats(const Registry& registry) {
  Json all = Json::array();
  for (const MapFormat& f : registry.formats) {
    const std::string direction = f.read && f.write ? "read and write" : f.read ? "read" : "write";
    all.push_back({{"name", f.name},
                   {"title", f.title},
                   {"suffixes", f.suffixes},
                   {"direction", direction},
                   {"parameters", to_json(f.parameters)}});
  }
  return all;
}

Json metrics(const Registry& registry) {
  Json all = Json::array();
  for (const Metric& m : registry.metrics)
    all.push_back({{"name", m.name}, {"unit", m.unit}, {"better", to_text(m.better)}, {"help", m.help}});
  return all;
}

Json tables(const Registry& registry) {
  Json all = Json::array();
  for (const ReportTable& t : registry.tables) all.push_back({{"name", t.name}, {"title", t.title}});
  return all;
}

Json robot(const Registry&) { return to_json(infos_of(robot_parameters())); }

Json suites(const Registry&) {
  Json all = Json::array();
  for (const SuiteFile& s : suite_files()) all.push_back({{"name", s.name}, {"file", s.file}, {"title", s.title}});
  return all;
}

Json columns(const Registry& registry) { return Json::parse(to_json(run_columns(registry.metrics))); }

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

void print_parameters(const Json& parameters, const char* prefix) {
  std::size_t name_width = 0, limits_width = 0;
  for (const Json& p : parameters) {
    name_width = std::max(name_width, text_of(p["name"]).size() + 1 + text_of(p["default"]).size());
    limits_width = std::max(limits_width, limits_of(p).size());
  }
  for (const Json& p : parameters)
    fmt::print("    {}{:{}}  {:{}}  {}\n", prefix, text_of(p["name"]) + "=" + text_of(p["default"]), name_width,
               limits_of(p), limits_width, text_of(p["help"]));
}

void print_described(const Json& all) {
  bool first = true;
  for (const Json& one : all) {
    if (!first) fmt::print("\n");
    first = false;
    fmt::print("{}{}: {}\n", text_of(one["name"]),
               one.contains("family") ? " (" + text_of(one["family"]) + ")" : std::string(), text_of(one["title"]));
    if (one.contains("origin")) fmt::print("    program: {}\n", text_of(one["origin"]));
    if (one.contains("citation") && !text_of(one["citation"]).empty())
      fmt::print("    source: {}\n", text_of(one["citation"]));
    if (one.contains("capabilities") && !one["capabilities"].empty()) {
      std::string list;
      for (const Json& c : one["capabilities"]) list += (list.empty() ? "" : ", ") + text_of(c);
      fmt::print("    capabilities: {}\n", list);
    }
    fmt::print("    guarantee: {}\n", text_of(one["guarantee"]));
    print_parameters(one["parameters"], "--set ");
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
  Json (*all)(const Registry&);
  void (*print)(const Json&);
};
const Kind kKinds[] = {
    {"planners", planners, print_described},
    {"maps", maps, print_described},
    {"formats", formats,
     [](const Json& j) {
       print_aligned(j, {"direction", "name", "suffixes", "title"});
     }},
    {"metrics", metrics,
     [](const Json& j) {
       print_aligned(j, {"name", "unit", "better", "help"});
     }},
    {"suites", suites,
     [](const Json& j) {
       print_aligned(j, {"name", "file", "title"});
     }},
    {"tables", tables,
     [](const Json& j) {
       print_aligned(j, {"name", "title"});
     }},
    {"robot", robot, [](const Json& j) { print_parameters(j, ""); }},
    {"columns", columns,
     [](const Json& j) {
       print_aligned(j, {"name", "type", "unit", "help"});
     }},
};

/// Those of these names, in the order of the names; all without names.
Json named(Json all, const std::string& what, const std::vector<std::string>& names) {
  if (names.empty()) return all;
  std::vector<std::string> known;
  for (const Json& one : all) known.push_back(text_of(one["name"]));
  Json some = Json::array();
  for (const std::string& name : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end())
      throw std::invalid_argument(unknown_name("entry of the list " + what + " named", name, known));
    some.push_back(all[static_cast<std::size_t>(found - known.begin())]);
  }
  return some;
}

struct Options {
  std::string what;
  std::vector<std::string> names, programs;
  bool json = false;
};

int list(const Options& options, const Registry& registry) {
  for (const Kind& kind : kKinds) {
    if (options.what != kind.name) continue;
    const Json all = named(kind.all(with_programs(registry, options.programs).registry), options.what, options.names);
    if (options.json)
      fmt::print("{}\n", all.dump(2));
    else
      kind.print(all);
    return 0;
  }
  throw std::invalid_argument(unknown_name("list", options.what, kinds_of_lists()));
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("WHAT", options->what, "planners, maps, formats, metrics, robot, suites, tables or columns")
      ->required()
      ->type_name("");
  app.add_option("NAME", options->names, "only these, by name; all if not given")->type_name("");
  add_programs(app, options->programs);
  app.add_flag("--json", options->json, "print JSON");
  return [options, &registry] { return list(*options, registry); };
}

}  // namespace

std::vector<std::string> kinds_of_lists() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

Command list_command() {
  return {"list", "what there is: planners, maps, formats, metrics, robot, suites, tables, columns",
          "  oxturn list planners\n  oxturn list planners stc\n  oxturn list maps --json\n  oxturn list planners "
          "--exec 'python3 lanes.py'\n",
          attach};
}

}  // namespace oxturn::cli

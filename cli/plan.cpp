// oxturn plan: one planner, one map, one path, scored.
#include "cli/plan.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <utility>

#include "algorithms/drawing/last_detours.hpp"
#include "base/files.hpp"
#include "bench/finish.hpp"
#include "bench/isolate.hpp"
#include "bench/suite.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/programs.hpp"
#include "cli/report_printer.hpp"
#include "maps/path_file.hpp"
#include "metrics/over_finished.hpp"
#include "metrics/sharp_bends.hpp"
#include "metrics/unfilled_areas.hpp"

namespace oxturn::cli {
namespace {

/// Everything that can be wrong with the arguments is found here, before the map is read.
bool has(const std::vector<ParameterInfo>& parameters, const std::string& name) {
  return std::ranges::any_of(parameters, [&](const ParameterInfo& p) { return p.name == name; });
}

/// Throws if a setting of the map's generator is given as one of the planner's.
void check_whose(const PlanOptions& options, const std::vector<ParameterInfo>& parameters, const MapSource& source,
                 const Generators& generators) {
  if (source.generator.empty()) return;
  for (const std::string& text : options.settings) {
    const std::string name = assignment("--set", text).first;
    if (!has(parameters, name) && has(generators.find(source.generator).parameters, name))
      throw std::invalid_argument(
          fmt::format("--set {}: '{}' is a parameter of generator '{}', not of planner '{}'; "
                      "write the map as {},{}",
                      text, name, source.generator, options.planner, options.problem.map, text));
  }
}

Settings check_arguments(const PlanOptions& options, const PlannerInfo& planner, const MapSource& source,
                         const Registry& registry) {
  const Planners& planners = registry.planners;
  // A planner that runs another one has its own parameters first: they say which others there are.
  const std::string owner = "planner '" + planner.name + "'";
  std::vector<std::string> own;
  for (const std::string& text : options.settings)
    for (const ParameterInfo& parameter : planner.parameters)
      if (text.rfind(parameter.name + "=", 0) == 0) own.push_back(text);
  const auto parameters = parameters_of(planner, parse_settings(owner, planner.parameters, own), planners);
  check_whose(options, parameters, source, registry.generators);
  Settings settings = parse_settings(owner, parameters, options.settings);
  planner.make(settings, planners);  // throws for settings that do not go together
  if (!options.output.empty()) {
    require_suffix(options.output, {".geojson", ".json"});
    require_writable(options.output);
  }
  check_outputs(options.outputs, options.output);
  return settings;
}

/// As suites name it: settings that are the defaults are left out.
std::string variant_of(const PlannerInfo& planner, Settings settings, const Planners& planners) {
  for (const ParameterInfo& parameter : parameters_of(planner, settings, planners)) {
    const auto given = settings.find(parameter.name);
    if (given != settings.end() && given->second == parameter.fallback) settings.erase(given);
  }
  return PlannerSpec{planner.name, std::move(settings)}.variant();
}

/// A line on a terminal that is overwritten; nothing elsewhere.
std::function<void(double)> progress_line() {
  if (::isatty(2) != 1) return {};
  return [](double fraction) {
    fmt::print(stderr, "\rplanning {:3.0f} %{}", 100 * fraction, fraction < 1 ? "" : "\r\033[K");
    std::fflush(stderr);
  };
}

/// The path with its problem; a map's file is named as seen from the path's folder. A map that came from standard input
/// cannot be loaded again, so it is not named.
void write_path(const std::string& file, const Path& path, const Problem& problem, MapSource source) {
  namespace fs = std::filesystem;
  if (is_standard_stream(source.file) || is_standard_stream(source.target)) return write_file(file, to_geojson(path));
  for (std::string* name : {&source.file, &source.target})
    if (!name->empty()) *name = fs::proximate(*name, fs::absolute(file).parent_path()).generic_string();
  const PathProblem made_for = path_problem(problem, std::move(source));
  write_file(file, to_geojson(path, &made_for));
}

/// Where a transit of the planner's is part of the leg: both its ends are vertices of it.
bool is_part_of(const Polyline& transit, const Polyline& leg, double tolerance) {
  const auto has = [&](const Point& p) {
    return std::ranges::any_of(leg, [&](const Point& q) { return distance(p, q) <= tolerance; });
  };
  return !transit.empty() && has(transit.front()) && has(transit.back());
}

/// As the planner says by its traces (algorithms/drawing/beachbot.cpp); empty for planners that do not.
std::string why_over_finished(const Problem& problem, const Planned& planned, const TransitOver& over) {
  const double radius = problem.robot().min_turn_radius;
  using End = LastDetour::End;
  const std::pair<End, std::string> reasons[] = {
      {End::enclosed, ": finished work encloses one of its ends"},
      {End::no_curve, fmt::format(": no detour exists at radius {:g} m", radius)},
      {End::effort_spent, ": the effort for detours ran out before one was found"},
      {End::by_hand, ": so a person drew it"}};
  for (const auto& [end, reason] : reasons)
    for (const Trace& trace : planned.traces)
      if (trace.name == trace_of_crossing(end) && std::ranges::any_of(trace.lines, [&](const Polyline& line) {
            return is_part_of(line, planned.path->legs[over.leg].points, problem.tolerance());
          }))
        return reason;
  return "";
}

/// Says ten of these sentences, and how many more there are.
void say_some(const std::vector<std::string>& sentences, const char* more) {
  constexpr std::size_t kMostSaid = 10;
  for (std::size_t k = 0; k < std::min(sentences.size(), kMostSaid); ++k) say(sentences[k]);
  if (sentences.size() > kMostSaid)
    say(fmt::format("{} more {}: see --json or --viewer", sentences.size() - kMostSaid, more));
}

/// On a drawing: what is not filled, where the path bends too sharply, and what drives over finished work. All goes to
/// the page and to JSON.
std::vector<std::string> remarks_on_path(const Problem& problem, const Planned& planned) {
  std::vector<std::string> all = remarks_on(unfilled_areas(problem, *planned.path));
  say_some(all, "areas are not filled completely");
  if (const auto thin = std::ranges::find(planned.records, "areas_with_thin_lines", &Records::value_type::first);
      thin != planned.records.end() && thin->second > 0) {
    all.push_back(fmt::format(
        "{:.0f} areas are narrower than one pin, or parts of them: they are drawn as lines along their middle, "
        "wider than they are (--set thin_areas=skip leaves them out)",
        thin->second));
    say(all.back());
  }
  for (std::string& sentence : remarks_on_sharp_bends(problem, *planned.path)) {
    say(sentence);
    all.push_back(std::move(sentence));
  }
  const auto why = [&](const TransitOver& t) { return why_over_finished(problem, planned, t); };
  const auto over = remarks_on(transits_over_finished(problem, *planned.path), why);
  say_some(over, "transits drive over finished work");
  all.insert(all.end(), over.begin(), over.end());
  return all;
}

Report run_planner(const PlanOptions& options, const PlannerInfo& planner, const Settings& settings,
                   const Problem& problem, const MapSource& source, const Registry& registry) {
  Report report;
  report.about = {{"planner", variant_of(planner, settings, registry.planners)}};
  build_scoring_parts(problem);  // the planner's process gets them, too
  IsolationOptions isolation = options.isolation;
  isolation.progress = progress_line();
  isolation.traces = options.outputs.traces || !options.outputs.viewer.empty() || problem.map().drawing != nullptr;
  isolation.log_file = kLogToStandardError;
  const auto make = [&] { return planner.make(settings, registry.planners); };
  const Planned planned = plan_isolated(make, problem, isolation);
  if (planned.wall_s > 0)
    report.costs = {
        {"plan_wall_s", planned.wall_s}, {"plan_cpu_s", planned.cpu_s}, {"peak_rss_bytes", planned.peak_rss_bytes}};
  report.records = planned.records;
  OutputOptions outputs = options.outputs;
  if (is_scored(planned)) {
    ScoreOptions scoring = score_options(planned, planner.promised(settings, problem.robot()));
    report.about.emplace_back("promise", to_text(scoring.promise));
    if (outputs.svg.empty()) scoring.outlines = MissedOutlines::left_out;
    report.score = score(problem, *planned.path, registry.metrics, scoring);
    report.remarks = outputs.remarks = remarks_on_path(problem, planned);
    if (!options.output.empty()) write_path(options.output, *planned.path, problem, source);
  }
  report.verdict = judge(planned, report.score, Suite{}.target_coverage);
  write_outputs(outputs, problem, planned.path ? &*planned.path : nullptr, report.score, planned.traces);
  return report;
}

}  // namespace

int plan(PlanOptions options, const Registry& built_in) {
  const auto [registry, programs] = with_programs(built_in, options.programs);
  if (options.problem.map.empty() && !programs.empty()) {  // the program is the planner: what is named is the map
    options.problem.map = options.planner;
    options.planner = programs.front();
  }
  if (options.problem.map.empty())
    throw std::invalid_argument(
        fmt::format("{} is missing. See `oxturn plan --help`", options.planner.empty() ? "PLANNER" : "MAP"));
  const PlannerInfo& planner = registry.planners.find(options.planner);
  const MapSource source = map_source(options.problem, registry);
  const Settings settings = check_arguments(options, planner, source, registry);
  const Problem problem = make_problem(options.problem, load_map(source, registry.generators, registry.formats));
  check_outputs(options.outputs, problem.robot());
  std::FILE* const out = print_to({options.output, options.outputs.svg, options.outputs.viewer,
                                   options.outputs.tether_trace, options.outputs.text});
  if (const std::string missing = missing_capability(planner, problem); !missing.empty()) {
    Report report;
    report.about = {{"planner", variant_of(planner, settings, registry.planners)}};
    report.verdict = {Outcome::unsupported, missing};
    return print(report, problem, registry.metrics, options.json, out);
  }
  options.outputs.widths = drawing_widths(source.settings);
  const Report report = run_planner(options, planner, settings, problem, source, registry);
  return print(report, problem, registry.metrics, options.json, out);
}

void add_plan_options(CLI::App& app, const Registry& registry, PlanOptions& options) {
  add_programs(app, options.programs);
  add_settings(app, options.settings, "planner", "planners");
  app.add_option("--seed", options.isolation.seed, "seed of the planner's random choices; 1 if not given")
      ->check(whole_number())
      ->type_name("N");
  app.add_option("-o,--output", options.output,
                 "write the path and the name of its problem, FILE.geojson; - is standard output")
      ->type_name("FILE");
  add_output_options(app, options.outputs);
  add_problem_options(app, registry, options.problem);
  app.add_option("--wall", options.isolation.limits.wall_s, "time limit of planning, seconds; 60 if not given")
      ->check(number_from(0, false, "seconds"))
      ->type_name("S");
  app.add_option("--memory", options.isolation.limits.memory_mb,
                 "memory limit of planning, megabytes; 4096 if not given")
      ->check(number_from(0, false, "megabytes"))
      ->type_name("MB");
  app.add_flag("--traces", options.outputs.traces,
               "with --svg: draw the planner's intermediate results too: cells, trees, partitions");
  app.add_flag("--json", options.json, "print JSON");
}

namespace {

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<PlanOptions>();
  app.add_option("PLANNER", options->planner, "a planner (`oxturn list planners`); the one of --exec if not given")
      ->type_name("");
  app.add_option("MAP", options->problem.map, kMapHelp)->type_name("");
  add_plan_options(app, registry, *options);
  return [options, &registry] { return plan(*options, registry); };
}

}  // namespace

Command plan_command() {
  return {"plan", "plan one path on one map, and score it",
          "  oxturn plan boustrophedon rooms:7 --svg plan.svg\n"
          "  oxturn plan zigzag kitchen.yaml --radius 0.17 --tool-width 0.3 -o path.geojson\n"
          "  oxturn plan --exec 'python3 lanes.py' rooms:7 --set spacing=0.8\n"
          "  oxturn plan stc rooms:7 -o - | oxturn score -\n"
          "  oxturn plan stc lab.yaml --drop-speckle 0.02 --start 12,3.5 --json\n"
          "\nExit code 0 for outcome ok or partial, 1 for any other.\n",
          attach};
}

}  // namespace oxturn::cli

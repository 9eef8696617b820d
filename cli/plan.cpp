// oxturn plan: one planner, one map, one path, scored.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "algorithms/coverage_planner.hpp"
#include "bench/run_suite.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/verdict.hpp"
#include "maps/formats.hpp"
#include "base/files.hpp"
#include "maps/path_file.hpp"
#include "maps/picture.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string planner, output, svg, tether_trace;
  int tethers = PictureOptions{}.tethers;
  std::vector<std::string> settings;
  ProblemOptions problem;
  IsolationOptions isolation;
  bool json = false;
};

/// Everything that can be wrong with the arguments is found here, before the map is read.
Settings check_arguments(const Options& options, const PlannerInfo& planner) {
  // A planner that runs another one has its own parameters first: they say which others there are.
  const std::string owner = "planner '" + planner.name + "'";
  std::vector<std::string> own;
  for (const std::string& text : options.settings)
    for (const ParameterInfo& parameter : planner.parameters)
      if (text.rfind(parameter.name + "=", 0) == 0) own.push_back(text);
  const auto parameters = parameters_of(planner, parse_settings(owner, planner.parameters, own));
  Settings settings = parse_settings(owner, parameters, options.settings);
  planner.make(settings);  // throws for settings that do not go together
  if (!options.output.empty()) {
    require_suffix(options.output, {".geojson", ".json"});
    require_writable(options.output);
  }
  if (!options.svg.empty()) {
    require_suffix(options.svg, {".svg"});
    require_writable(options.svg);
  }
  check_tether_trace(options.tether_trace);
  return settings;
}

/// As suites name it: settings that are the defaults are left out.
std::string variant_of(const PlannerInfo& planner, Settings settings) {
  for (const ParameterInfo& parameter : parameters_of(planner, settings)) {
    const auto given = settings.find(parameter.name);
    if (given != settings.end() && given->second == parameter.fallback) settings.erase(given);
  }
  return PlannerSpec{planner.name, std::move(settings)}.variant();
}

int plan(const Options& options) {
  const PlannerInfo& planner = find_planner(zoo(), options.planner);
  const Settings settings = check_arguments(options, planner);
  const Problem problem = load_problem(options.problem);
  check_tether_trace(options.tether_trace, problem.robot());
  Verdict verdict;
  verdict.about = {{"planner", variant_of(planner, settings)}};
  verdict.reason = missing_capability(planner, problem);
  if (!verdict.reason.empty()) {
    verdict.outcome = Outcome::unsupported;
    return tell(verdict, problem, options.json);
  }
  problem.walls();  // as in a sweep: scoring needs them, so they are no cost of the planner's
  const Planned planned = plan_isolated(planner, settings, problem, options.isolation);
  verdict.outcome = planned.outcome;
  verdict.reason = planned.reason;
  if (planned.wall_s > 0)
    verdict.costs = {
        {"plan_wall_s", planned.wall_s}, {"plan_cpu_s", planned.cpu_s}, {"peak_rss_bytes", planned.peak_rss_bytes}};
  verdict.reports = planned.reports;
  // As in a sweep: a timeout is scored on the last path it published, a crash is not.
  if (planned.path && (planned.outcome == Outcome::ok || planned.outcome == Outcome::timeout)) {
    judge(verdict, problem, *planned.path);
    if (planned.outcome == Outcome::timeout) {
      verdict.outcome = planned.outcome;
      verdict.reason = planned.reason + "; scored is the last path it published";
    }
    if (!options.output.empty()) write_file(options.output, to_geojson(*planned.path));
    write_tether_trace(options.tether_trace, problem, *planned.path);
  }
  if (!options.svg.empty()) {
    PictureOptions picture;
    picture.traces = &planned.traces;
    picture.tethers = options.tethers;
    write_file(options.svg, to_svg(problem, planned.path ? &*planned.path : nullptr, picture));
  }
  return tell(verdict, problem, options.json);
}

std::function<int()> attach(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("PLANNER", options->planner, "as `oxturn list planners` names it")->required();
  app.add_option("MAP", options->problem.map, "a map's file, or GENERATOR[:SEED]")->required();
  add_settings(app, options->settings, "planner");
  app.add_option("--seed", options->isolation.seed, "of the planner's random choices; 1 if not given")
      ->check(whole_number())
      ->type_name("N");
  app.add_option("-o,--output", options->output, "write the path, FILE.geojson")->type_name("FILE");
  app.add_option("--svg", options->svg, "draw it")->type_name("FILE");
  add_tethers_drawn(app, options->tethers);
  add_tether_trace(app, options->tether_trace);
  add_problem_options(app, options->problem);
  app.add_option("--wall", options->isolation.limits.wall_s, "time limit; 60 if not given")
      ->check(number_from(0, false, "seconds"))
      ->type_name("S");
  app.add_option("--memory", options->isolation.limits.memory_mb, "memory limit; 4096 if not given")
      ->check(number_from(0, false, "megabytes"))
      ->type_name("MB");
  app.add_flag("--traces", options->isolation.traces, "draw the planner's inside too: cells, trees, partitions");
  app.add_flag("--json", options->json, "for machines");
  return [options] { return plan(*options); };
}

}  // namespace

Command plan_command() {
  return {"plan", "plan one path on one map, and score it",
          "  oxturn plan boustrophedon rooms:7 --svg plan.svg\n"
          "  oxturn plan zigzag kitchen.yaml --radius 0.17 --tool-width 0.3 -o path.geojson\n"
          "  oxturn plan stc lab.yaml --drop-speckle 0.02 --start 12,3.5 --json\n"
          "Exit code 0 for outcome ok or partial, 1 for any other.\n",
          attach};
}

}  // namespace oxturn::cli

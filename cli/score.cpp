// oxturn score: anyone's path, scored.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "bench/suite.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/problem_options.hpp"
#include "cli/report_printer.hpp"
#include "maps/path_file.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string path;
  OutputOptions outputs;
  ProblemOptions problem;
  double tolerance = 0;
  bool json = false;
};

/// MAP, or if it is not given the map that the path's file names.
MapFile map_of(const Options& options, const PathFile& file, const Registry& registry) {
  if (!options.problem.map.empty())
    return load_map(map_source(options.problem, registry), registry.generators, registry.formats);
  if (!file.problem)
    throw std::invalid_argument(
        fmt::format("'{}' does not name the problem that it was made for; give MAP", options.path));
  if (!options.problem.target.empty())
    throw std::invalid_argument("--target applies to MAP; give MAP, or leave it out");
  if (!options.problem.read.empty())
    throw std::invalid_argument("options for map files apply to MAP; give MAP, or leave them out");
  return load_map(*file.problem, options.path, registry.generators, registry.formats);
}

int score_path(const Options& options, const Registry& registry) {
  check_outputs(options.outputs);
  require_one_stream({{"PATH", options.path}, {"MAP", options.problem.map}}, "standard input");
  const PathFile file = read_path_file(options.path);
  const Problem problem = make_problem(options.problem, map_of(options, file, registry));
  check_outputs(options.outputs, problem.robot());
  Report report;
  report.about = {{"path", options.path}};
  report.tolerance = problem.tolerance() + options.tolerance;
  const auto outlines = options.outputs.svg.empty() ? MissedOutlines::left_out : MissedOutlines::kept;
  report.score = score(problem, file.path, registry.metrics, {.tolerance = options.tolerance, .outlines = outlines});
  report.verdict = judge(*report.score, Suite{}.target_coverage);
  write_outputs(options.outputs, problem, &file.path, report.score, {}, options.tolerance);
  return print(
      report, problem, registry.metrics, options.json,
      print_to({options.outputs.svg, options.outputs.viewer, options.outputs.tether_trace, options.outputs.text}));
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("PATH", options->path,
                 "GeoJSON: LineStrings in driving order with the property `tool`; or CSV: x,y[,tool], metres; - is "
                 "standard input")
      ->required()
      ->type_name("");
  app.add_option("MAP", options->problem.map, std::string(kMapHelp) + "; the problem that PATH names if not given")
      ->type_name("");
  app.add_option(
         "--tolerance", options->tolerance,
         "for rounded or recorded paths: how far, metres, the path may lie outside configuration space and over "
         "the tether's limit, start beside the start, and jump between legs; 0 if not given, which still allows "
         "for rounding in double precision")
      ->check(number_from(0, true, "metres"))
      ->type_name("M");
  add_problem_options(app, registry, options->problem);
  add_output_options(app, options->outputs);
  app.add_flag("--json", options->json, "print JSON");
  return [options, &registry] { return score_path(*options, registry); };
}

}  // namespace

Command score_command() {
  return {"score", "score a path, whoever planned or recorded it",
          "  oxturn score mine.geojson kitchen.yaml --radius 0.17 --tool-width 0.3 --start 1,2\n"
          "  oxturn score recorded.csv rooms:7 --tolerance 0.001 --svg mine.svg\n"
          "  oxturn plan stc rooms:7 -o - | oxturn score - rooms:7 --svg - > stc.svg\n"
          "  oxturn score out/paths/0123456789abcdef.geojson        on the problem that the file names\n"
          "\nExit code 1 if the path is invalid.\n",
          attach};
}

}  // namespace oxturn::cli

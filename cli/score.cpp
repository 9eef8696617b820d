// oxturn score: anyone's path, scored.
#include <memory>

#include "bench/suite.hpp"
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
  bool json = false;
};

int score_path(const Options& options, const Registry& registry) {
  const Path path = read_path(options.path);
  check_outputs(options.outputs);
  const Problem problem = load_problem(options.problem, registry);
  check_outputs(options.outputs, problem.robot());
  Report report;
  report.about = {{"path", options.path}};
  report.score = score(problem, path, registry.metrics);
  report.verdict = judge(*report.score, Suite{}.target_coverage);
  write_outputs(options.outputs, problem, &path, report.score, {});
  return print(report, problem, registry.metrics, options.json);
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("PATH", options->path, "a path's GeoJSON file: LineStrings in driving order, property `tool`")
      ->required();
  app.add_option("MAP", options->problem.map, "a map's file, or GENERATOR[:SEED]")->required();
  add_problem_options(app, registry, options->problem);
  add_output_options(app, options->outputs);
  app.add_flag("--json", options->json, "print JSON");
  return [options, &registry] { return score_path(*options, registry); };
}

}  // namespace

Command score_command() {
  return {"score", "score anyone's path on a map",
          "  oxturn score mine.geojson kitchen.yaml --radius 0.17 --tool-width 0.3 --start 1,2\n"
          "  oxturn score mine.geojson rooms:7 --svg mine.svg\n"
          "Exit code 1 if the path is invalid.\n",
          attach};
}

}  // namespace oxturn::cli

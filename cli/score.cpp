// oxturn score: anyone's path, scored.
#include <memory>

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
  std::string path, svg, tether_trace;
  int tethers = PictureOptions{}.tethers;
  ProblemOptions problem;
  bool json = false;
};

int score_path(const Options& options) {
  const Path path = read_path(options.path);
  if (!options.svg.empty()) {
    require_suffix(options.svg, {".svg"});
    require_writable(options.svg);
  }
  check_tether_trace(options.tether_trace);
  const Problem problem = load_problem(options.problem);
  check_tether_trace(options.tether_trace, problem.robot());
  Verdict verdict;
  verdict.about = {{"path", options.path}};
  judge(verdict, problem, path);
  PictureOptions picture;
  picture.tethers = options.tethers;
  if (!options.svg.empty()) write_file(options.svg, to_svg(problem, &path, picture));
  write_tether_trace(options.tether_trace, problem, path);
  return tell(verdict, problem, options.json);
}

std::function<int()> attach(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("PATH", options->path, "a path's GeoJSON file: LineStrings in driving order, property `tool`")
      ->required();
  app.add_option("MAP", options->problem.map, "a map's file, or GENERATOR[:SEED]")->required();
  add_problem_options(app, options->problem);
  app.add_option("--svg", options->svg, "also draw it")->type_name("FILE");
  add_tethers_drawn(app, options->tethers);
  add_tether_trace(app, options->tether_trace);
  app.add_flag("--json", options->json, "for machines");
  return [options] { return score_path(*options); };
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

#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/files.hpp"
#include "cli/arguments.hpp"
#include "metrics/tether_trace.hpp"

namespace oxturn::cli {

void add_output_options(CLI::App& app, OutputOptions& options) {
  app.add_option("--svg", options.svg, "draw the path, FILE.svg")->type_name("FILE");
  app.add_option("--tethers", options.tethers,
                 "how often a tether is drawn along the path, besides where it is longest; 0: never")
      ->check(CLI::Range(0, 1000))
      ->type_name("N");
  app.add_option("--tether-trace", options.tether_trace,
                 "write the tether's length, bends and angle along the path, FILE.csv")
      ->type_name("FILE");
}

void check_outputs(const OutputOptions& options) {
  if (!options.svg.empty()) {
    require_suffix(options.svg, {".svg"});
    require_writable(options.svg);
  }
  if (!options.tether_trace.empty()) {
    require_suffix(options.tether_trace, {".csv"});
    require_writable(options.tether_trace);
  }
}

void check_outputs(const OutputOptions& options, const Robot& robot) {
  if (!options.tether_trace.empty() && !robot.tether)
    throw std::invalid_argument(
        fmt::format("--tether-trace: robot '{}' has no tether; give it one with --robot tether=METRES", robot.name));
}

void write_outputs(const OutputOptions& options, const Problem& problem, const Path* path,
                   const std::vector<Trace>& traces) {
  if (!options.svg.empty()) {
    PictureOptions picture;
    picture.traces = &traces;
    picture.tethers = options.tethers;
    write_file(options.svg, to_svg(problem, path, picture));
  }
  if (!options.tether_trace.empty() && path != nullptr)
    write_file(options.tether_trace, to_csv(tether_trace(problem, *path, problem.robot().tool_width)));
}

}  // namespace oxturn::cli

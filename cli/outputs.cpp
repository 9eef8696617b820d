#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/files.hpp"
#include "bench/run_picture.hpp"
#include "cli/arguments.hpp"
#include "metrics/tether_trace.hpp"
#include "reports/viewer/viewer.hpp"

namespace oxturn::cli {

void add_output_options(CLI::App& app, OutputOptions& options) {
  app.add_option("--svg", options.svg, "write a picture of the path, FILE.svg; - is standard output")
      ->type_name("FILE");
  app.add_option("--viewer", options.viewer,
                 "write a page to look at the path in a browser, played in time, FILE.html; - is standard output")
      ->type_name("FILE");
  app.add_option("--text", options.text,
                 "write the path as a drawing robot's controller reads it, x y rake, FILE.txt; - is standard output")
      ->type_name("FILE");
  app.add_option("--rake", options.rake,
                 "with --text: the rake as a mask of its pins, or as their number; mask if not given")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, RakeText>{{"mask", RakeText::mask}, {"pins", RakeText::pins}})
              .description(""))
      ->type_name("mask|pins");
  app.add_option(
         "--tethers", options.tethers,
         "with --svg: at how many positions along the path the tether is drawn, besides where it is longest; 8 if "
         "not given; 0: not at all")
      ->check(CLI::Range(0, 1000).description(""))
      ->type_name("N");
  app.add_option("--tether-trace", options.tether_trace,
                 "write the tether's length, bends and angle along the path, FILE.csv; - is standard output")
      ->type_name("FILE");
}

DrawingOptions drawing_widths(const Settings& settings) {
  DrawingOptions widths;
  for (auto& [name, width] : {std::pair("width_1", &widths.width_1), std::pair("width_3", &widths.width_3),
                              std::pair("width_5", &widths.width_5), std::pair("width_7", &widths.width_7)})
    if (const auto given = settings.find(name); given != settings.end()) *width = std::get<double>(given->second);
  return widths;
}

void check_outputs(const OutputOptions& options, const std::string& path_output) {
  require_one_stream({{"--output", path_output},
                      {"--svg", options.svg},
                      {"--viewer", options.viewer},
                      {"--text", options.text},
                      {"--tether-trace", options.tether_trace}},
                     "standard output");
  if (!options.text.empty()) {
    require_suffix(options.text, {".txt"});
    require_writable(options.text);
  }
  if (!options.svg.empty()) {
    require_suffix(options.svg, {".svg"});
    require_writable(options.svg);
  }
  if (!options.viewer.empty()) {
    require_suffix(options.viewer, {".html"});
    require_writable(options.viewer);
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
                   const std::optional<Score>& score, const std::vector<Trace>& traces, double tolerance) {
  if (!options.svg.empty()) {
    PictureOptions picture;
    picture.tethers = options.tethers;
    picture.tolerance = tolerance;
    write_file(options.svg, run_picture(problem, path, score, options.traces ? traces : std::vector<Trace>{}, picture));
  }
  if (!options.viewer.empty())
    write_file(options.viewer, viewer_page({.problem = problem,
                                            .path = path,
                                            .traces = traces,
                                            .score = score,
                                            .drawing_file = problem.map().family == "file" ? problem.map().source : "",
                                            .edits = options.edits,
                                            .remarks = options.remarks}));
  if (!options.text.empty() && path != nullptr)
    write_file(options.text, drawing_text(*path, options.widths, options.rake));
  if (!options.tether_trace.empty() && path != nullptr)
    write_file(options.tether_trace, to_csv(tether_trace(problem, *path, problem.robot().tool_width, tolerance)));
}

}  // namespace oxturn::cli

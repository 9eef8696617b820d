/// What `plan` and `score` write beside their table: a picture, a page to look at, and the tether's trace.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "maps/drawing_text.hpp"
#include "maps/picture.hpp"
#include "metrics/score.hpp"

namespace oxturn::cli {

struct OutputOptions {
  std::string svg, viewer, tether_trace, text;
  RakeText rake = RakeText::mask;
  DrawingOptions widths;             // of the rake's pins
  std::string edits;                 // JSON: of the drawing, for the viewer
  std::vector<std::string> remarks;  // on the path, for the viewer
  bool traces = false;               // the picture shows the planner's traces; the viewer always does
  int tethers = PictureOptions{}.tethers;
};
/// The widths among the settings of a drawing's reader.
DrawingOptions drawing_widths(const Settings& settings);
/// --svg FILE, --viewer FILE, --text FILE, --rake mask|pins, --tethers N, --tether-trace FILE.csv.
void add_output_options(CLI::App& app, OutputOptions& options);
/// Throws if a file's name is wrong or cannot be written, or if several are standard output. `path_output`: where the
/// path is written, if anywhere.
void check_outputs(const OutputOptions& options, const std::string& path_output = {});
/// Throws if a tether's trace is asked for and there is no tether.
void check_outputs(const OutputOptions& options, const Robot& robot);
/// Writes what was asked for. `path`: nullptr if there is none; `score`: of the path, with this tolerance.
void write_outputs(const OutputOptions& options, const Problem& problem, const Path* path,
                   const std::optional<Score>& score, const std::vector<Trace>& traces, double tolerance = 0);

}  // namespace oxturn::cli

/// Reads a drawing from an SVG file and fits it to a canvas.
///
///   const SvgDrawing read = drawing_from_svg(read_file("whale.svg"), "whale.svg", {.canvas_width = 20});
///   for (const std::string& remark : read.remarks) std::cerr << remark << "\n";
///
/// Strokes as wide as 1, 3, 5 or 7 pins of the rake, areas to fill, the start; docs/drawings.md has the syntax and what
/// of SVG is understood. Source: Vollprecht 2014, section 3.2.
#pragma once

#include <string>
#include <vector>

#include "maps/drawing.hpp"

namespace oxturn {

struct DrawingOptions {
  double canvas_width = 20, canvas_height = 15;  // metres
  double margin = 0.2;                           // metres that stay empty along the canvas's boundary
  /// Metres that are drawn by strokes up to 1, 3, 5 and more pixels wide.
  double width_1 = 0.04, width_3 = 0.16, width_5 = 0.32, width_7 = 0.42;
  /// As Vollprecht's program: stroke widths without transforms, white areas ignored instead of erasing, open subpaths
  /// not filled, the first subpath minus the others filled, the canvas fitted to vertices.
  bool literal = false;
};

struct SvgDrawing {
  Drawing drawing;
  std::vector<std::string> remarks;  // what is not drawn, or otherwise than written: "FILE:LINE: sentence"
};

/// Bounded in time and memory whatever the bytes: 16 MiB, 10^6 nodes and path commands, 5 * 10^6 vertices. Throws
/// std::invalid_argument "FILE:LINE: what is wrong" for what is no SVG, has nothing to draw, or is beyond these limits;
/// std::invalid_argument for options without room for the drawing.
SvgDrawing drawing_from_svg(const std::string& text, const std::string& file, const DrawingOptions& options = {});

}  // namespace oxturn

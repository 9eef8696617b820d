/// The parts of an SVG picture, from the background to the front. Each appends its elements to `out`. Private to
/// maps/formats; svg.cpp puts them together.
#pragma once

#include "geometry/trace.hpp"
#include "maps/formats/svg_canvas.hpp"
#include "maps/problem.hpp"

namespace oxturn::svg {

// svg_frame.cpp

/// Opens the picture: its size, grey walls, white free space.
void append_frame(std::string& out, const Canvas& canvas, const std::string& name, const Region& free);
/// A bar of 1, 2 or 5 x 10^k metres, below the map.
void append_scale_bar(std::string& out, const Canvas& canvas);
/// The colours of the path from start to end, if there is room beside the bar.
void append_colour_key(std::string& out, const Canvas& canvas);
/// Blue, cyan, green, amber, red for t from 0 to 1: "#rrggbb".
std::string time_colour(double t);

// svg_path.cpp

/// The area under the tool, within free space; darker where it is covered again.
void append_swath(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path);
/// Convex parts of the target that the path missed.
void append_missed(std::string& out, const Canvas& canvas, const std::vector<Ring>& missed);
/// Transit dashed, work coloured by the distance driven, with arrowheads; white dots where it is driven backwards.
void append_path(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path);
/// Traces of one name have one colour.
void append_traces(std::string& out, const Canvas& canvas, const std::vector<Trace>& traces);

// svg_tethers.cpp

/// The tether at `count` moments, and where it is longest.
void append_tethers(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path, int count,
                    double tolerance);

}  // namespace oxturn::svg

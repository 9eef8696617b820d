/// Pictures of maps, problems and paths, as SVG.
///
///   write_file("plan.svg", to_svg(problem, &path));
#pragma once

#include "geometry/path.hpp"
#include "geometry/trace.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct PictureOptions {
  double width_px = 1000;
  bool swath = true;                           // draws the tool's swath under the path
  const std::vector<Ring>* missed = nullptr;   // parts of the target that the path missed
  const std::vector<Trace>* traces = nullptr;  // each in a colour of its own, by their order
  // Robots with a tether: it is drawn so often, equally spaced along the path, and where it is longest; 0: not at all.
  int tethers = 8;
  double tolerance = 0;  // metres, added to the problem's: within which a tether follows the path
};

/// A problem and (if given) a path: walls, target, path coloured by time from blue to red, transit dashed, start and a
/// tether's anchor marked. Long paths are drawn in at most a few thousand coloured pieces.
std::string to_svg(const Problem& problem, const Path* path, const PictureOptions& options = {});

/// The free space on grey walls, with a scale bar. No robot, no start.
std::string to_svg(const Map& map, const PictureOptions& options = {});

/// Text made fit for XML and HTML, attributes included; control characters become spaces.
std::string escape_xml(const std::string& text);

}  // namespace oxturn

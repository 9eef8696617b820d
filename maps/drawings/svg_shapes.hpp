/// SVG's basic shapes as outlines. Private to maps.
///
///   const ShapeResult shape = outline_of(node, {.width = 210, .height = 297}, most_commands);
#pragma once

#include <pugixml.hpp>
#include <string>

#include "maps/drawings/svg_values.hpp"

namespace oxturn::svg {

/// What percentages refer to: the size of the nearest view box, user units.
struct Viewport {
  double width = 0, height = 0;
  double diagonal() const { return std::sqrt((width * width + height * height) / 2); }
};

struct Shape {
  Outline outline;           // user units
  std::size_t commands = 0;  // of path data; else its size
  std::string problem;       // a sentence about what is wrong; the outline is what can be drawn of it
};
/// Is it path, rect, circle, ellipse, line, polyline or polygon?
bool is_shape(std::string_view name);
/// Of the element called `name`, with at most `most` commands. Closed subpaths are marked so.
Shape shape_of(std::string_view name, const pugi::xml_node& node, const Viewport& viewport, std::size_t most);

/// The length in an attribute, or `fallback` if there is none; NaN if it is not understood.
double length_of(const pugi::xml_node& node, const char* attribute, double whole, double fallback);

}  // namespace oxturn::svg

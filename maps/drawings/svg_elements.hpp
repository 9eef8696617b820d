/// The shapes that an SVG document shows, with their styles, in CSS pixels. Private to maps.
///
///   const Elements found = read_elements(read_file("whale.svg"), "whale.svg", false);
///   for (const Element& e : found.elements) ...
///
/// Understood: nested svg, g, a, switch, symbol, use, basic shapes, paths with all commands, transforms, view boxes,
/// units, style sheets with simple selectors. Anything else that would show becomes a remark with its line. Limits
/// keep time and memory bounded whatever the bytes. Source: SVG 1.1 (2nd edition).
#pragma once

#include <string>
#include <vector>

#include "geometry/overlay/fill_rule.hpp"
#include "maps/drawings/svg_values.hpp"

namespace oxturn::svg {

struct Element {
  std::string id;  // its id if no other element has it, else its position among its parents' children: "0/3/1"
  std::size_t line = 0;
  Outline outline;  // CSS pixels, y down
  Paint fill = Paint::none, stroke = Paint::none;
  FillRule rule = FillRule::nonzero;
  double stroke_width = 1;  // CSS pixels
};

struct Elements {
  std::vector<Element> elements;     // in the order in which they are painted
  std::vector<std::string> remarks;  // "FILE:LINE: sentence"
  std::size_t root_line = 1;         // of the svg element
};

/// `widths_as_written`: stroke widths ignore transforms. Throws std::invalid_argument "FILE:LINE: what is wrong" for
/// what is no SVG and for documents beyond the limits.
Elements read_elements(const std::string& text, const std::string& file, bool widths_as_written);

}  // namespace oxturn::svg

/// A drawing: what a drawing robot is to leave on a canvas. Strokes are driven once with a tool as wide as they are
/// drawn; filled regions are covered.
///
///   Drawing drawing;
///   drawing.strokes.push_back({.element = "path1", .points = {{1, 1}, {4, 1}}, .width = 0.16});
///   map.drawing = std::make_shared<const Drawing>(std::move(drawing));
///
/// Metres on the canvas, y up. Source: Vollprecht 2014, chapters 3 and 4.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// One curve, driven from end to end. Closed if its last point repeats its first.
struct DrawnStroke {
  std::string element;               // id of the element that it comes from
  Polyline points;                   // flattened; at least two
  double width = 0;                  // metres, > 0: as wide as the tool draws
  bool tool = true;                  // false: it is driven here with the tool off (as the drawing prescribes)
  std::vector<std::size_t> nodes;    // positions in `points` of the source's own nodes, in order
  std::vector<std::size_t> corners;  // positions in `points` at which the tangents differ by more than a degree
  std::size_t line = 0;              // of the element in the file; 0: unknown
};

/// How a filled region is covered; empty values leave the choice to the planner.
struct FillChoice {
  std::string fill;             // "", "spiral", "zigzag", "contour", or "none"
  std::optional<double> angle;  // of the lanes, radians
  std::optional<bool> outline;  // a lap along the boundary after the fill
};

/// A connected filled region.
struct FilledArea {
  std::string element;
  Polygon area;
  FillChoice choice;
};

/// A node of an element's stroke, or of an area's boundary: 0 is its first, -1 its last.
struct NodeOfElement {
  std::string element;
  int node = 0;
};

/// A connection between two elements that a person demands or forbids.
struct DrawnConnection {
  NodeOfElement from, to;
  bool enforced = true;  // false: deleted, the path never connects these two
};

/// A connection whose course a person has drawn.
struct DrawnCurve {
  NodeOfElement from, to;
  enum class Kind { spiro, bezier } kind = Kind::spiro;
  Polyline points;  // control points between the two nodes
};

struct Drawing {
  std::vector<DrawnStroke> strokes;  // in document order
  std::vector<FilledArea> areas;     // in document order, interiors disjoint
  std::optional<Point> start;        // where the path begins
  std::vector<DrawnConnection> connections;
  std::vector<DrawnCurve> curves;
  std::string sha256;  // of the file that it was read from
};

}  // namespace oxturn

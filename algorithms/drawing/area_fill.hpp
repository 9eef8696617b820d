/// Fills of the areas of a drawing, by planners of the zoo.
///
///   AreaFiller filler(problem, planners, {.fill = "spiral"});
///   for (DrawingElement& fill : filler.elements(area, context)) ...
///
/// Each part of the area in which the tool fits is a problem of its own: to be covered by a robot whose centre keeps
/// half the tool's width (`inset`) from the area's boundary, so that nothing beyond it is drawn. Where that leaves
/// more than 1.5 % of the area uncovered (corners, narrow parts, or all of it), parts of the tool fill it up: 5, 3 and
/// then 1 of 7 pins, as wide as those of the source. Of a small part without room for a disc of half the tool's width
/// the boundary is driven once. What is narrower still becomes lines (thin_lines.hpp). For a robot with a least
/// turning radius the fill is cut into strokes that it can follow (smoothing/strokes.hpp), and what they leave is
/// driven piece by piece (followed_line.hpp).
/// Source: Vollprecht 2014, section 2.2. Cost: that of the planner.
#pragma once

#include "algorithms/coverage_planner.hpp"
#include "algorithms/drawing/element.hpp"
#include "algorithms/drawing/thin_lines.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {

struct FillOptions {
  std::string fill = "spiral";  // "spiral", "zigzag" or "contour", where the drawing does not say
  double line_distance = 0;     // metres between lanes; 0: the tool's width
  double inset = 0;             // metres; 0: half the tool's width
  bool outline = true;          // of zigzag fills: a lap along the boundary
  bool outline_last = false;  // the lap along the boundary is driven last, so that the robot leaves without crossing it
  bool complete = true;       // parts of the tool fill what it leaves; false: only areas in which it fits nowhere
  bool thin_lines = false;  // what is narrower than the narrowest part of the tool is drawn as a line along its middle
};

class AreaFiller {
 public:
  /// All references must outlive it.
  AreaFiller(const Problem& problem, const Planners& planners, FillOptions options)
      : problem_(problem), planners_(planners), options_(std::move(options)) {}

  /// One for each part of the area in which the tool, or a part of it, fits; none if it is narrower than a pin, or not
  /// to be filled. Throws std::invalid_argument for an unknown fill.
  std::vector<DrawingElement> elements(const FilledArea& area, const Context& context) const;

 private:
  /// Where the tool's centre may be, near the rest if there is one.
  std::vector<Polygon> parts(const FilledArea& area, double width, const Region& rest) const;
  /// `rings`: those of the area if the planner is to see nothing but the part; else nullptr.
  DrawingElement fill(const FilledArea& area, const Polygon& part, double width, const RingBoxes* rings,
                      const Context& context) const;
  /// Where the area is narrower than the narrowest part of the tool. Shorter tips only if the area is to be
  /// completed, and while the rest is too much.
  void add_thin_lines(const FilledArea& area, const ThinLines& thin, const Region& rest,
                      std::vector<DrawingElement>& elements) const;
  DrawingElement thin_element(const FilledArea& area, Polyline line) const;
  Problem problem_of(const FilledArea& area, const Polygon& part, double width, const RingBoxes* rings) const;
  /// From its first stroke to its last.
  Path planned(const FillChoice& choice, const Problem& problem, const Polygon& part, const Context& context) const;
  const std::string& name_of(const FillChoice& choice) const;
  std::unique_ptr<CoveragePlanner> planner(const FillChoice& choice) const;
  /// `width`: metres of the tool that are used.
  double inset(double width) const;
  /// A disc that keeps the inset from the area's boundary.
  Robot filling_robot(double width) const;

  const Problem& problem_;
  const Planners& planners_;
  FillOptions options_;
};

}  // namespace oxturn

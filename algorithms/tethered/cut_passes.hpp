/// Two passes along the cut of a tethered problem, one on each side, as far apart as the tool is wide.
///
///   on the cut itself        half a tool width from it
///   - - - - <- - - - - -        .- - - <- - - - -       What lies between the two passes on the right is covered
///   ~~~~~~~~~~~~~~~~~~~~  cut   ~~~~~~~~~~~~~~~~~~~~    once, and as much again outside. Both approach the cut
///   - - - - -> - - - - -        '- - - -> - - - -       towards its ends.
///
///   const CutPasses cut(problem, tether.cut());
///   const PassSpace passes = cut.beside(component);
///   Path path = planner.plan(passes.problem, context);   // drives along both sides
///   path = repaired(component, path, passes.pockets, connector, context);
#pragma once

#include <vector>

#include "geometry/ring_boxes.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// The problem with coarser_space() (outline.hpp), half of the vertices, on a lattice on which cutting it open leaves
/// them: the tether bends at the same points in both, or a path past a corner would lie on the wrong side of it.
Problem with_coarser_space(const Problem& problem);

/// The space for a planner that covers everything within half a tool width of its space.
struct PassSpace {
  Problem problem;  // its space is connected; its shortest paths are those of the component
  Region pockets;   // what such a planner leaves uncovered
};

/// A point of the cut, how far the passes are from it, and the unit vector to the one on the left.
struct CutPoint {
  Point at;
  double half_width;
  Point aside{0, 0};
};

class CutPasses {
 public:
  /// `problem` must outlive it. The lines of the cut are whole, as those of TetherSpace are.
  CutPasses(const Problem& problem, const std::vector<Polyline>& cut);

  /// `component`: the problem with a component of its cut space as configuration space, which may be coarser_space()
  /// (outline.hpp). Passes are on the cut itself
  /// where walls leave little room beside it, and where the space would otherwise become disconnected. O(k log k) for k
  /// pieces of the cut near the component, an eighth of a tool width long, and the map's vertices near by; again for
  /// what becomes disconnected, which is rare. Not safe from several threads.
  PassSpace beside(const Problem& component) const;

 private:
  std::vector<CutPoint> points_off(std::size_t line, const Point& start) const;

  const Problem& problem_;
  RingBoxes target_, space_;                           // of the problem
  std::vector<Polyline> lines_;                        // of the cut
  BoxIndex boxes_;                                     // around the lines
  std::vector<Point> junctions_;                       // where three or more end, sorted
  mutable std::vector<std::vector<CutPoint>> points_;  // of each line that has been asked for, whatever the start
};

}  // namespace oxturn

/// Lanes in the cells of a boustrophedon decomposition.
///
///   const LaneField field(problem, degrees, spacing);
///   std::vector<Strip> strips = cell_strips(field, boustrophedon_cells(field.frame.to_frame(region)), fit, context);
///
///     fitted                spaced
///      .-'|'-.               .-'-.         fitted: the fewest lanes whose slabs contain the cell (lanes.hpp); the
///     | | | | |             |  |  |        boundary is driven as well. spaced: from the cell's left end to its right
///     | | | | |             |  |  |        end, inclusive, linked along the boundary (Choset and Pignon 1997).
///      '-.|.-'               '-.-'
///
/// O(v + l log l) for a cell of v vertices and l lanes, and what clipping them to configuration space costs.
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/strips.hpp"
#include "geometry/mesh/partition.hpp"

namespace oxturn {

/// What lanes in one direction are made with.
struct LaneField {
  /// `degrees`: of the lanes; `lane_spacing` in metres.
  LaneField(const Problem& problem, double degrees, double lane_spacing)
      : LaneField(problem, problem.configuration_space(), degrees, lane_spacing) {}
  /// `near`: configuration space as it is about the cells.
  LaneField(const Problem& problem, const Region& near, double degrees, double lane_spacing)
      : frame(degrees),
        space(frame.to_frame(near)),
        spacing(lane_spacing),
        width(problem.robot().tool_width),
        margin(2 * problem.tolerance()) {}

  LaneFrame frame;
  EdgeIndex space;                           // configuration space, in the frame
  double spacing, width;                     // of lanes; of the tool
  double margin;                             // how far lane ends keep off walls
  double join() const { return 2 * width; }  // pieces of a lane this near to each other become one
};

enum class LaneFit { fitted, spaced };

/// A strip for each cell, in the order of the cells, which are given in the field's frame. Fitted lanes whose part of
/// the cell lies under lanes of wider cells are omitted, so that a strip may be empty. Ends early if cancelled.
std::vector<Strip> cell_strips(const LaneField& field, const std::vector<BoustrophedonCell>& cells, LaneFit fit,
                               Context& context);

/// The lanes of a chain of consecutive slabs in the field's frame, one list for each strip: where the chain is a
/// corridor across its slabs, one lane along it is a strip of its own (lanes/corridors.hpp).
std::vector<std::vector<LaneEnds>> strips_of_chain(const std::vector<LaneInterval>& chain, const Slabs& slabs,
                                                   const LaneField& field);

/// A lane of a frame.
inline LaneEnds upright(double x, double low, double high) { return {{x, low}, {x, high}}; }
/// The strip of straight lanes that are given in a frame.
Strip to_world(const std::vector<LaneEnds>& lanes, const LaneFrame& frame);
/// The boundary of a cell that is given in a frame, counter-clockwise, in the plane.
Ring outline(const BoustrophedonCell& cell, const LaneFrame& frame);

/// Seconds to drive from one lane to the opposite direction of the next, beside the drive there: twice a right angle,
/// and stops.
inline double turn_seconds(const Robot& robot) { return kPi / robot.turn_rate + 2 * robot.speed / robot.acceleration; }
/// Seconds from the end of a lane to the one beside it.
inline double seconds_to_next_lane(const Robot& robot) { return turn_seconds(robot) + robot.tool_width / robot.speed; }

/// y of a chain that runs from left to right, at x.
double height_on(const Polyline& chain, double x);

inline double left_of(const BoustrophedonCell& cell) { return cell.lower.front().x(); }
inline double right_of(const BoustrophedonCell& cell) { return cell.lower.back().x(); }

}  // namespace oxturn

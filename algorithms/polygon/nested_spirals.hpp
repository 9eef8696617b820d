/// One curve over the shape of a wave tree, whose laps are as many as each part needs.
///
///   const WaveSpiral s = nested_spirals(tree, {.width = w, .step = 0.95 * w}, start);
///   drive(s.spine), drive(s.laps), drive(s.boundary);
///
/// All branches of a wave tree have as many laps, so in shapes that are wide in some parts and narrow in others, those
/// of the narrow parts lie many times closer to each other than they must. With nested spirals only a few laps lead all
/// round. The first of them joins the points where the wave starts, a step or several from the boundary: along the axis
/// of narrow parts, there and back, and round the wide ones. Where it comes to one of these, the robot first drives
/// inside of it, by the same rules:
///
///   .------------------.        .---------.
///   |  .-------------.  '------'  .-----.  |     boundary, and a first lap a step inside
///   |  | .--------.  |            |     |  |
///   |  | |  o-->  |  '============'     |  |     o: the left part's own laps, outwards, before the first lap goes on
///   |  | '--------'  |            |     |  |
///   |  '-------------'  .------.  '-----'  |
///   '------------------'        '---------'
///
/// Laps do not go into dead ends that the tool covers from the boundary: those narrower than a step.
///
/// Guarantee   no point is farther than half a step from the curve, since the wave sweeps all between the first lap and
///             the boundary, and all in each wide part, whose boundary is the first lap. Wide parts without a curve
///             reach half a step inwards from the first lap at most. Where the wave waits before a dead end, half a
///             step from its walls, the last lap before is at most half a step away.
/// Complexity  O(l d k) to compare k numbers of laps over l leaves at depth d, k about 3 log(clearance / step); the
///             same again for each level of nested parts, which together have no more leaves than the whole; and the
///             output
/// Decision    The height at which the wave starts is that for which the curve is estimated to be shortest: a step or
///             several; or all of the greatest clearance, or 1.5 times that, where no part is wide: spirals then.
#pragma once

#include "algorithms/polygon/wave_tree.hpp"

namespace oxturn {

/// A spine has what is higher above the boundary than this many times the greatest clearance, at the least.
inline constexpr double kSpineHeight = 1.5;

struct LapWidths {
  double width;  // of the tool, metres
  double step;   // at most, from lap to lap
};

/// The spine has all that comes before the laps. The boundary is left to the caller. Roots the tree at its centre.
WaveSpiral nested_spirals(WaveTree& tree, const LapWidths& widths, const Point& near);
/// The same without spirals in wide parts: as many laps all round.
WaveSpiral spiral_from_spine(WaveTree& tree, const LapWidths& widths, const Point& near);

}  // namespace oxturn

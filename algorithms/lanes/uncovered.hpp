/// What a path leaves uncovered of the target.
///
///   const Region left = uncovered(problem.target(), path, problem.robot());
///
/// The target less the path's swath, which errs outside by covered_seam() at most. A curve of many short segments is
/// subtracted first as few long chords, under a tool that is narrower by what they are off, and exactly only near what
/// these leave. Where segments are many and short, only the cells of a grid that they do not certainly cover are looked
/// at (covered_cells.hpp).
/// Complexity  O(m log m) for a path of m segments
#pragma once

#include <vector>

#include "geometry/path.hpp"
#include "geometry/region.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// Seams thinner than this count as covered, metres.
inline double covered_seam(const Robot& robot) { return robot.tool_width / 250; }

/// What of the target the path leaves uncovered, each leg with its own width.
Region uncovered(const Region& target, const Path& path, const Robot& robot);

/// What lines leave of pieces, most of which lie under one segment or a few: those are found without an overlay
/// (joint_cover.hpp). Each line covers what is nearer than `radius`; the swath errs outside by `seam` at most.
/// O(p log p) for p vertices of pieces and lines, if few segments are near each piece.
Region left_of_pieces(const Region& pieces, const std::vector<Polyline>& lines, double radius, double seam);

}  // namespace oxturn

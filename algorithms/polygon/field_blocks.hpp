/// A field divided into blocks that are easy to drive, the best block first.
///
///   std::vector<FieldBlock> blocks = field_blocks(problem, space, field, {}, context);
///   for (const FieldBlock& b : blocks) strips.insert(strips.end(), b.strips.begin(), b.strips.end());
///
///     +--------------+----.        Cut along a heading at every vertex, the field falls into trapezoids; neighbours
///     | ------------ |  |  \       whose whole sides touch and whose ends run on nearly straight are merged to blocks
///     | ------------ |  |  /       with lanes along the heading. The block that covers most for its time is taken, its
///     +--------------+----'        heading refined; what remains is divided again.
///
/// Source      after Oksanen and Visala, "Coverage path planning algorithms for agricultural field machines", Journal
///             of Field Robotics 26(8), 2009: their first algorithm. The numbers are ours.
/// Complexity  a division takes O(n log n) for n vertices and a heading, of about 30; one for each 30 % of the area of
///             a component, and as many for its parts
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/polygon/cell_strips.hpp"

namespace oxturn {

struct FieldBlock {
  double degrees = 0;         // of its lanes
  Ring ring = {};             // empty: a remainder of several shapes
  double area = 0;            // square metres
  std::vector<Strip> strips;  // in driving order
};

/// What makes a block the best one: area a second, or that times its area. The rate alone prefers strips along a
/// diagonal, where lanes are longest, and leaves triangles.
enum class BlockValue { area_rate, rate };

struct BlockRule {
  BlockValue value = BlockValue::area_rate;
  double least = 100;  // area of a block in squares of the tool width; less takes slabs in the best direction
};

/// Blocks that together make up `field`, which lies in configuration space at least half a tool width from its
/// boundary; but for pieces below 1e-6 of the square of the tool width. `near`: configuration
/// space, all of it or what lies within a tool width of `field`. Ends early if cancelled.
std::vector<FieldBlock> field_blocks(const Problem& problem, const Region& near, const Region& field, BlockRule rule,
                                     Context& context);

/// The trapezoids of a region in the frame of vertical lanes, merged with their neighbours where the whole side between
/// them is equal and lower and upper ends bend by less than 20 degrees there.
std::vector<BoustrophedonCell> merged_trapezoids(const Region& region, double tool_width);

}  // namespace oxturn

/// Where a region is a corridor across its lanes, no wider than their distance: one lane along it does what many short
/// ones across would do.
///
///   const Projection projection = project(edges, slabs);
///   for (const std::vector<std::size_t>& chain : chains(projection.intervals.size(), projection.links)) ...
///   for (const ChainPart& part : corridors_in(intervals_of_the_chain, tool_width)) ...
///
///     |  |              |  |     A chain of eight slabs: lanes in the first two and the last two, and one lane along
///     |  | ------------ |  |     the corridor between them. Nothing is lost: a point of the corridor is no farther
///     |  |              |  |     than half the width from its foot on that lane, as from its foot on one across.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "algorithms/lanes/lanes.hpp"

namespace oxturn {

/// The longest chains of items in which each is the only successor of the one before, which is its only predecessor.
/// `links` are pairs (item, successor) with the lower index first. Every item is in one chain. O(n).
std::vector<std::vector<std::size_t>> chains(std::size_t count,
                                             const std::vector<std::pair<std::size_t, std::size_t>>& links);

/// Items [from, from + count) of a chain.
struct ChainPart {
  std::size_t from, count;
  bool corridor;
  double middle;  // of a corridor: halfway between its lowest and its highest y
  double height;  // between these
};
/// A chain of intervals of consecutive slabs in parts, from left to right: corridors are at least `shortest` slabs long
/// (below 3, lanes across that are driven one after the other take no more turns) and no higher than `most`.
std::vector<ChainPart> corridors_in(const std::vector<LaneInterval>& chain, double most, std::size_t shortest = 3);

}  // namespace oxturn

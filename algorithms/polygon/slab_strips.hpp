/// One set of slabs over a whole region, cut into strips: the longest runs of lanes that follow each other one to one.
///
///   std::vector<Strip> strips = slab_strips(region, degrees, tool_width, problem);
///
/// Every point of the region lies in a slab, so lanes and the boundary of configuration space together cover it
/// (lanes.hpp). O((n + k) log n) for n edges and k crossings of edges with slab lines.
#pragma once

#include <vector>

#include "algorithms/lanes/strips.hpp"

namespace oxturn {

/// Lanes in direction `degrees`, `spacing` metres apart. A part of the region that is no wider than one slab takes one
/// lane, along the others or across them.
std::vector<Strip> slab_strips(const Region& region, double degrees, double spacing, const Problem& problem);
/// The same; `near`: configuration space as it is about the region.
std::vector<Strip> slab_strips(const Region& region, double degrees, double spacing, const Problem& problem,
                               const Region& near);

}  // namespace oxturn

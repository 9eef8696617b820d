/// Spirals through the insets of a straight skeleton, as strips that a tour can order.
///
///   const SkeletonSpiralOptions options{.spacing = w, .bridge = w / 1000};
///   std::vector<Strip> strips = spiral_strips(region, options, problem, connector, context);
///
/// Each connected component of the region begins with a lap along its boundary. What laps leave uncovered at sharp
/// vertices and ridges is left to repair. Source, rules and complexity: skeleton_spiral.cpp.
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/lanes/strips.hpp"

namespace oxturn {

/// How the offset grows: with the length driven, or with each vertex.
enum class SpiralGrowth { length, vertex };

struct SkeletonSpiralOptions {
  double spacing = 1;  // metres between laps
  double bridge = 1;   // metres: width of the cuts that connect holes with the boundary
  SpiralGrowth growth = SpiralGrowth::length;
  double stirred = 0;  // metres that vertices may move, so that no two events of the skeleton have the same time
};

/// The region lies in configuration space. Traces "skeleton". Ends early if cancelled.
std::vector<Strip> spiral_strips(const Region& region, const SkeletonSpiralOptions& options, const Problem& problem,
                                 const Connector& connector, Context& context);

}  // namespace oxturn

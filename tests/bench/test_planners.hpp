// Planners that behave as badly as planners do, and a good one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "base/temporary_folder.hpp"
#include "bench/registry.hpp"

namespace oxturn::testing {

/// `good` drives lanes over a rectangle; `bad_*` are named after what they do.
Planners test_planners();
/// The test planners, and everything else that comes with oxturn.
const Registry& test_registry();
/// A copy of it.
Registry test_registry_copy();
/// The first of them, with this `how`.
std::unique_ptr<CoveragePlanner> test_planner(const Settings& settings);

/// 3 m x 2 m with its lower left corner at the origin; robot 0.2, tool 0.4, start (0.2, 0.2).
Problem small_problem();

using Folder = TemporaryFolder;

}  // namespace oxturn::testing

// The picture of every run that left a path.
#pragma once

#include <functional>
#include <string>

#include "bench/results.hpp"
#include "reports/tables/tables.hpp"

namespace oxturn {

/// Draws each run that has a path, from the results folder alone, and hands file (gallery/RUN_ID.svg) and content
/// to `write`. Throws std::invalid_argument for a path or problem file that is missing or broken.
Pictures draw_runs(const Results& results, const std::function<void(const std::string&, const std::string&)>& write);

}  // namespace oxturn

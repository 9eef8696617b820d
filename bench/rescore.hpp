/// New scores for stored paths: without planning, with the metrics of this build.
///
///   const Results results = rescore("out", built_in_registry());
#pragma once

#include <string>

#include "bench/registry.hpp"
#include "bench/results.hpp"

namespace oxturn {

/// Scores the path of every row of the folder again, on the problem that is stored beside it, and writes runs.csv,
/// columns.json, trace.csv and the pictures anew. Times of planning, run_id and the outcomes of runs without a path
/// stay as they are; the outcome and the reason of the others follow from the new score. promise_coverage of promised
/// cells stays, too: the cells are not stored. Each path is scored in a process of its own, under the limits of the
/// folder's session. Columns that this build does not have are dropped. Throws std::invalid_argument for a folder that
/// holds no results, and for a path or problem file that is missing or broken; nothing is written then.
Results rescore(const std::string& folder, const Registry& registry);

}  // namespace oxturn

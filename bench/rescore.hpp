/// New scores for stored paths: without planning, with the metrics of this build.
///
///   const Results results = rescore("out", built_in_registry());
#pragma once

#include <string>

#include "bench/registry.hpp"
#include "bench/results.hpp"

namespace oxturn {

/// Scores the path of every row of the folder again, on the problem that is stored beside it, and replaces runs.csv,
/// columns.json, trace.csv, the tethers and, if the folder has any, the pictures. Times of planning, run_id and the
/// outcomes of runs without a path stay as they are; outcome and reason of the others follow from the new score.
/// promise_coverage of promised cells stays, too: the cells are not stored. Columns that this build does not have are
/// dropped, and of several attempts at a run all but the last.
///
/// Each path is scored in a process of its own, under the limits of the folder's session. All is computed before the
/// first file is replaced (in the subfolder .rescore, which is removed), each file is replaced as a whole, and runs.csv
/// comes last. The files are those that run_id and problem_sha256 name; none outside of the folder is read or written.
///
/// `progress`: shows how far it is, and what could not be drawn, on standard error. Throws std::invalid_argument for a
/// folder that holds no results or is in use, and for a path or problem that is missing, broken or, by its hash,
/// another one; nothing is replaced then. The caller must be single-threaded.
Results rescore(const std::string& folder, const Registry& registry, bool progress = true);

}  // namespace oxturn

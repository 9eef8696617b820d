/// Results of shards, or of machines that shared a suite, as one folder; and which runs are missing.
///
///   merge({"out/1", "out/2"}, "out/all");
///   missing_runs(suite, {"out/all"});                      // cells of the suite without a row
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/registry.hpp"
#include "bench/suite.hpp"

namespace oxturn {

struct Merged {
  std::size_t runs = 0, wanted = 0;  // wanted: of the whole suite
  std::size_t duplicates = 0;        // dropped rows
};

/// Writes `folder` with the rows, figures, paths, pictures and logs of all `parts`, in the order of the suite. Of a run
/// that several parts have, the first that ended by itself is kept. Throws std::invalid_argument for parts of different
/// suites, limits or builds, for two attempts that disagree in a column that only the run determines, and if `folder`
/// holds results already. Memory: some 200 bytes for each run.
Merged merge(const std::vector<std::string>& parts, const std::string& folder);

/// A run of a suite that has no row, or only one that `run --resume` would do again.
struct MissingRun {
  std::size_t index = 0;  // in the suite's list
  std::string map, robot, variant;
  int repeat = 1;
};
/// In suite order. Throws std::invalid_argument for a folder of another suite.
std::vector<MissingRun> missing_runs(const Suite& suite, const Planners& planners,
                                     const std::vector<std::string>& folders);

}  // namespace oxturn

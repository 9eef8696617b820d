/// How the path of a run is scored, and what its score means: one outcome for every command.
///
///   const Verdict verdict = judge(score(problem, path), 0.99);      // ok, partial or invalid
#pragma once

#include <optional>
#include <string>

#include "bench/isolate.hpp"
#include "bench/results.hpp"
#include "metrics/score.hpp"

namespace oxturn {

struct Verdict {
  Outcome outcome = Outcome::ok;
  std::string reason;  // one sentence; empty if ok
};

/// The paths of a run that returned one, or that published one before it timed out, are scored; no others.
bool is_scored(const Planned& planned);

/// How the path of a run is scored. `promise`: of the planner with its settings. Cells are promised only where the run
/// handed them out. Points into `planned`.
ScoreOptions score_options(const Planned& planned, Promise promise, bool tether_counts = true);

/// A path by its score alone: ok if it is valid and certainly covers `target_coverage` of the target.
Verdict judge(const Score& score, double target_coverage);
/// A run by what became of its process and, if is_scored(), by the score of its path.
Verdict judge(const Planned& planned, const std::optional<Score>& score, double target_coverage);

}  // namespace oxturn

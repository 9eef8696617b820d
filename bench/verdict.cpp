#include "bench/verdict.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace oxturn {

bool is_scored(const Planned& planned) {
  return planned.path && (planned.outcome == Outcome::ok || planned.outcome == Outcome::timeout);
}

ScoreOptions score_options(const Planned& planned, Promise promise, bool tether_counts) {
  ScoreOptions options;
  options.tether_counts = tether_counts;
  options.promise = planned.promised ? Promise::cells : promise == Promise::target ? promise : Promise::nothing;
  if (planned.promised) options.promised = &*planned.promised;
  return options;
}

Verdict judge(const Score& score, double target_coverage) {
  if (!score.flaw.empty()) return {Outcome::invalid, score.flaw};
  const double covered = score.value("coverage_lower").value_or(0);
  if (covered >= target_coverage) return {Outcome::ok, ""};
  return {Outcome::partial, fmt::format("coverage {:.4f} is below {}", covered, to_decimal(target_coverage))};
}

Verdict judge(const Planned& planned, const std::optional<Score>& score, double target_coverage) {
  if (!score || !is_scored(planned)) return {planned.outcome, planned.reason};
  if (planned.outcome == Outcome::ok) {
    Verdict verdict = judge(*score, target_coverage);
    if (verdict.outcome != Outcome::ok && !planned.reason.empty()) verdict.reason += "; " + planned.reason;
    return verdict;
  }
  return {planned.outcome, score->flaw.empty() ? planned.reason + "; the last path it published is scored"
                                               : fmt::format("{}; the last path it published is invalid: {}",
                                                             planned.reason, score->flaw)};
}

}  // namespace oxturn

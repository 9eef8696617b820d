// The comparison table: one row a planner variant, over everything it was run on.
//
// Decisions   1. A run that gave no valid path counts as coverage 0: failing a hard map must not look better than
//                covering half of it. Runs that the harness lost (cancelled, infrastructure) count in `runs` and
//                `other` only.
//             2. Length, overlap, revisits, turns and mission time are medians over the runs with a valid path.
//             3. plan_wall_s is the median over all runs that have one, timeouts included.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/registry.hpp"
#include "reports/groups.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

std::string other_outcomes(const std::vector<const Row*>& rows) {
  std::map<Outcome, int> count;
  for (const Row* row : rows)
    if (!valid_path(*row)) ++count[row->outcome()];
  std::string out;
  for (const auto& [outcome, n] : count) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", n, to_text(outcome));
  return out;
}

std::vector<std::string> comparison_row(const RowGroup& group) {
  int ok = 0, partial = 0;
  std::vector<const Row*> valid;
  std::vector<double> coverage;
  for (const Row* row : group.rows) {
    const Outcome outcome = row->outcome();
    ok += outcome == Outcome::ok;
    partial += outcome == Outcome::partial;
    if (valid_path(*row)) valid.push_back(row);
    if (outcome == Outcome::cancelled || outcome == Outcome::infrastructure) continue;
    // An interrupted run is scored on what it had published; a path through a wall covers nothing.
    const bool counts = outcome != Outcome::invalid;
    coverage.push_back(counts ? row->number("coverage").value_or(0) : 0);
  }
  std::optional<double> least, mean;
  if (!coverage.empty()) {
    least = *std::min_element(coverage.begin(), coverage.end());
    double sum = 0;
    for (const double c : coverage) sum += c;
    mean = sum / static_cast<double>(coverage.size());
  }
  const auto mid = [&](const char* column) { return median(numbers(valid, column)); };
  return {escape_markdown(group.title),
          std::to_string(group.rows.size()),
          std::to_string(ok),
          std::to_string(partial),
          other_outcomes(group.rows),
          fixed(least, 4),
          fixed(mean, 4),
          fixed(mid("length_ratio"), 3),
          fixed(mid("overlap"), 3),
          fixed(mid("revisits"), 3),
          fixed(mid("turns"), 0),
          fixed(mid("mission_s"), 0),
          seconds(median(numbers(group.rows, "plan_wall_s")))};
}

std::string markdown(const Results& results) {
  if (results.rows.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  for (const RowGroup& group : by_variant(results)) rows.push_back(comparison_row(group));
  return markdown_table("lrrrlrrrrrrrr",
                        {"planner", "runs", "ok", "partial", "other", "coverage min", "coverage mean", "length_ratio",
                         "overlap", "revisits", "turns", "mission_s", "plan_wall_s"},
                        rows) +
         "\nA run without a valid path counts as coverage 0. Length ratio (path over the shortest conceivable), "
         "overlap, "
         "revisits, turns and mission time are medians over runs with a valid path (ok or partial); plan_wall_s is the "
         "median over all runs that were timed.\n";
}

}  // namespace

ReportTable comparison_table() { return {"comparison", "Planners compared", markdown}; }

}  // namespace oxturn

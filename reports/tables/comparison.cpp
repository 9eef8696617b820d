// The comparison table: one row a planner variant, over everything it was run on; one table for each promise.
//
// Decisions   1. Planners are compared with those that promise to cover the same: the whole target, the whole cells of
//                a lattice, or nothing. `promise kept` is the least promise_coverage of all runs.
//             2. A run that gave no valid path counts as coverage 0: failing a hard map must not look better than
//                covering half of it. Runs that the harness lost (cancelled, infrastructure) count in `runs` and
//                `other` only.
//             3. Lengths and times are compared at equal coverage: path_95_m and mission_95_s over the least of all
//                planners in the results on the same problem, the median over the runs that reached 95 %; `at 95 %`
//                says how many those are.
//             4. Overlap, revisits and turns are medians over the runs with a valid path.
//             5. Times: the median over all runs that have one, timeouts included; CPU with its 10th and 90th
//                percentile.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// One problem, whatever the planner: map, robot and repeat.
using ProblemKey = std::array<std::string, 3>;
ProblemKey problem_of(const Row& row) { return {row.get("map"), row.get("map_sha256"), row.get("robot")}; }

/// The least value of a column on each problem, over the runs with a valid path.
std::map<ProblemKey, double> least_of(const Results& results, const char* column) {
  std::map<ProblemKey, double> least;
  for (const Row& row : results.rows) {
    const auto value = valid_path(row) ? row.number(column) : std::nullopt;
    if (!value) continue;
    const auto [known, fresh] = least.emplace(problem_of(row), *value);
    if (!fresh) known->second = std::min(known->second, *value);
  }
  return least;
}

struct Best {
  std::map<ProblemKey, double> path, mission;
};

/// Values of a column over the least ones on the same problems.
std::vector<double> over_least(const std::vector<const Row*>& rows, const char* column,
                               const std::map<ProblemKey, double>& least) {
  std::vector<double> ratios;
  for (const Row* row : rows)
    if (const auto value = row->number(column); value && least.at(problem_of(*row)) > 0)
      ratios.push_back(*value / least.at(problem_of(*row)));
  return ratios;
}

/// What the planner covers, with runs that have no valid path as 0.
std::vector<double> coverages(const std::vector<const Row*>& rows) {
  std::vector<double> all;
  for (const Row* row : rows) {
    const Outcome outcome = row->outcome();
    if (is_unfinished(outcome)) continue;
    // An interrupted run is scored on what it had published; a path through a wall covers nothing.
    all.push_back(outcome == Outcome::invalid ? 0 : row->number("coverage").value_or(0));
  }
  return all;
}

std::string processor_time(const std::vector<const Row*>& rows) {
  std::vector<double> all = numbers(rows, "plan_cpu_s");
  if (all.empty()) return "";
  std::sort(all.begin(), all.end());
  const auto at = [&](double share) {
    return all[static_cast<std::size_t>(std::llround(share * static_cast<double>(all.size() - 1)))];
  };
  return fmt::format("{} ({} to {})", two_digits(median(all)), two_digits(at(0.1)), two_digits(at(0.9)));
}

std::vector<std::string> comparison_row(const RowGroup& group, const Best& best) {
  int ok = 0, partial = 0;
  std::vector<const Row*> valid, reached;
  for (const Row* row : group.rows) {
    ok += row->outcome() == Outcome::ok;
    partial += row->outcome() == Outcome::partial;
    if (!valid_path(*row)) continue;
    valid.push_back(row);
    if (row->number("path_95_m")) reached.push_back(row);
  }
  const std::vector<double> coverage = coverages(group.rows), kept = numbers(valid, "promise_coverage");
  const auto least = [](const std::vector<double>& values) {
    return values.empty() ? std::optional<double>() : *std::min_element(values.begin(), values.end());
  };
  double sum = 0;
  for (const double c : coverage) sum += c;
  const auto mid = [&](const char* column) { return two_digits(median(numbers(valid, column))); };
  return {escape_markdown(group.title),
          std::to_string(group.rows.size()),
          std::to_string(ok),
          std::to_string(partial),
          other_outcomes(group.rows),
          fixed(least(coverage), 4),
          coverage.empty() ? "" : fixed(sum / static_cast<double>(coverage.size()), 4),
          fixed(least(kept), 4),
          fmt::format("{} of {}", reached.size(), group.rows.size()),
          fixed(median(over_least(reached, "path_95_m", best.path)), 2),
          fixed(median(over_least(reached, "mission_95_s", best.mission)), 2),
          mid("overlap"),
          mid("revisits"),
          mid("turns"),
          processor_time(group.rows),
          two_digits(median(numbers(group.rows, "plan_wall_s")))};
}

constexpr std::array<std::array<const char*, 2>, 4> kPromises{
    {{"target", "Planners that promise to cover the whole target"},
     {"cells", "Planners that promise to cover their cells"},
     {"nothing", "Planners that promise nothing"},
     {"", "Planners whose promise the results do not tell"}}};

std::string markdown(const Results& results) {
  if (results.rows.empty()) return "";
  const Best best{least_of(results, "path_95_m"), least_of(results, "mission_95_s")};
  const auto groups = by_variant(results);
  std::string out;
  for (const std::string& line : results.about) out += "- " + escape_markdown(line) + "\n";
  if (!out.empty()) out += "\n";
  for (const auto& [promise, title] : kPromises) {
    std::vector<std::vector<std::string>> rows;
    for (const RowGroup& group : groups)
      if (group.rows.front()->get("promise") == promise) rows.push_back(comparison_row(group, best));
    if (rows.empty()) continue;
    out += fmt::format("### {}\n\n", title);
    out += markdown_table("lrrrlrrrrrrrrrrr",
                          {"planner", "runs", "ok", "partial", "other", "coverage min", "mean", "promise kept",
                           "at 95 %", "path", "mission", "overlap", "revisits", "turns", "CPU s", "wall s"},
                          rows) +
           "\n";
  }
  return out +
         "A run without a valid path counts as coverage 0. `promise kept`: least share covered of what is promised. "
         "`path`, `mission`: length and time until 95 % of the target were covered, over the least of all planners on "
         "the same problem; medians over the runs that got there. Overlap, revisits and turns are medians over runs "
         "with a valid path. CPU s: processor time of planning, median (10th to 90th percentile); wall s: median.\n";
}

}  // namespace

ReportTable comparison_table() { return {"comparison", "Planners compared", markdown}; }

}  // namespace oxturn

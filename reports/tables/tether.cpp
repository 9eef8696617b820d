// The tether table: one row a planner variant, over the runs whose tether could be followed.
//
// Decisions   1. Paths count whether valid or not: the table shows which paths break the tether's limit.
//             2. The median of length_ratio is over these runs too, so that it belongs to the same paths.
#include <fmt/format.h>

#include <algorithm>

#include "bench/registry.hpp"
#include "reports/groups.hpp"
#include "reports/tether_rows.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

std::vector<std::string> tether_row(const RowGroup& group) {
  std::vector<const Row*> followed;
  double within = 0, wound = 0, worst = 0, sharpest = 0;
  for (const Row* row : group.rows) {
    if (!tether_followed(*row)) continue;
    followed.push_back(row);
    const double over = over_limit(*row).value_or(0);
    within += over == 0;
    worst = std::max(worst, over);
    wound += entangled(*row).value_or(false);
    sharpest = std::max(sharpest, row->number("tether_sharp_fraction").value_or(0));
  }
  const auto n = static_cast<double>(followed.size());
  const auto share = [&](double count) { return followed.empty() ? std::nullopt : std::optional<double>(count / n); };
  const auto figure = [&](double value) { return followed.empty() ? std::nullopt : std::optional<double>(value); };
  return {escape_markdown(group.title),
          std::to_string(group.rows.size()),
          std::to_string(followed.size()),
          fixed(median(numbers(followed, "length_ratio")), 3),
          fixed(share(within), 2),
          fixed(figure(worst), 2),
          fixed(median(numbers(followed, "tether_crossings")), 0),
          fixed(share(wound), 2),
          fixed(figure(sharpest), 3)};
}

std::string markdown(const Results& results) {
  if (std::none_of(results.rows.begin(), results.rows.end(), [](const Row& row) { return tether_followed(row); }))
    return "";
  std::vector<std::vector<std::string>> rows;
  for (const RowGroup& group : by_variant(results)) rows.push_back(tether_row(group));
  return markdown_table("lrrrrrrrr",
                        {"planner", "runs", "followed", "length_ratio", "within limit", "worst over m", "crossings",
                         "entangled", "most sharp"},
                        rows) +
         "\nOver the runs whose tether could be followed along their path, valid or not. Length ratio and crossings "
         "(the "
         "robot drives over its own tether) are medians; within limit and entangled (the tether ends wound about "
         "something) are shares of these runs; worst over m is the farthest that any pulls it over its limit; most "
         "sharp "
         "is the largest share of a path that any drives against the tether's pull.\n";
}

}  // namespace

ReportTable tether_table() { return {"tether", "Tether", markdown}; }

}  // namespace oxturn

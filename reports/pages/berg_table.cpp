// docs/berg-table-4-1.md: coverage and length of Shnaps-Rimon's orders against Berg's plan, on rectangle rooms.
//
// Decisions   1. Lengths are compared on each room with `berg` in its default order, so no unit of the thesis is needed.
//             2. A path that breaks the leash is shown with its figures: it is what Berg's plan does there. The breach
//                stands beside it and is counted.
#include <fmt/format.h>

#include <algorithm>

#include "reports/groups.hpp"
#include "reports/tether_rows.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

const Row* berg_of(const RowGroup& map) {
  for (const Row* row : map.rows)
    if (row->get("planner") == "berg" && row->get("params").empty()) return row;
  return nullptr;
}

/// Of a run's length to that of berg on the same map.
std::optional<double> times_berg(const Row& row, const Row* berg) {
  const auto own = row.number("path_m"), its = berg == nullptr ? std::nullopt : berg->number("path_m");
  return own && its && *its > 0 ? std::optional<double>(*own / *its) : std::nullopt;
}

std::optional<double> percent(std::optional<double> share) {
  return share ? std::optional<double>(100 * *share) : std::nullopt;
}

std::string room_table(const RowGroup& map) {
  std::vector<std::vector<std::string>> rows;
  for (const Row* row : map.rows) {
    const auto over = over_limit(*row);
    rows.push_back({escape_markdown(row->get("variant")), to_text(row->outcome()),
                    fixed(percent(row->number("coverage")), 2), fixed(row->number("path_m"), 1),
                    fixed(times_berg(*row, berg_of(map)), 2), fixed(row->number("length_ratio"), 2),
                    over && *over > 0 ? fixed(over, 2) : "", fixed(row->number("tether_crossings"), 0),
                    row->outcome() == Outcome::ok ? "" : escape_markdown(row->get("reason"))});
  }
  return markdown_table("llrrrrrrl",
                        {"planner", "outcome", "coverage %", "path_m", "times berg", "length_ratio", "over leash m",
                         "crossings", "reason"},
                        rows);
}

std::string summary(const Results& results) {
  const auto maps = by_map(results);
  std::vector<std::vector<std::string>> rows;
  for (const RowGroup& variant : by_variant(results)) {
    std::vector<double> times, coverage;
    std::size_t breaches = 0, invalid = 0;
    for (const RowGroup& map : maps)
      for (const Row* row : map.rows) {
        if (row->get("variant") != variant.title) continue;
        if (const auto t = times_berg(*row, berg_of(map))) times.push_back(*t);
        if (const auto c = row->number("coverage")) coverage.push_back(100 * *c);
        breaches += over_limit(*row).value_or(0) > 0;
        invalid += row->outcome() == Outcome::invalid;
      }
    const auto least =
        coverage.empty() ? std::nullopt : std::optional<double>(*std::min_element(coverage.begin(), coverage.end()));
    rows.push_back({escape_markdown(variant.title), std::to_string(variant.rows.size()), fixed(median(coverage), 2),
                    fixed(least, 2), fixed(median(times), 2), fixed(median(numbers(variant.rows, "length_ratio")), 2),
                    std::to_string(breaches), std::to_string(invalid)});
  }
  return markdown_table(
      "lrrrrrrr", {"planner", "rooms", "coverage %", "least", "times berg", "length_ratio", "over leash", "invalid"},
      rows);
}

}  // namespace

std::string berg_table_page(const Results& results) {
  std::string out =
      "Berg, *A Geometric Algorithm for Online Tethered Navigation* (Lund 2021), table 4.1, one rectangle room:\n\n";
  out += markdown_table("lrrr", {"", "Shnaps and Rimon's", "Berg's", "ratio"},
                        {{"Coverage", "98 %", "94.1 %", ""}, {"Path length (no unit)", "4743.68", "380.27", "12.5"}});
  out +=
      "\nThe thesis gives neither the room's size nor the tool's width, so what is repeated is the order of coverage "
      "and "
      "the ratio of lengths, on several rooms with a tool of 0.4 m; the ratio grows with the room. `shnaps-rimon` in "
      "the "
      "order of distance is the planner that the thesis compares with; in its other order and banded it is what can be "
      "made "
      "of it. Its cells are 0.25 m, and the rooms such that they fit from wall to wall if the robot starts in the "
      "corner. "
      "Coverage is measured by the area that the tool sweeps of what the leash lets it reach; the thesis does not say "
      "how "
      "it measures. A path that pulls the leash over its limit is invalid, and shown with its figures nevertheless: "
      "the "
      "literal `berg` does not check the leash while it joins its laps. The leash is 1.1 times as long as the farthest "
      "place needs.\n\n## All rooms\n\nMedians; `least`: of coverage; `times berg`: length over that of `berg` on the "
      "same room; `over leash`: runs that pull the leash over its limit.\n\n" +
      summary(results);
  for (const RowGroup& map : by_map(results)) out += "\n## " + escape_markdown(map.title) + "\n\n" + room_table(map);
  return out;
}

}  // namespace oxturn

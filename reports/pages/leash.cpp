// docs/leash.md: ordinary planners on a tethered robot, heedless of the leash and under `leashed`, side by side.
//
// Decisions   1. The price is metres driven for each square metre swept, leashed over heedless: lengths alone do not
//                compare where the leash reaches only part of the map.
//             2. A heedless path does not depend on the leash, so it is scored once for each. What it sweeps is taken
//                from the row with the largest target: the others count only what their leash reaches.
//             3. Only runs with a length each have a price; the others stay in the table with their reason.
#include "reports/tether_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "algorithms/coverage_planner.hpp"
#include "bench/run_id.hpp"
#include "reports/groups.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

/// The value of a setting in the column `params`; "" if it is the default.
std::string setting(const Row& row, const std::string& name) {
  const std::string& all = row.get("params");
  for (std::size_t from = 0; from <= all.size();) {
    const std::size_t end = std::min(all.find(';', from), all.size());
    const std::string one = all.substr(from, end - from);
    if (one.starts_with(name + "=")) return one.substr(name.size() + 1);
    from = end + 1;
  }
  return "";
}

/// The planner that `leashed` runs in this row.
std::string inner_planner(const Row& row) {
  const std::string given = setting(row, "planner");
  if (!given.empty()) return given;
  return to_text(find_parameter("planner 'leashed'", find_planner(zoo(), "leashed").parameters, "planner").fallback);
}

std::optional<double> swept_m2(const Row& row) {
  const auto share = row.number("coverage"), target = row.number("target_m2");
  return share && target ? std::optional<double>(*share * *target) : std::nullopt;
}

/// Metres driven for each square metre that the path sweeps; `widest`: of what the longest leash reaches.
std::optional<double> rate(const Row& row, std::optional<double> widest) {
  const auto driven = row.number("path_m");
  return driven && widest && *widest > 0 ? std::optional<double>(*driven / *widest) : std::nullopt;
}

/// The largest area that any row with this very path has on this map.
std::optional<double> widest_m2(const Row& row, const Results& results) {
  std::optional<double> most = swept_m2(row);
  if (row.get("path_sha256").empty()) return most;
  for (const Row& other : results.rows)
    if (other.get("path_sha256") == row.get("path_sha256") && other.get("map_sha256") == row.get("map_sha256"))
      if (const auto area = swept_m2(other); area && (!most || *area > *most)) most = area;
  return most;
}

std::optional<double> price_of(const Row* heedless, const Row* leashed, const Results& results) {
  if (heedless == nullptr || leashed == nullptr) return std::nullopt;
  const auto with = rate(*leashed, swept_m2(*leashed)), without = rate(*heedless, widest_m2(*heedless, results));
  return with && without && *without > 0 ? std::optional<double>(*with / *without) : std::nullopt;
}

struct Pair {
  std::string planner, map, robot;
  const Row* heedless = nullptr;
  const Row* leashed = nullptr;
  std::optional<double> price;
};

/// In the order of the heedless rows; pairs without one of the two are kept.
std::vector<Pair> pairs_of(const Results& results) {
  std::vector<Pair> pairs;
  for (const RowGroup& map : by_map(results)) {
    const std::size_t first = pairs.size();
    const auto pair_for = [&](const std::string& planner) -> Pair& {
      for (std::size_t i = first; i < pairs.size(); ++i)
        if (pairs[i].planner == planner) return pairs[i];
      return pairs.emplace_back(Pair{planner, map.title, map.rows.front()->get("robot"), nullptr, nullptr, {}});
    };
    for (const Row* row : map.rows) {
      if (row->get("planner") == "leashed")
        pair_for(inner_planner(*row)).leashed = row;
      else if (setting(*row, kIgnoreTether) == "true")
        pair_for(row->get("planner")).heedless = row;
    }
  }
  for (Pair& pair : pairs) pair.price = price_of(pair.heedless, pair.leashed, results);
  return pairs;
}

std::optional<double> number(const Row* row, const char* column) {
  return row == nullptr ? std::nullopt : row->number(column);
}

std::string word(std::optional<bool> truth) { return !truth ? "" : *truth ? "yes" : "no"; }

std::string map_rows(const std::vector<const Pair*>& pairs) {
  std::vector<std::vector<std::string>> rows;
  for (const Pair* pair : pairs) {
    const Row *free = pair->heedless, *held = pair->leashed;
    const auto over = free == nullptr ? std::nullopt : over_limit(*free);
    std::string reason;
    for (const Row* row : {free, held})
      if (row != nullptr && !valid_path(*row))
        reason += fmt::format("{}{}: {}", reason.empty() ? "" : "; ", to_text(row->outcome()), row->get("reason"));
    rows.push_back({pair->planner, fixed(number(free, "path_m"), 1), fixed(number(free, "coverage"), 4), fixed(over, 2),
                    fixed(number(free, "tether_crossings"), 0), word(free == nullptr ? std::nullopt : entangled(*free)),
                    fixed(number(held, "path_m"), 1), fixed(number(held, "coverage"), 4), fixed(pair->price, 3),
                    escape_markdown(reason)});
  }
  return markdown_table("lrrrrlrrrl",
                        {"planner", "path_m", "coverage", "over leash m", "crossings", "entangled", "leashed path_m",
                         "leashed coverage", "price", "what failed"},
                        rows);
}

std::string summary(const std::vector<Pair>& pairs) {
  std::vector<std::pair<std::string, std::string>> keys;  // planner, robot; in order of appearance
  std::map<std::pair<std::string, std::string>, std::vector<const Pair*>> groups;
  for (const Pair& pair : pairs) {
    auto& group = groups[{pair.planner, pair.robot}];
    if (group.empty()) keys.emplace_back(pair.planner, pair.robot);
    group.push_back(&pair);
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& key : keys) {
    std::vector<double> prices, crossings, coverage;
    std::size_t over = 0, wound = 0, kept = 0, held = 0;
    for (const Pair* pair : groups[key]) {
      if (pair->price) prices.push_back(*pair->price);
      if (const Row* row = pair->heedless) {
        over += over_limit(*row).value_or(0) > 0;
        wound += entangled(*row).value_or(false);
        if (const auto c = row->number("tether_crossings")) crossings.push_back(*c);
      }
      if (const Row* row = pair->leashed) {
        ++held;
        kept += valid_path(*row) && over_limit(*row) == 0.0 && row->number("tether_crossings") == 0.0;
        coverage.push_back(row->number("coverage").value_or(0));
      }
    }
    const std::size_t maps = groups[key].size();
    const auto of = [](std::size_t part, std::size_t whole) { return fmt::format("{} of {}", part, whole); };
    const auto least =
        coverage.empty() ? std::nullopt : std::optional<double>(*std::min_element(coverage.begin(), coverage.end()));
    const auto dearest =
        prices.empty() ? std::nullopt : std::optional<double>(*std::max_element(prices.begin(), prices.end()));
    rows.push_back({key.first, escape_markdown(key.second), of(over, maps), fixed(median(crossings), 0),
                    of(wound, maps), of(kept, held), fixed(least, 4), fixed(median(prices), 3), fixed(dearest, 3)});
  }
  return markdown_table("llrrrrrrr",
                        {"planner", "robot", "over leash", "crossings", "entangled", "leashed: kept", "least coverage",
                         "price", "highest"},
                        rows);
}

}  // namespace

std::string leash_page(const Results& results) {
  const std::vector<Pair> pairs = pairs_of(results);
  std::string out =
      "Ordinary planners on a robot with a leash. Heedless (`ignore_tether = true`): the planner knows nothing of it "
      "and "
      "its path is scored as driven, so the leash is pulled as far as it comes. Leashed (`leashed`, `planner = NAME`): "
      "the same planner in the space cut open along the anchor's cut locus, and home again.\n\n"
      "`over leash m`: metres by which the leash is pulled over its limit. `crossings`: times the robot drives over "
      "its "
      "own line. `entangled`: whether the leash ends wound about something. `coverage`: share of what the leash lets "
      "the "
      "robot reach. `price`: metres driven for each square metre swept, leashed over heedless, way home "
      "included.\n\n## All maps\n\n`kept`: leashed runs with a valid path that stay within the leash and never cross "
      "their own line; crossings and price are medians.\n\n" +
      summary(pairs);
  for (std::size_t i = 0; i < pairs.size();) {
    std::vector<const Pair*> of_map;
    const std::string& map = pairs[i].map;
    for (; i < pairs.size() && pairs[i].map == map; ++i) of_map.push_back(&pairs[i]);
    out += "\n## " + escape_markdown(map) + "\n\n" + map_rows(of_map);
  }
  return out;
}

}  // namespace oxturn

// docs/tether-online.md: planners that see the world by lidar only, beside the same with the map in hand.
//
// Decisions   1. Pairs are rows that differ in `sensing` only. Ratios and losses are of pairs with two valid paths.
//             2. The coverage promised is that of the run with the map: `loss` is how much less there is online.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/groups.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

constexpr char kOnline[] = "sensing=lidar";

/// The settings of an online row's partner; nullopt if the row is none.
std::optional<std::string> offline_params(const std::string& params) {
  std::string rest;
  bool online = false;
  for (std::size_t from = 0; from <= params.size();) {
    const std::size_t end = std::min(params.find(';', from), params.size());
    const std::string one = params.substr(from, end - from);
    if (one == kOnline)
      online = true;
    else if (!one.empty())
      rest += (rest.empty() ? "" : ";") + one;
    from = end + 1;
  }
  return online ? std::optional(rest) : std::nullopt;
}

struct Pair {
  std::string map;
  const Row* offline = nullptr;
  const Row* online = nullptr;
  std::optional<double> ratio, loss;
};

using Pairs = std::vector<std::pair<std::string, std::vector<Pair>>>;  // by planner, in order of appearance

Pairs pairs_of(const Results& results) {
  Pairs all;
  for (const RowGroup& map : by_map(results))
    for (const Row* online : map.rows) {
      const auto params = offline_params(online->get("params"));
      if (!params) continue;
      const auto partner = std::find_if(map.rows.begin(), map.rows.end(), [&](const Row* row) {
        return row->get("planner") == online->get("planner") && row->get("params") == *params;
      });
      Pair pair{map.title, partner == map.rows.end() ? nullptr : *partner, online, {}, {}};
      if (pair.offline != nullptr && valid_path(*pair.offline) && valid_path(*online)) {
        const auto a = pair.offline->number("path_m"), b = online->number("path_m");
        if (a && b && *a > 0) pair.ratio = *b / *a;
        const auto c = pair.offline->number("coverage_lower"), d = online->number("coverage_lower");
        if (c && d) pair.loss = *c - *d;
      }
      const std::string name = online->get("planner") + (params->empty() ? "" : "(" + *params + ")");
      auto place = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == name; });
      if (place == all.end()) place = all.insert(all.end(), {name, {}});
      place->second.push_back(std::move(pair));
    }
  return all;
}

std::optional<double> greatest(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(*std::max_element(values.begin(), values.end()));
}

std::string summary(const Pairs& all) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, pairs] : all) {
    std::vector<double> ratios, losses, covered;
    std::size_t valid = 0;
    for (const Pair& pair : pairs) {
      valid += valid_path(*pair.online) ? 1 : 0;
      if (pair.ratio) ratios.push_back(*pair.ratio);
      if (pair.loss) losses.push_back(*pair.loss);
      if (const auto c = pair.online->number("coverage_lower")) covered.push_back(-*c);
    }
    auto least = greatest(covered);
    if (least) *least = -*least;
    rows.push_back({escape_markdown(name), fmt::format("{} of {}", valid, pairs.size()), fixed(least, 4),
                    fixed(median(losses), 4), fixed(greatest(losses), 4), fixed(median(ratios), 3),
                    fixed(greatest(ratios), 3)});
  }
  return markdown_table(
      "lrrrrrr", {"planner", "valid", "least coverage", "loss", "greatest loss", "times as long", "at most"}, rows);
}

std::string map_rows(const std::vector<Pair>& pairs) {
  const auto of = [](const Row* row, const char* column) {
    return row == nullptr ? std::optional<double>() : row->number(column);
  };
  std::vector<std::vector<std::string>> rows;
  for (const Pair& pair : pairs)
    rows.push_back({escape_markdown(pair.map), fixed(of(pair.offline, "coverage_lower"), 4),
                    fixed(of(pair.online, "coverage_lower"), 4), fixed(of(pair.offline, "path_m"), 1),
                    fixed(of(pair.online, "path_m"), 1), fixed(pair.ratio, 3),
                    fixed(of(pair.online, "tether_max_m"), 2), fixed(of(pair.online, "tether_limit_m"), 2),
                    escape_markdown(valid_path(*pair.online)
                                        ? ""
                                        : to_text(pair.online->outcome()) + ": " + pair.online->get("reason"))});
  return markdown_table(
      "lrrrrrrrl",
      {"map", "coverage", "by lidar", "path_m", "by lidar", "times as long", "tether_max_m", "limit", "what failed"},
      rows);
}

}  // namespace

std::string tether_online_page(const Results& results) {
  const Pairs all = pairs_of(results);
  std::string out =
      "Each planner twice: with the map in hand, and on a robot that begins knowing nothing and sees by lidar "
      "(`sensing = lidar`: survey what can be seen, go home along the string, plan on what is believed, drive that, "
      "then what came to be known since). The length by lidar includes the survey and the way home.\n\n"
      "Coverage is the lower bound, of what the leash lets the robot reach on the true map. `loss`: coverage with the "
      "map less that by lidar. `times as long`: path by lidar over path with the map.\n\n## All maps\n\nLoss and times "
      "as long are medians.\n\n" +
      summary(all);
  for (const auto& [name, pairs] : all) out += "\n## " + escape_markdown(name) + "\n\n" + map_rows(pairs);
  return out;
}

}  // namespace oxturn

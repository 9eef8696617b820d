// One table a map and robot: what each planner did, with a link to the picture.
#include <fmt/format.h>

#include <set>

#include "bench/registry.hpp"
#include "reports/groups.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

std::vector<std::string> cells_of(const Row& row, const Results& results, bool show_repeat) {
  std::string name = escape_markdown(row.get("variant"));
  if (show_repeat) name += " #" + escape_markdown(row.get("repeat"));
  if (const auto picture = results.pictures.find(row.get("run_id")); picture != results.pictures.end())
    name = fmt::format("[{}]({})", name, escape_url(picture->second));
  return {name,
          to_text(row.outcome()),
          fixed(row.number("coverage"), 4),
          fixed(row.number("path_m"), 1),
          fixed(row.number("length_ratio"), 3),
          fixed(row.number("turns"), 0),
          fixed(row.number("clearance_m"), 3),
          seconds(row.number("plan_wall_s")),
          row.outcome() == Outcome::ok ? "" : escape_markdown(row.get("reason"))};
}

std::string map_table(const RowGroup& map, const Results& results) {
  std::set<std::string> repeats;
  for (const Row* row : map.rows) repeats.insert(row->get("repeat"));
  std::vector<std::vector<std::string>> rows;
  for (const Row* row : map.rows) rows.push_back(cells_of(*row, results, repeats.size() > 1));
  return markdown_table(
      "llrrrrrrl",
      {"planner", "outcome", "coverage", "path_m", "length_ratio", "turns", "clearance_m", "plan_wall_s", "reason"},
      rows);
}

std::string markdown(const Results& results) {
  std::string out;
  for (const RowGroup& map : by_map(results))
    out += fmt::format("{}### {}\n\n{}", out.empty() ? "" : "\n", escape_markdown(map.title), map_table(map, results));
  return out;
}

}  // namespace

ReportTable map_tables() { return {"maps", "Map by map", markdown}; }

}  // namespace oxturn

// One map, all planners: what each did, with a link to the picture.
#include <fmt/format.h>

#include <set>

#include "reports/tables/tables.hpp"
#include "reports/text.hpp"

namespace oxturn {

std::string map_table(const RowGroup& map, const Pictures& pictures) {
  std::set<std::string> repeats;
  for (const Row* row : map.rows) repeats.insert(row->get("repeat"));
  std::vector<std::vector<std::string>> rows;
  for (const Row* row : map.rows) {
    std::string name = escape_markdown(row->get("variant"));
    if (repeats.size() > 1) name += " #" + escape_markdown(row->get("repeat"));
    if (const auto it = pictures.find(row->get("run_id")); it != pictures.end())
      name = fmt::format("[{}]({})", name, escape_url(it->second));
    rows.push_back({name, to_text(row->outcome()), fixed(row->number("coverage"), 4), fixed(row->number("path_m"), 1),
                    fixed(row->number("length_ratio"), 3), fixed(row->number("turns"), 0),
                    fixed(row->number("clearance_m"), 3), seconds(row->number("plan_wall_s")),
                    row->outcome() == Outcome::ok ? "" : escape_markdown(row->get("reason"))});
  }
  return markdown_table(
      "llrrrrrrl",
      {"planner", "outcome", "coverage", "path_m", "length_ratio", "turns", "clearance_m", "plan_wall_s", "reason"},
      rows);
}

}  // namespace oxturn

// The list of pages. Adding one: its file, its line twice here, its line in CMake, a suite of the same name, a test.
#include "reports/pages/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "base/parameters.hpp"
#include "base/text.hpp"

namespace oxturn {

std::string berg_table_page(const Results& results);
std::string leash_page(const Results& results);
std::string stc_loops_page(const Results& results);
std::string tether_online_page(const Results& results);

const std::vector<Page>& pages() {
  static const std::vector<Page> all{{"berg-table-4-1", "Table 4.1 of Berg's thesis again", berg_table_page},
                                     {"leash", "What a leash does, and what it costs to respect it", leash_page},
                                     {"stc-loops", "Loops round obstacles: coverage next to walls", stc_loops_page},
                                     {"tether-online", "On a leash, by lidar only", tether_online_page}};
  return all;
}

const Page& find_page(const std::string& name) {
  std::vector<std::string> names;
  for (const Page& page : pages()) {
    if (page.name == name) return page;
    names.push_back(page.name);
  }
  throw std::invalid_argument(fmt::format("no page '{}'; did you mean '{}'? There are: {}", name,
                                          nearest_name(name, names), fmt::join(names, ", ")));
}

std::string page_text(const Page& page, const Results& results) {
  for (const Row& row : results.rows)
    if (row.get("suite") != page.name)
      throw std::invalid_argument(
          fmt::format("page '{0}' is made from the results of suite '{0}', but '{1}' holds rows of suite '{2}'",
                      page.name, results.folder, row.get("suite")));
  if (results.rows.empty())
    throw std::invalid_argument(fmt::format("page '{}': there are no rows in '{}'", page.name, results.folder));
  return fmt::format("# {}\n\nMade by `scripts/pages {}` from `bench/suites/{}.toml`; not to be edited by hand.\n\n{}",
                     page.title, page.name, page.name, page.make(results));
}

}  // namespace oxturn

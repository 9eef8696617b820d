// Pages of docs/ that are made from the results of one suite each. `scripts/pages NAME` runs the suite and writes the
// page. Same results, same bytes: no times, no dates.
#pragma once

#include <string>
#include <vector>

#include "bench/results.hpp"

namespace oxturn {

struct Page {
  std::string name;  // of the file, less ".md", and of the suite
  std::string title;
  std::string (*make)(const Results&);
};
/// Listed in reports/pages/pages.cpp and nowhere else.
const std::vector<Page>& pages();
/// Throws "no page 'leashes'; did you mean 'leash'? There are: ...".
const Page& find_page(const std::string& name);

/// The whole file. Throws std::invalid_argument if the results are not of the page's suite.
std::string page_text(const Page& page, const Results& results);

}  // namespace oxturn

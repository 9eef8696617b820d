/// How `run`, `rescore` and `report` show the results of a suite.
#pragma once

#include <string>

#include "bench/registry.hpp"
#include "bench/results.hpp"

namespace oxturn::cli {

/// Writes report.md and gallery.html into `folder`; the comparison and the names of the files on standard output.
void report_results(const Results& results, const Registry& registry, const std::string& folder);

}  // namespace oxturn::cli

/// report.md and gallery.html from a results folder alone.
///
///   const Written written = write_report(read_results("out"), built_in_registry().tables, "paper");
#pragma once

#include <string>
#include <vector>

#include "bench/registry.hpp"
#include "bench/results.hpp"

namespace oxturn {

/// The report tables that come with oxturn; reports/report.cpp lists them.
ReportTables built_in_tables();

struct Written {
  std::vector<std::string> files;
};
/// Writes report.md (every table of the list that has something to show) and gallery.html, and copies the pictures if
/// `folder` is not the results folder itself. Returns the files written. Same results, same bytes. Throws
/// std::runtime_error if a file cannot be written.
Written write_report(const Results& results, const ReportTables& tables, const std::string& folder);

/// A page with a grid of pictures: rows maps, columns planner variants. No scripts, no network.
std::string gallery_page(const Results& results);

}  // namespace oxturn

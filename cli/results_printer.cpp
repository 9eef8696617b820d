#include "cli/results_printer.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "reports/report.hpp"

namespace oxturn::cli {

void report_results(const Results& results, const Registry& registry, const std::string& folder) {
  write_report(results, registry.tables, folder);
  const std::filesystem::path output = folder, source = results.folder;
  fmt::print("{}\ntable     {}\nrows      {}\npictures  {}\n", registry.tables.find("comparison").markdown(results),
             (output / "report.md").string(), (source / "runs.csv").string(), (output / "gallery.html").string());
}

}  // namespace oxturn::cli

// oxturn report: tables and pictures from a results folder.
#include "reports/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "maps/formats.hpp"
#include "reports/pages/pages.hpp"
#include "base/files.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string folder, output, page;
};

int write_page(const Options& options) {
  const Page& page = find_page(options.page);
  const std::string text = page_text(page, read_results(options.folder));
  const std::filesystem::path output = options.output.empty() ? options.folder : options.output;
  const std::string file = (output / (page.name + ".md")).string();
  require_writable(file);
  write_file(file, text);
  fmt::print("page      {}\n", file);
  return 0;
}

int report(const Options& options) {
  if (!options.page.empty()) return write_page(options);
  const Results results = read_results(options.folder);
  const std::filesystem::path output = options.output.empty() ? options.folder : options.output;
  const Written written = write_report(results, output.string());
  fmt::print("{}\ntable     {}\npictures  {} ({} files in all)\n", comparison_table(results),
             (output / "report.md").string(), (output / "gallery.html").string(), written.files.size());
  return 0;
}

std::function<int()> attach(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("DIR", options->folder, "a results folder, as `oxturn run` makes it")->required();
  app.add_option("-o,--output", options->output, "where to write; the results folder itself if not given")
      ->type_name("DIR");
  app.add_option("--page", options->page, "one page of docs/ alone (`oxturn list pages`), from its suite's results")
      ->type_name("NAME");
  return [options] { return report(*options); };
}

}  // namespace

Command report_command() {
  return {"report", "tables and pictures from a results folder",
          "  oxturn report out\n  oxturn report out -o paper\n  oxturn report out/leash --page leash -o docs\n",
          attach};
}

}  // namespace oxturn::cli

// oxturn report: tables and pictures from a results folder.
#include "reports/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/commands.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string folder, output;
};

int report(const Options& options, const Registry& registry) {
  const Results results = read_results(options.folder);
  const std::filesystem::path output = options.output.empty() ? options.folder : options.output;
  const Written written = write_report(results, registry.tables, output.string());
  fmt::print("{}\ntable     {}\npictures  {} ({} files in all)\n", registry.tables.find("comparison").markdown(results),
             (output / "report.md").string(), (output / "gallery.html").string(), written.files.size());
  return 0;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("DIR", options->folder, "a results folder, as `oxturn run` makes it")->required();
  app.add_option("-o,--output", options->output, "where to write; the results folder itself if not given")
      ->type_name("DIR");
  return [options, &registry] { return report(*options, registry); };
}

}  // namespace

Command report_command() {
  return {"report", "tables and pictures from a results folder", "  oxturn report out\n  oxturn report out -o paper\n",
          attach};
}

}  // namespace oxturn::cli

// oxturn report: tables and pictures from a results folder.
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/results_printer.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string folder, output;
};

int report(const Options& options, const Registry& registry) {
  report_results(read_results(options.folder), registry, options.output.empty() ? options.folder : options.output);
  return 0;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("DIR", options->folder, "a results folder that `oxturn run` made")->required()->type_name("");
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

// oxturn rescore: the metrics of this build for stored paths.
#include "bench/rescore.hpp"

#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/results_printer.hpp"

namespace oxturn::cli {
namespace {

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto folder = std::make_shared<std::string>();
  app.add_option("DIR", *folder, "a results folder that `oxturn run` made")->required()->type_name("");
  return [folder, &registry] {
    report_results(rescore(*folder, registry), registry, *folder);
    return 0;
  };
}

}  // namespace

Command rescore_command() {
  return {"rescore", "score the stored paths of a results folder again, without planning",
          "  oxturn rescore out\n"
          "\nRewrites runs.csv, columns.json, trace.csv, pictures and report. Measured planning times are kept.\n",
          attach};
}

}  // namespace oxturn::cli

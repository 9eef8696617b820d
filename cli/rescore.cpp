// oxturn rescore: the metrics of this build for stored paths.
#include "bench/rescore.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "reports/report.hpp"

namespace oxturn::cli {
namespace {

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto folder = std::make_shared<std::string>();
  app.add_option("DIR", *folder, "a results folder that `oxturn run` made")->required();
  return [folder, &registry] {
    const Results results = rescore(*folder, registry);
    write_report(results, registry.tables, *folder);
    fmt::print("{}\n", registry.tables.find("comparison").markdown(results));
    return 0;
  };
}

}  // namespace

Command rescore_command() {
  return {"rescore", "score the stored paths of a results folder again, without planning",
          "  oxturn rescore out\n"
          "Rewrites runs.csv, columns.json, trace.csv, pictures and report; times of planning stay.\n",
          attach};
}

}  // namespace oxturn::cli

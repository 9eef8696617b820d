// oxturn merge: results of shards as one folder, with its report.
#include "bench/merge.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/results_printer.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::vector<std::string> folders;
  std::string output;
  bool report = true;
};

int run(const Options& options, const Registry& registry) {
  const Merged merged = merge(options.folders, options.output);
  if (options.report) report_results(read_results(options.output), registry, options.output);
  if (merged.duplicates > 0) say(fmt::format("dropped {} rows of runs that are there already", merged.duplicates));
  if (merged.runs < merged.wanted)
    say(fmt::format("{} of the suite's {} runs are missing; `oxturn missing` names them", merged.wanted - merged.runs,
                    merged.wanted));
  return 0;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("DIR", options->folders, "results folders of `oxturn run --shard`")->required()->type_name("");
  app.add_option("-o,--output", options->output, "results folder to make")->required()->type_name("DIR");
  app.add_flag_callback(
      "--no-report", [options] { options->report = false; }, "only merge the files");
  return [options, &registry] { return run(*options, registry); };
}

}  // namespace

Command merge_command() {
  return {"merge", "put the results of shards together",
          "  oxturn merge out/1 out/2 out/3 -o out/all\n"
          "\nRefuses results of different suites or builds, and attempts that disagree where they must not.\n",
          attach};
}

}  // namespace oxturn::cli

// oxturn run: a whole suite into a results folder, with its report.
#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "bench/run_suite.hpp"
#include "bench/suite.hpp"
#include "cli/commands.hpp"
#include "cli/programs.hpp"
#include "cli/results_printer.hpp"
#include "cli/suites.hpp"

namespace oxturn::cli {
namespace {

constexpr std::size_t kMostShown = 10;  // runs that fall short

struct Options {
  std::string suite;
  std::vector<std::string> programs;
  SuiteRunOptions run;
  bool quiet = false, report = true;
  std::string require;  // the worst outcome for exit code 0; empty: any
};

/// As typed, for session.json.
std::vector<std::string> command_line() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) words.push_back(word);
  return words;
}

/// Says which runs fall short of what is required.
bool meets(const Results& results, const std::string& required) {
  if (required.empty()) return true;
  std::size_t count = 0;
  for (const Row& row : results.rows) {
    const Outcome outcome = row.outcome();
    if (outcome == Outcome::ok || (outcome == Outcome::partial && required == "partial")) continue;
    if (++count <= kMostShown)
      fmt::print(stderr, "oxturn: {} on {}: {}: {}\n", row.get("variant"), row.get("map"), to_text(outcome),
                 row.get("reason"));
  }
  if (count > 0)
    fmt::print(stderr, "oxturn: {} of {} runs are not {}\n", count, results.rows.size(),
               required == "ok" ? "ok" : "ok or partial");
  return count == 0;
}

int run(const Options& options, const Registry& built_in) {
  const auto [registry, programs] = with_programs(built_in, options.programs);
  Suite suite = read_suite(find_suite(options.suite), registry);
  add_unnamed(programs, suite);
  SuiteRunOptions run_options = options.run;
  run_options.progress = !options.quiet;
  run_options.command_line = command_line();
  try {
    run_suite_into_folder(suite, registry, run_options);
  } catch (const Interrupted& interrupted) {  // not done, but no bad input either
    fmt::print(stderr, "oxturn: {}\n", interrupted.what());
    return 1;
  }
  const bool report = options.report && run_options.shard == Shard{};
  if (!report) {
    fmt::print("rows      {}/runs.csv\n", run_options.folder);
    if (options.require.empty()) return 0;
  }
  const Results results = read_results(run_options.folder);
  if (report) report_results(results, registry, run_options.folder);
  return meets(results, options.require) ? 0 : 1;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("SUITE", options->suite,
                 "a suite file (- is standard input), or the name of one that comes with oxturn (`oxturn list suites`)")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options->run.folder, "results folder to make")->required()->type_name("DIR");
  app.add_option_function<std::string>(
         "--shard", [options](const std::string& text) { options->run.shard = parse_shard(text); },
         "do part K of N of the runs, without a report: one of several machines (then `oxturn merge`)")
      ->type_name("K/N");
  add_programs(app, options->programs);
  app.add_option("-j,--jobs", options->run.jobs, "runs at the same time; 1 if not given")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N");
  app.add_flag("--resume", options->run.resume, "keep the finished runs of the folder, do the missing ones");
  app.add_flag("--traces", options->run.traces,
               "keep and draw the planners' intermediate results too: cells, trees, partitions (costs planning time)");
  app.add_flag_callback(
      "--no-pictures", [options] { options->run.pictures = false; }, "draw no pictures");
  app.add_flag_callback(
      "--no-report", [options] { options->report = false; },
      "write no report, whose memory grows with the number of rows");
  app.add_option("--require", options->require, "exit with code 1 unless every run is ok, or ok or partial")
      ->check(CLI::IsMember({"ok", "partial"}).description(""))
      ->type_name("ok|partial");
  app.add_flag("-q,--quiet", options->quiet, "show no progress");
  return [options, &registry] { return run(*options, registry); };
}

}  // namespace

Command run_command() {
  return {"run", "run a suite: every planner on every map, one row each",
          "  oxturn run quick -o out\n  oxturn run my.toml -o out -j 4\n  oxturn run my.toml -o out --resume\n"
          "  oxturn run quick -o out --require ok\n"
          "  oxturn run my.toml -o out/3 --shard 3/16                 on the third of 16 machines\n"
          "  oxturn run quick -o out --exec 'python3 lanes.py'        a planner of your own beside the others\n"
          "\nExit code 0 whatever the outcomes, unless --require is given.\n",
          attach};
}

}  // namespace oxturn::cli

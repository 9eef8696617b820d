// oxturn run: a whole suite into a results folder, with its report.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "bench/run_suite.hpp"
#include "bench/suite.hpp"
#include "cli/commands.hpp"
#include "cli/suites.hpp"
#include "reports/report.hpp"

namespace oxturn::cli {
namespace {

constexpr std::size_t kMostShown = 10;  // runs that fall short

struct Options {
  std::string suite;
  SuiteRunOptions run;
  bool quiet = false;
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

int run(const Options& options, const Registry& registry) {
  const Suite suite = read_suite(find_suite(options.suite), registry);
  SuiteRunOptions run_options = options.run;
  run_options.progress = !options.quiet;
  run_options.command_line = command_line();
  Results results;
  try {
    results = run_suite(suite, registry, run_options);
  } catch (const Interrupted& interrupted) {  // not done, but no bad input either
    fmt::print(stderr, "oxturn: {}\n", interrupted.what());
    return 1;
  }
  write_report(results, registry.tables, run_options.folder);
  const std::filesystem::path folder = run_options.folder;
  fmt::print("{}\ntable     {}\nrows      {}\npictures  {}\n", registry.tables.find("comparison").markdown(results),
             (folder / "report.md").string(), (folder / "runs.csv").string(), (folder / "gallery.html").string());
  return meets(results, options.require) ? 0 : 1;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("SUITE", options->suite, "a suite's file, or the name of one that comes with oxturn")->required();
  app.add_option("-o,--output", options->run.folder, "the results folder to make")->required()->type_name("DIR");
  app.add_option("-j,--jobs", options->run.jobs, "runs at a time; 1 if not given")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--resume", options->run.resume, "keep the rows that are there, run the missing ones");
  app.add_flag("--traces", options->run.traces, "keep and draw the planners' insides too (costs them time)");
  app.add_flag("!--no-pictures", options->run.pictures, "draw no pictures");
  app.add_option("--require", options->require, "exit with code 1 unless every run is ok (or partial)")
      ->check(CLI::IsMember({"ok", "partial"}))
      ->type_name("ok|partial");
  app.add_flag("-q,--quiet", options->quiet, "no progress");
  return [options, &registry] { return run(*options, registry); };
}

}  // namespace

Command run_command() {
  return {"run", "run a suite: every planner on every map, one row each",
          "  oxturn run quick -o out\n  oxturn run my.toml -o out -j 4\n  oxturn run my.toml -o out --resume\n"
          "  oxturn run quick -o out --require ok        exit code 1 if a run is not ok\n",
          attach};
}

}  // namespace oxturn::cli

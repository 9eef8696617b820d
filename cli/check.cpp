// oxturn check: the conformance checks of planners.
#include "bench/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/colour.hpp"
#include "cli/commands.hpp"
#include "cli/programs.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::vector<std::string> planners, programs, expected;
  CheckOptions check;
  bool json = false;
};

/// In a column, so the blanks that fill it are part of the text.
std::string coloured_status(CheckStatus status) {
  const std::string text = fmt::format("{:16}", to_text(status));
  if (status == CheckStatus::skipped) return text;
  const bool passed = status == CheckStatus::passed, failed = status == CheckStatus::failed;
  return coloured(stdout, passed ? Colour::green : failed ? Colour::red : Colour::yellow, text);
}

void print_table(const std::string& planner, const std::vector<CheckResult>& results) {
  std::map<CheckStatus, int> count;
  std::size_t width = 0;
  for (const CheckResult& result : results) width = std::max(width, result.check.size());
  fmt::print("{}\n", planner);
  for (const CheckResult& result : results) {
    ++count[result.status];
    fmt::print("  {:{}}  {}  {}\n", result.check, width, coloured_status(result.status),
               result.reason.empty() ? result.title : result.reason);
  }
  fmt::print("  {} passed, {} failed, {} skipped, {} expected failures\n", count[CheckStatus::passed],
             count[CheckStatus::failed], count[CheckStatus::skipped], count[CheckStatus::expected_failure]);
}

nlohmann::ordered_json to_json(const std::string& planner, const std::vector<CheckResult>& results) {
  auto checks = nlohmann::ordered_json::array();
  for (const CheckResult& result : results)
    checks.push_back({{"check", result.check},
                      {"title", result.title},
                      {"status", to_text(result.status)},
                      {"reason", result.reason}});
  return {{"planner", planner}, {"checks", checks}};
}

/// CHECK=REASON, for each of the planners.
std::vector<ExpectedFailure> expected_failures(const std::vector<std::string>& texts,
                                               const std::vector<std::string>& planners) {
  std::vector<ExpectedFailure> all;
  for (const std::string& text : texts) {
    const auto [check, reason] = assignment("--expect", text);
    for (const std::string& planner : planners) all.push_back({planner, check, reason});
  }
  return all;
}

int check(Options options, const Registry& built_in) {
  const auto [registry, programs] = with_programs(built_in, options.programs);
  std::vector<std::string> names = options.planners;
  if (names == std::vector<std::string>{"all"}) names = built_in.planners.names();
  names.insert(names.end(), programs.begin(), programs.end());
  if (names.empty())
    throw std::invalid_argument("no planner to check; name one, or a program with --exec. See `oxturn check --help`");
  for (const std::string& name : names) registry.planners.find(name);
  options.check.expected = expected_failures(options.expected, names);
  if (const std::string& folder = options.check.problems_folder; !folder.empty()) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw std::invalid_argument(fmt::format("--problems: cannot make '{}': {}", folder, error.message()));
  }
  PlannerChecker checker(registry, options.check);
  bool failed = false;
  auto json = nlohmann::ordered_json::array();
  for (const std::string& name : names) {
    const auto results = checker.check(registry.planners.find(name));
    for (const CheckResult& result : results) failed = failed || result.status == CheckStatus::failed;
    if (options.json)
      json.push_back(to_json(name, results));
    else
      print_table(name, results);
  }
  if (options.json) fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  return failed ? 1 : 0;
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  app.add_option("PLANNER", options->planners, "planners to check (`oxturn list planners`), or all")->type_name("");
  add_programs(app, options->programs);
  app.add_option("--only", options->check.only, "a check to run, by name (may be repeated); all if not given")
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("CHECK");
  app.add_option("--expect", options->expected,
                 "a check that is known to fail, and why, CHECK=REASON (may be repeated); it fails when it passes")
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("K=V");
  app.add_option("--wall", options->check.wall_s, "time limit of each plan, seconds; 20 if not given")
      ->check(number_from(0, false, "seconds"))
      ->type_name("S");
  app.add_option("--problems", options->check.problems_folder,
                 "write the problem of each failed check, DIR/CHECK.geojson, for `oxturn plan`")
      ->type_name("DIR");
  app.add_flag("--json", options->json, "print JSON");
  return [options, &registry] { return check(*options, registry); };
}

}  // namespace

Command check_command() {
  return {"check", "check that planners keep the rules, and what they declare",
          "  oxturn check stc\n"
          "  oxturn check --exec 'python3 lanes.py' --problems failed\n"
          "  oxturn check all --only same-seed --only promise --json\n"
          "\nExit code 1 if a check failed, or an expected failure passed.\n",
          attach};
}

}  // namespace oxturn::cli

/// Planning one path, for the commands `plan` and `draw`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bench/isolate.hpp"
#include "bench/registry.hpp"
#include "cli/outputs.hpp"
#include "cli/problem_options.hpp"

namespace oxturn::cli {

struct PlanOptions {
  std::string planner, output;
  std::vector<std::string> programs;
  OutputOptions outputs;
  std::vector<std::string> settings;
  ProblemOptions problem;
  IsolationOptions isolation;
  bool json = false;
};

/// All options but those that name the planner and the map.
void add_plan_options(CLI::App& app, const Registry& registry, PlanOptions& options);
/// Plans, scores, writes and prints; returns the exit code.
int plan(PlanOptions options, const Registry& built_in);

}  // namespace oxturn::cli

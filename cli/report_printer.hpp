/// How `plan` and `score` print what came out.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/verdict.hpp"
#include "maps/problem.hpp"
#include "metrics/score.hpp"

namespace oxturn::cli {

struct Report {
  Verdict verdict;
  std::optional<Score> score;                              // if there is a path
  std::optional<double> tolerance;                         // of the score, metres; empty: the problem's own
  std::vector<std::pair<std::string, std::string>> about;  // planner, parameters, path file, ...
  std::vector<std::pair<std::string, double>> costs;       // plan_wall_s, ...
  Records records;                                         // figures that the planner recorded
  std::vector<std::string> remarks = {};                   // sentences on the path
};

/// Outcome and all figures to `out`, as an aligned table or JSON; the reason of a failure on standard
/// error. Returns the exit code: 0 for ok and partial, else 1.
int print(const Report& report, const Problem& problem, const Metrics& metrics, bool json, std::FILE* out);

}  // namespace oxturn::cli

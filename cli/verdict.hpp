// How `plan` and `score` tell what came out.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/results.hpp"
#include "maps/problem.hpp"
#include "metrics/score.hpp"

namespace oxturn::cli {

struct Verdict {
  Outcome outcome = Outcome::ok;
  std::string reason;
  std::optional<Score> score;                                        // if there is a path
  std::vector<std::pair<std::string, std::string>> about;            // planner, parameters, path file, ...
  std::vector<std::pair<std::string, std::optional<double>>> costs;  // plan_wall_s, ...
  std::vector<std::pair<std::string, double>> reports;               // what the planner says of itself
};

/// ok, partial or invalid, from the score alone.
void judge(Verdict& verdict, const Problem& problem, const Path& path);
/// Outcome and all figures on standard output, as an aligned table or JSON; the reason of a failure on standard
/// error. Returns the exit code: 0 for ok and partial, else 1.
int tell(const Verdict& verdict, const Problem& problem, bool json);

}  // namespace oxturn::cli

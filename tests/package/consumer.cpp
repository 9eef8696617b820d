// A program outside the tree that finds oxturn as a CMake package, plans and scores.
#include <cstdio>

#include "algorithms/coverage_planner.hpp"
#include "metrics/score.hpp"

int main() {
  using namespace oxturn;
  const Problem problem({"room", box_region({0, 0}, {4, 3}), "test", "test"}, Robot{});
  const Planners planners = built_in_planners();
  Context context;
  const Path path = planners.find("boustrophedon").make({}, planners)->plan(problem, context);
  const Score result = score(problem, path);
  std::printf("coverage %f %s\n", result.value("coverage").value_or(0), result.flaw.c_str());
  return result.flaw.empty() && result.value("coverage").value_or(0) > 0.99 ? 0 : 1;
}

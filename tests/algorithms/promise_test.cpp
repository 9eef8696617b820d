// Planners keep their promises: what they hand out, or the whole target, is covered.
#include <gtest/gtest.h>

#include "algorithms/coverage_planner.hpp"
#include "base/random.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Problem random_problem(Rng& rng) {
  const char* const generators[] = {"rectangle", "polygon", "clutter", "rooms", "maze", "cave"};
  const Settings size{{"width", rng.between(9.0, 13.0)}, {"height", rng.between(9.0, 13.0)}};
  Robot robot;
  robot.radius = rng.between(0.1, 0.25);
  robot.tool_width = robot.radius * rng.between(1.0, 2.2);
  return Problem(generate(std::string(generators[rng.below(6)]), size, rng.below(1000)), robot);
}

TEST(Promise, IsKept) {
  int judged = 0;
  for (const auto seed : seeds(10)) {
    Rng rng(seed);
    const Problem problem = random_problem(rng);
    for (const PlannerInfo& planner : built_in()) {
      if (planner.promise == Promise::nothing || planner.has(Capability::tether)) continue;
      SCOPED_TRACE(planner.name + " with seed " + std::to_string(seed));
      std::function<Region()> promised;
      Context::Sinks sinks;
      sinks.promise = [&](std::function<Region()> region) { promised = std::move(region); };
      Context context(seed, 1e9, sinks);
      Path path;
      try {
        path = planner.make({}, built_in())->plan(problem, context);
      } catch (const Infeasible&) { continue; }
      ASSERT_EQ(static_cast<bool>(promised), planner.promise == Promise::cells);
      const Region region = promised ? promised() : Region{};
      ScoreOptions options;
      options.promise = planner.promise;
      options.promised = &region;
      const auto kept = score(problem, path, options).value("promise_coverage");
      ASSERT_TRUE(kept);
      EXPECT_GE(*kept, 0.998);
      ++judged;
    }
  }
  EXPECT_GT(judged, 50);
}

}  // namespace
}  // namespace oxturn

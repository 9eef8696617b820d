// Planners keep their promises: what they hand out, or the whole target, is covered.
#include <gtest/gtest.h>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "base/random.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"
#include "tests/support/maps.hpp"
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

struct PromisedPlan {
  Path path;
  std::optional<Region> promised;
};
/// nullopt: infeasible.
std::optional<PromisedPlan> plan_promised(const std::string& planner, const Settings& settings, const Problem& problem,
                                          std::uint64_t seed = 1) {
  std::function<Region()> promised;
  Context::Sinks sinks;
  sinks.promise = [&](std::function<Region()> region) { promised = std::move(region); };
  Context context(seed, 1e9, sinks);
  try {
    Path path = brief_built_in().find(planner).make(settings, brief_built_in())->plan(problem, context);
    return PromisedPlan{std::move(path), promised ? std::optional(promised()) : std::nullopt};
  } catch (const Infeasible&) { return std::nullopt; }
}

std::optional<double> kept(const Problem& problem, const PromisedPlan& plan) {
  ScoreOptions options;
  options.promise = plan.promised ? Promise::cells : Promise::target;
  if (plan.promised) options.promised = &*plan.promised;
  const Score result = score(problem, plan.path, options);
  EXPECT_EQ(result.flaw, "");
  return result.value("promise_coverage");
}

TEST(Promise, IsKept) {
  int judged = 0;
  for (const auto seed : seeds(6)) {
    Rng rng(seed);
    const Problem problem = random_problem(rng);
    for (const PlannerInfo& planner : brief_built_in()) {
      if (planner.promise == Promise::nothing || planner.has(Capability::tether)) continue;
      SCOPED_TRACE(planner.name + " with seed " + std::to_string(seed));
      const auto plan = plan_promised(planner.name, {}, problem, seed);
      if (!plan) continue;
      ASSERT_EQ(plan->promised.has_value(), planner.promise == Promise::cells);
      EXPECT_GE(kept(problem, *plan).value(), 0.998);
      ++judged;
    }
  }
  EXPECT_GT(judged, 50);
}

struct Variant {
  const char* planner;
  Settings settings;
};
const std::vector<Variant>& promising_variants() {
  static const std::string start = "start", tool = "tool", none = "none";
  static const std::vector<Variant> all{
      {"stc", {{"partial", true}}},
      {"stc", {{"partial", true}, {"components", start}}},
      {"stc", {{"components", start}}},
      {"stc-spiral", {{"partial", true}}},
      {"stc-scan", {{"partial", true}}},
      {"stc-loops", {{"fill", none}, {"close_loops", false}}},
      {"stc-loops", {{"variant", std::string("published")}}},
      {"rectangles", {{"revisit_skipped", true}}},
      {"rectangles", {{"columns", tool}, {"smallest", std::int64_t{1}}}},
      {"rectangles", {{"lanes", std::string("diagonal")}}},
      {"wavefront", {{"components", start}}},
      {"bsa", {{"partial", true}}},
      {"linked-spiral", {{"partial", true}}},
  };
  return all;
}

TEST(Promise, OfVariantsIsKept) {
  int judged = 0;
  for (const auto seed : seeds(4)) {
    Rng rng(100 + seed);
    const Problem problem = random_problem(rng);
    for (const auto& [planner, settings] : promising_variants()) {
      SCOPED_TRACE(planner + (" " + to_text(settings)) + " with seed " + std::to_string(seed));
      const auto plan = plan_promised(planner, settings, problem, seed);
      if (!plan) continue;
      ASSERT_TRUE(plan->promised);
      EXPECT_GE(kept(problem, *plan).value(), 0.998);
      ++judged;
    }
  }
  EXPECT_GT(judged, 35);
}

// Cells so large that each lane has one node, and starts that see none: the tool was off until the second lane.
TEST(Promise, OfTheFirstCellIsKeptWhereItsLaneHasNoLength) {
  int judged = 0;
  for (const auto seed : seeds(60)) {
    Rng rng(300 + seed);
    const Problem drawn = random_problem(rng);
    Robot robot = drawn.robot();
    robot.tool_width = rng.between(0.5, 3.0);
    const Problem problem(drawn.map(), robot, drawn.start());
    const Settings settings{{"cell_size", rng.between(1.0, 4.0)}, {"revisit_skipped", rng.chance(0.3)}};
    SCOPED_TRACE(to_text(settings) + " with seed " + std::to_string(seed));
    const auto plan = plan_promised("rectangles", settings, problem, seed);
    if (!plan) continue;
    EXPECT_GE(kept(problem, *plan).value(), 0.998);
    ++judged;
  }
  EXPECT_GT(judged, 20);
}

// What can be counted by hand: a room of 6 x 4 cells of 1 m, a little wider than that.
TEST(Promise, IsTheCellsOfTheDescription) {
  Robot robot;
  robot.radius = 0.5;
  robot.tool_width = std::sqrt(2.0);  // cells of 1 m
  const Problem room({"room", box_region({0, 0}, {6.4, 4.01}), "test", ""}, robot, Point(0.505, 0.505));
  const auto promised = [&](const std::string& planner, const Settings& settings = {}) {
    const auto plan = plan_promised(planner, settings, room);
    return plan && plan->promised ? area(*plan->promised) : -1;
  };
  constexpr double kRounding = 24e-6;  // a lattice may shrink a little to fit
  for (const char* planner : {"stc", "stc-spiral", "stc-scan"}) {
    SCOPED_TRACE(planner);
    EXPECT_NEAR(promised(planner), 24, kRounding);
    EXPECT_NEAR(promised(planner, {{"partial", true}}), 24, kRounding);
  }
  for (const char* planner : {"wavefront", "bsa", "linked-spiral", "ba-star"})
    EXPECT_NEAR(promised(planner), 24, kRounding);
  // The lap's swath as well, 0.505 m off the walls, which is more than 0.1 m beyond the cells all around.
  EXPECT_GT(promised("stc-loops"), 24 + 2 * (6 + 4) * 0.1);
  // Lanes 0.5 m apart from x = 0.5 to 5.5 and beside the right wall, each from y = 0.5 to 3.5.
  EXPECT_NEAR(promised("rectangles", {{"variant", std::string("published")}}), 11 * 7 * 0.25, kRounding);
}

// Cells in rows, in columns, backwards, alone and round corners: one square each, whatever rows they make, and in
// whatever order they come.
TEST(Promise, SquaresInARowAreOneRectangle) {
  const Problem room({"room", box_region({0, 0}, {9, 9}), "test", ""}, Robot{}, Point(1, 1));
  const GridGraph graph = make_grid_graph(room, {.side = 0.3, .margin = 1});
  for (const auto seed : seeds(40)) {
    Rng rng(seed);
    std::vector<Cell> cells;
    std::vector<bool> taken(graph.size(), false);
    Cell at{graph.columns() / 2, graph.rows() / 2};
    for (int k = 0; k < 200; ++k) {
      const Cell next = rng.chance(0.1) ? Cell{rng.between(1, graph.columns() - 2), rng.between(1, graph.rows() - 2)}
                                        : neighbour(at, kAllDirections[rng.chance(0.8) ? seed % 4 : rng.below(4)]);
      if (!graph.inside(next.i, next.j) || taken[graph.at(next)]) continue;
      taken[graph.at(next)] = true;
      cells.push_back(at = next);
    }
    for (const double tool : {0.2, 0.5}) {
      const Region region = squares_of(graph, cells, tool);
      const double side = std::min(0.3, tool / std::sqrt(2));
      EXPECT_NEAR(area(region), static_cast<double>(cells.size()) * side * side, 1e-6);
      if (tool > 0.4) {
        EXPECT_LT(region.polygons.size(), cells.size());
        std::vector<Cell> shuffled = cells;
        rng.shuffle(shuffled);
        EXPECT_EQ(squares_of(graph, shuffled, tool).polygons.size(), region.polygons.size());
      }
      const EdgeIndex index(region);
      for (std::size_t node = 0; node < graph.size(); ++node)
        EXPECT_EQ(index.contains(graph.centre(node)), taken[node]) << node;
    }
  }
}

// The cells depend on what the lidar shows.
TEST(Promise, NothingIsPromisedByLidar) {
  Robot robot;
  robot.lidar = Lidar{.range = 10, .rays = 90};
  const Problem room({"room", box_region({0, 0}, {6, 4}), "test", ""}, robot, Point(1, 1));
  for (const PlannerInfo& planner : brief_built_in()) {
    if (planner.family != "grid" || !planner.has(Capability::online)) continue;
    SCOPED_TRACE(planner.name);
    const auto plan = plan_promised(planner.name, {{"sensing", std::string("lidar")}}, room);
    ASSERT_TRUE(plan);
    EXPECT_FALSE(plan->promised);
  }
}

}  // namespace
}  // namespace oxturn

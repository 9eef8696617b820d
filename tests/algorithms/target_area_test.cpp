// Planners on problems of which only a part is to be covered: valid, the promise kept, the rest of the map left alone.
#include <gtest/gtest.h>

#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

/// A map with a part of it to be covered, and what the part is.
struct Lawn {
  std::string what;
  Map map;
};

Map with_target(Map map, Region target) {
  map.target_area = std::move(target);
  return map;
}

/// A box in the map, by shares of the map's width and height.
Region part(const Map& map, double left, double low, double right, double high) {
  const Box box = bounding_box(map.free);
  const auto at = [&](double x, double y) -> Point { return box.low + Point(x * box.size().x(), y * box.size().y()); };
  return box_region(at(left, low), at(right, high));
}

std::vector<Lawn> lawns(std::uint64_t seed) {
  Rng rng(mix(seed, "lawns"));
  const Map flat = generate("rooms", {{"width", 10.0}, {"height", 8.0}, {"rooms", std::int64_t{6}}}, seed);
  const Map field = generate("field", {{"width", 14.0}, {"height", 10.0}, {"ponds", std::int64_t{5}}}, seed);
  const double x = rng.between(0.05, 0.5), y = rng.between(0.05, 0.5);
  return {{"a room of a flat", with_target(flat, part(flat, x, y, x + 0.35, y + 0.4))},
          {"a block of a field", with_target(field, part(field, 0.3, 0.2, 0.7, 0.6))},
          {"several blocks", with_target(field, unite({part(field, 0.2, 0.2, 0.4, 0.4), part(field, 0.6, 0.3, 0.7, 0.8),
                                                       part(field, 0.3, 0.7, 0.5, 0.75)}))},
          {"less than the tool", with_target(flat, part(flat, x, y, x + 0.04, y + 0.03))},
          {"the corner of a wall", with_target(flat, part(flat, -0.01, -0.01, 0.05, 0.06))},
          {"a polyomino", generate("polyomino", {{"squares", std::int64_t{30}}}, seed)},
          {"an octagonal polygon",
           generate("polyomino", {{"squares", std::int64_t{50}}, {"kind", std::string("octagonal")}}, seed)}};
}

/// nullopt: nothing of the target can be covered.
std::optional<Problem> problem_of(const Lawn& lawn, const Robot& robot) {
  try {
    return Problem(lawn.map, robot);
  } catch (const std::invalid_argument&) { return std::nullopt; }
}

double covered(const Problem& problem, const Path& path) {
  return coverage_of(problem.target(), 0, problem.robot().tool_width, path).lower;
}

TEST(TargetArea, PlannersThatPromiseTheTargetCoverIt) {
  std::size_t turn = 0;
  for (const auto seed : seeds(2))
    for (const Lawn& lawn : lawns(seed))
      for (const double tool : {0.4, 0.7}) {
        const auto problem = problem_of(lawn, disc(0.2, tool));
        if (!problem) continue;
        for (const PlannerInfo& planner : built_in()) {
          if (planner.promise != Promise::target || planner.has(Capability::tether)) continue;
          if (turn++ % 7 != seed) continue;  // each planner on some of them
          SCOPED_TRACE(fmt::format("{} on {}, seed {}, tool {}", planner.name, lawn.what, seed, tool));
          const Path path = plan(planner.name, *problem);
          EXPECT_EQ(score(*problem, path).flaw, "");
          EXPECT_GE(covered(*problem, path), 0.995);
          if (const auto gap = score(*problem, path).value("gap")) { EXPECT_GE(*gap, 0); }
        }
      }
}

TEST(TargetArea, OtherPlannersKeepWhatTheyPromise) {
  for (const Lawn& lawn : lawns(3)) {
    const auto problem = problem_of(lawn, disc(0.2, 0.4));
    if (!problem) continue;
    for (const PlannerInfo& planner : built_in()) {
      if (planner.promise != Promise::cells || planner.has(Capability::tether)) continue;
      SCOPED_TRACE(planner.name + " on " + lawn.what);
      std::function<Region()> promised;
      Context::Sinks sinks;
      sinks.promise = [&](std::function<Region()> region) { promised = std::move(region); };
      Context context(1, 1e9, sinks);
      try {
        const Path path = built_in_planner(planner.name)->plan(*problem, context);
        EXPECT_EQ(score(*problem, path).flaw, "");
        ASSERT_TRUE(promised);
        const Region cells = promised();
        if (!cells.empty()) { EXPECT_GE(coverage_of(cells, 0, 0.4, path).lower, 0.998); }
      } catch (const Infeasible&) {}
    }
  }
}

// A twentieth of the map takes about a twentieth of the path, and the way there.
TEST(TargetArea, TheRestOfTheMapIsLeftAlone) {
  const Map hall{"hall", box_region({0, 0}, {20, 20}), "test", ""};
  const Problem all(hall, disc(0.2, 0.4), Point(1, 1)),
      block(with_target(hall, box_region({8, 8}, {12, 13})), disc(0.2, 0.4), Point(1, 1));
  for (const PlannerInfo& planner : brief_built_in()) {
    if (planner.promise == Promise::nothing || planner.has(Capability::tether) || planner.more_parameters) continue;
    SCOPED_TRACE(planner.name);
    const auto length_on = [&](const Problem& problem) {
      Context context;
      return planner.make({}, brief_built_in())->plan(problem, context).length();
    };
    EXPECT_LT(length_on(block), 0.12 * length_on(all));
  }
}

// Two blocks on both sides of a thin wall: each is covered on its own side, and the robot drives round.
TEST(TargetArea, TheRobotDrivesOutsideOfIt) {
  const Map wall{"wall", subtract(box_region({0, 0}, {12, 8}), box_region({5.9, 2}, {6.1, 8})), "test", ""};
  const Problem p(with_target(wall, box_region({4, 4}, {8, 7})), disc(0.2, 0.4), Point(1, 7));
  const Path path = plan("boustrophedon", p);
  EXPECT_EQ(score(p, path).flaw, "");
  EXPECT_GE(covered(p, path), 0.999);
  EXPECT_LT(path.length(), 55);  // 11.4 m2 / 0.4 m, there 3 m and round the wall 6 m
}

TEST(TargetArea, OnATether) {
  Robot robot = disc(0.2, 0.4);
  robot.tether = Tether{.length = 40};
  for (const auto seed : seeds(3)) {
    SCOPED_TRACE(seed);
    const Map field = generate("field", {{"width", 14.0}, {"height", 10.0}, {"ponds", std::int64_t{5}}}, seed);
    const Problem whole(field, robot), block(with_target(field, part(field, 0.2, 0.2, 0.6, 0.7)), robot);
    for (const std::string planner : {"leashed", "berg-complete"}) {
      SCOPED_TRACE(planner);
      const Path path = plan(planner, block);
      EXPECT_EQ(score(block, path).flaw, "");
      EXPECT_GE(covered(block, path), 0.995);
    }
    EXPECT_LT(plan("leashed", block).length(), 0.6 * plan("leashed", whole).length());
  }
}

}  // namespace
}  // namespace oxturn

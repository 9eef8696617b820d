// Paths for robots with a least turning radius: valid by the scorer, whatever planner they come from.
#include "algorithms/smoothing/drivable.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "algorithms/smoothing/car_space.hpp"
#include "algorithms/smoothing/rounding.hpp"
#include "base/random.hpp"
#include "geometry/bends.hpp"
#include "geometry/overlay/boolean.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Robot tractor(double radius, bool reverse) {
  Robot robot;
  robot.name = "tractor";
  robot.radius = 1, robot.tool_width = 3, robot.min_turn_radius = radius, robot.reverse = reverse;
  return robot;
}

Problem on(const Region& free, const Robot& robot) { return Problem(Map{"plain", free, "test", "test"}, robot); }

Problem meadow(double width, double height, const Robot& robot) {
  return on(box_region({0, 0}, {width, height}), robot);
}

Path plan_on(const std::string& planner, const Settings& settings, const Problem& problem) {
  Context context;
  return brief_built_in().find(planner).make(settings, brief_built_in())->plan(problem, context);
}

TEST(Drivable, LanesKeepTheirCourseAndNothingIsTooSharp) {
  for (const bool reverse : {false, true})
    for (const double radius : {0.5, 2.0, 4.0, 6.0}) {
      SCOPED_TRACE(fmt::format("radius {}, reverse {}", radius, reverse));
      const Problem problem = meadow(70, 50, tractor(radius, reverse));
      const Score s = score(problem, plan_on("boustrophedon", {{"headland", std::int64_t{3}}}, problem));
      EXPECT_EQ(s.flaw, "");
      EXPECT_EQ(s.value("curvature_violations"), 0);
      EXPECT_GT(*s.value("coverage"), 0.95);
      if (!reverse) { EXPECT_EQ(s.value("cusps"), 0); }
    }
}

// A robot that turns on the spot gets the planner's own path.
TEST(Drivable, OthersAreLeftAlone) {
  Robot robot = tractor(4, false);
  const Problem car = meadow(40, 30, robot);
  robot.min_turn_radius = 0;
  const Problem spot = meadow(40, 30, robot);
  const Path plain = plan_on("zigzag", {}, spot), same = plan_on("zigzag", {}, car.turning_on_the_spot());
  ASSERT_EQ(plain.legs.size(), same.legs.size());
  for (std::size_t l = 0; l < plain.legs.size(); ++l) EXPECT_EQ(plain.legs[l].points, same.legs[l].points);
}

TEST(Drivable, EveryOfflinePlannerOfTheZoo) {
  const Problem problem = meadow(45, 35, tractor(2.5, true));
  for (const PlannerInfo& planner : brief_built_in()) {
    if (planner.has(Capability::online) || planner.has(Capability::tether)) continue;
    SCOPED_TRACE(planner.name);
    EXPECT_EQ(missing_capability(planner, problem), "");
    EXPECT_EQ(planner.promised({}, problem.robot()), Promise::nothing);
    const Score s = score(problem, plan_on(planner.name, {}, problem));
    EXPECT_EQ(s.flaw, "");
    EXPECT_GT(*s.value("coverage"), 0.8);
  }
}

// In a dead-end corridor narrower than a turn there is one lane forward at most.
TEST(Drivable, ADeadEndIsInfeasibleForwardAndSaysWhere) {
  const Problem forward = meadow(60, 5, tractor(4, false));
  EXPECT_THAT([&] { plan_on("boustrophedon", {}, forward); },
              ThrowsMessage<Infeasible>(HasSubstr("no drivable connection with a lane at (")));
  const Problem both = meadow(60, 5, tractor(4, true));
  const Score s = score(both, plan_on("boustrophedon", {}, both));
  EXPECT_EQ(s.flaw, "");
  EXPECT_GT(*s.value("coverage"), 0.85);
}

TEST(Drivable, TwiceAsLargeIsTheSamePathTwiceAsLong) {
  const auto length_of = [](double scale) {
    Robot robot = tractor(4 * scale, false);
    robot.radius *= scale, robot.tool_width *= scale, robot.speed *= scale, robot.acceleration *= scale;
    const Problem problem = meadow(64 * scale, 48 * scale, robot);
    return plan_on("boustrophedon", {{"headland", std::int64_t{3}}}, problem).length();
  };
  EXPECT_NEAR(length_of(2), 2 * length_of(1), 1e-3 * length_of(2));
}

TEST(Rounding, ArcsOfTheRadiusBetweenTangents) {
  const Problem problem = meadow(100, 100, tractor(4, false));
  const CarSpace space(problem);
  const std::vector<Polyline> runs = rounded_runs({{10, 10}, {50, 10}, {50, 60}}, space);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(length(runs[0]), 36 + 46 + 4 * kPi / 2, 0.01);
  for (const Point& p : runs[0])
    EXPECT_TRUE(p.y() == 10 || p.x() == 50 || std::abs(distance(p, {46, 14}) - 4) < 1e-9) << to_text(p);
}

TEST(Rounding, CutsWhereItCannotTurn) {
  const Problem problem = meadow(100, 100, tractor(4, false));
  const CarSpace space(problem);
  EXPECT_EQ(rounded_runs({{10, 10}, {50, 10}, {10, 12}}, space).size(), 2u);                      // there and back
  EXPECT_EQ(rounded_runs({{10, 10}, {50, 10}, {50, 13}, {10, 13}}, space).size(), 3u);            // lanes too near
  EXPECT_EQ(rounded_runs({{10, 10}, {50, 10}, {50, 50}, {10, 50}, {10, 10}}, space).size(), 1u);  // a lap
}

// Corners cut in many small steps with too small a radius become one arc.
TEST(Rounding, ArcsTooTightBecomeWider) {
  const Problem problem = meadow(100, 100, tractor(4, false));
  const CarSpace space(problem);
  Polyline line{{10, 10}};
  for (int k = 0; k <= 20; ++k) {
    const double a = k * kPi / 40;
    line.push_back({50 + std::sin(a), 11 - std::cos(a)});
  }
  line.push_back({51, 60});
  EXPECT_EQ(rounded_runs(line, space).size(), 1u);
}

// Gentle bends between edges of any length: what is kept of them is not sharper than the radius, arcs beside it or not.
TEST(Rounding, GentleBendsKeepTheRadius) {
  const Robot robot = tractor(4, false);
  const Problem problem = meadow(400, 400, robot);
  const CarSpace space(problem);
  Rng rng(2);
  for (int i = 0; i < 3000; ++i) {
    Polyline line{{200, 200}};
    double heading = rng.between(-kPi, kPi);
    for (int k = 0; k < 30; ++k) {
      line.push_back(ahead({line.back(), heading}, std::exp(rng.between(-3.0, 1.5))).at);
      heading += rng.chance(0.1) ? rng.between(-1.5, 1.5) : rng.between(-0.07, 0.07);
    }
    for (const Polyline& run : rounded_runs(line, space)) {
      const Path path{{{true, run}}};
      for (const Bend& bend : bends(path, problem.tolerance(), robot.tool_width))
        ASSERT_FALSE(too_sharp(bend, 4)) << i << ": " << to_text(bend.at) << " radius " << 1 / bend.curvature;
    }
  }
}

// A wall with a gap at one end stands between the poses, so no simple link is free.
Problem walled(bool reverse) {
  return on(subtract(box_region({0, 0}, {60, 40}), box_region({29, 0}, {31, 30})), tractor(3, reverse));
}
const Pose kBeforeWall{{20, 5}, 0}, kBehindWall{{40, 5}, 0};
const Pose kOutOfTheWall{{28, 10}, kPi};  // forwards it cannot be reached

TEST(OmplSearch, FindsAFreeDetourAndTheSameOneAgain) {
  for (const bool reverse : {false, true}) {
    const Problem problem = walled(reverse);
    const CarSpace space(problem, DetourSearch::ompl);
    ASSERT_FALSE(space.simple_link(kBeforeWall, kBehindWall));
    std::optional<double> length;
    for (int again = 0; again < 3; ++again) {
      Context context(5);
      DetourEffort effort;
      const auto detour = space.detour({kBeforeWall}, kBehindWall, effort, context);
      ASSERT_TRUE(detour) << reverse;
      EXPECT_TRUE(space.free(*detour));
      EXPECT_EQ(length.value_or(detour->length()), detour->length()) << "same seed, same path";
      length = detour->length();
      Pose at = detour->from;
      for (const CurvePiece& piece : detour->pieces) {
        at = after(at, piece, detour->radius);
        EXPECT_TRUE(reverse || piece.gear == Gear::forward);
      }
      EXPECT_LT(distance(at.at, kBehindWall.at), 1e-4);
      EXPECT_LT(std::abs(std::remainder(at.heading - kBehindWall.heading, 2 * kPi)), 1e-4);
    }
    EXPECT_LT(*length, 130) << "the path round is some 80 m";
  }
}

// OMPL waits for another goal where it takes the only one for invalid: on the boundary but for rounding, or in a wall.
TEST(OmplSearch, DoesNotWaitForAnotherGoal) {
  for (const bool reverse : {false, true}) {
    const Problem problem = walled(reverse);
    const CarSpace space(problem, DetourSearch::ompl);
    Context context(5);
    DetourEffort effort;
    EXPECT_FALSE(space.detour({kBeforeWall}, {{30, 10}, 0}, effort, context));
    EXPECT_EQ(effort.most(), DetourEffort::kMost);
    EXPECT_TRUE(space.detour({kBeforeWall}, {{59 + 1e-12, 20}, kPi / 2}, effort, context));
  }
}

TEST(OmplSearch, GivesUpWhereThereIsNoPath) {
  const Problem problem = walled(false);
  const CarSpace space(problem, DetourSearch::ompl);
  Context context;
  DetourEffort effort;
  EXPECT_FALSE(space.detour({kBeforeWall}, kOutOfTheWall, effort, context));
}

// So that a map full of links that do not exist takes seconds.
TEST(DetourEffort, IsSharedAndEachSearchStillHasAFew) {
  DetourEffort effort;
  EXPECT_EQ(effort.most(), DetourEffort::kMost);
  effort.spend(DetourEffort::kAll - 5000);
  EXPECT_EQ(effort.most(), 5000u);
  effort.spend(10000);
  EXPECT_EQ(effort.most(), DetourEffort::kLeast);
  const Problem problem = walled(false);
  for (const DetourSearch search : {DetourSearch::lattice, DetourSearch::ompl}) {
    const CarSpace space(problem, search);
    Context context(5);
    DetourEffort fresh;
    space.detour({kBeforeWall}, kOutOfTheWall, fresh, context);
    fresh.spend(DetourEffort::kAll - DetourEffort::kMost);
    EXPECT_EQ(fresh.most(), DetourEffort::kLeast) << "the search has spent its share";
  }
}

TEST(Drivable, PublishesWhatCanBeDrivenSoFar) {
  const Problem problem = meadow(45, 30, tractor(2.5, false));
  std::vector<Path> published;
  Context::Sinks sinks;
  sinks.publish = [&](const Path& path) { published.push_back(path); };
  Context context(1, 1e9, std::move(sinks));
  const auto planner = brief_built_in().find("boustrophedon").make({{"headland", std::int64_t{1}}}, brief_built_in());
  const Path path = planner->plan(problem, context);
  ASSERT_GT(published.size(), 1u);
  double work = 0;
  for (const Path& p : published) {
    EXPECT_EQ(score(problem, p).flaw, "");
    EXPECT_GT(p.length(true), work);
    work = p.length(true);
  }
  EXPECT_GE(path.length(true), 0.9 * work);
}

// Whoever runs out of time while links are searched drives what is behind the last one found, too; and if the tour has
// another order by then, of which less is known, what could be driven in the one before.
TEST(Drivable, DrivesMoreThanHalfAndAllThatWasPublishedWhenCancelled) {
  Robot car;
  car.radius = 0.2, car.tool_width = 0.4, car.min_turn_radius = 0.4, car.reverse = true;
  const auto planner = brief_built_in().find("boustrophedon").make({}, brief_built_in());
  for (const auto& [seed, start] : {std::pair(1, Point(1.5, 8.37)), std::pair(2, Point(12, 1.28))})
    for (const int last : {1, 9}) {
      const Map rooms = generate("rooms", {{"width", 14.0}, {"height", 10.0}}, static_cast<std::uint64_t>(seed));
      const Problem problem(rooms, car, start);
      Context::Sinks sinks;
      Context* running = nullptr;
      int count = 0;
      double published = 0;
      sinks.publish = [&](const Path& path) {
        published = std::max(published, path.length(true));
        if (++count == last) running->cancel();
      };
      Context context(1, 1e9, std::move(sinks));
      running = &context;
      const Path path = planner->plan(problem, context);
      const Score s = score(problem, path);
      EXPECT_EQ(s.flaw, "");
      EXPECT_GT(*s.value("coverage"), 0.5) << last;
      EXPECT_GE(path.length(true), published) << last;
    }
}

TEST(Drivable, DetoursByOmpl) {
  const Problem problem = walled(false);
  const Settings settings{{"headland", std::int64_t{2}}, {"detour", std::string("ompl")}};
  const Score s = score(problem, plan_on("boustrophedon", settings, problem));
  EXPECT_EQ(s.flaw, "");
  EXPECT_EQ(s.value("curvature_violations"), 0);
  EXPECT_GT(*s.value("coverage"), 0.85);
  EXPECT_THAT(
      [&] {
        plan_on("boustrophedon", {{"detour", std::string("none")}}, problem);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("one of: lattice, ompl")));
}

// The parameter is that of the planner within.
TEST(Drivable, APlannerThatRunsAnotherOneTakesTheParameterToo) {
  const Problem problem = meadow(45, 35, tractor(2.5, true));
  EXPECT_GT(plan_on("completed", {{"detour", std::string("ompl")}}, problem).length(), 0);
  std::size_t named = 0;
  for (const ParameterInfo& p : parameters_of(built_in().find("completed"), {}, built_in()))
    named += p.name == "detour";
  EXPECT_EQ(named, 1u);
}

}  // namespace
}  // namespace oxturn

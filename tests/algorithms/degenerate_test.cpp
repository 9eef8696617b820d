// Every built-in planner on degenerate maps: a valid path or a clear refusal, never a crash. Planners that guarantee to
// cover the whole target do so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/coverage_planner.hpp"
#include "geometry/overlay/boolean.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"

namespace oxturn {
namespace {

struct Case {
  std::string name;
  Region free;
  Robot robot;
  std::optional<Point> start;
};

Region with_hole(Region region, Ring hole) {
  region.polygons.front().holes.push_back(std::move(hole));
  return region;
}

Robot sized(double scale) {
  Robot robot;
  robot.radius = 0.2 * scale;
  robot.tool_width = 0.4 * scale;
  return robot;
}

Region many_collinear() {
  Ring ring;
  const auto side = [&](const Point& a, const Point& b) {
    for (int k = 0; k < 2500; ++k) ring.push_back(lerp(a, b, k / 2500.0));
  };
  side({0, 0}, {5, 0});
  side({5, 0}, {5, 4});
  side({5, 4}, {0, 4});
  side({0, 4}, {0, 0});
  return {{{ring, {}}}};
}

// Two rooms and a door of the given width between them.
Region rooms_with_door(double width) {
  return unite(
      {box_region({0, 0}, {3, 4}), box_region({3.2, 0}, {6, 4}), box_region({3, 2 - width / 2}, {3.2, 2 + width / 2})});
}

std::vector<Case> cases() {
  const Region room = box_region({0, 0}, {5, 4});
  return {
      {"the robot just fits", box_region({0, 0}, {0.41, 0.41}), sized(1), {}},
      {"one tool wide", box_region({0, 0}, {0.5, 6}), sized(1), {}},
      {"corridor a thousandth wider than the robot", box_region({0, 0}, {6, 0.402}), sized(1), {}},
      {"side no multiple of the tool", box_region({0, 0}, {3.33, 2.77}), sized(1), {}},
      {"door exactly as wide as the robot", rooms_with_door(0.4), sized(1), Point(1, 1)},
      {"door a billionth wider than the robot", rooms_with_door(0.4 * (1 + 1e-9)), sized(1), Point(1, 1)},
      {"door wide enough", rooms_with_door(0.45), sized(1), Point(1, 1)},
      {"pillar thinner than the tool", with_hole(room, {{2, 2}, {2, 2.05}, {2.05, 2.05}, {2.05, 2}}), sized(1), {}},
      {"hole that touches the wall in a point", with_hole(room, {{0, 2}, {1, 2.5}, {1, 1.5}}), sized(1), {}},
      {"hole that shares a wall", with_hole(room, {{0, 1}, {0, 2}, {1, 2}, {1, 1}}), sized(1), {}},
      {"two holes that touch",
       with_hole(with_hole(room, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}), {{2, 2}, {2, 3}, {3, 3}, {3, 2}}),
       sized(1),
       {}},
      {"spike in the wall", {{{{{0, 0}, {5, 0}, {5, 2}, {7, 2}, {5, 2}, {5, 4}, {0, 4}}, {}}}}, sized(1), {}},
      {"ten thousand collinear vertices", many_collinear(), sized(1), {}},
      {"a million metres off", transformed(room, 0.3, {1e6, -1e6}), sized(1), {}},
      {"a millimetre large", box_region({0, 0}, {5e-3, 4e-3}), sized(1e-3), {}},
      {"disconnected free space", unite({room, box_region({7, 0}, {9, 4})}), sized(1), Point(1, 1)},
      {"tool narrower than the robot",
       room,
       [] {
         Robot r = sized(1);
         r.tool_width = 0.25;
         return r;
       }(),
       {}},
      {"tool far narrower than the robot",
       box_region({0, 0}, {0.5, 0.5}),
       [] {
         Robot r = sized(1);
         r.tool_width = 0.0015;
         return r;
       }(),
       {}},
      {"tool wider than the robot",
       room,
       [] {
         Robot r = sized(1);
         r.tool_width = 0.7;
         return r;
       }(),
       {}},
      {"robot without extent",
       room,
       [] {
         Robot r = sized(1);
         r.radius = 0;
         return r;
       }(),
       {}},
  };
}

class Degenerate : public testing::TestWithParam<std::size_t> {};

TEST_P(Degenerate, ValidPathOrClearRefusal) {
  const Case c = cases()[GetParam()];
  const Problem problem({c.name, c.free, "test", "test"}, c.robot, c.start);
  for (const PlannerInfo& planner : brief_built_in()) {
    if (planner.has(Capability::tether)) continue;
    for (const Settings& settings :
         {Settings{}, planner.name == "boustrophedon" ? Settings{{"cells", std::string("exact")}} : Settings{}}) {
      SCOPED_TRACE(fmt::format("{} on '{}'", planner.name, c.name));
      const bool guarantees_all = planner.name == "boustrophedon" || planner.name == "zigzag";
      Context context(1);
      Path path;
      try {
        path = planner.make(settings, brief_built_in())->plan(problem, context);
      } catch (const Infeasible& refusal) {
        EXPECT_FALSE(guarantees_all) << refusal.what();
        continue;
      }
      const Score result = score(problem, path);
      EXPECT_EQ(result.flaw, "");
      EXPECT_GE(result.value("length_ratio").value_or(1), 1);
      if (guarantees_all) { EXPECT_GE(result.value("coverage_lower").value_or(0), 0.99); }
    }
  }
}

TEST_P(Degenerate, WithATetherAsWell) {
  const Case c = cases()[GetParam()];
  for (const double reach : {1.2, 0.6}) {
    Robot robot = c.robot;
    robot.tether = Tether{0, reach};
    const Problem problem({c.name, c.free, "test", "test"}, robot, c.start);
    for (const PlannerInfo& planner : brief_built_in()) {
      if (!planner.has(Capability::tether)) continue;
      SCOPED_TRACE(fmt::format("{} on '{}', reach {}", planner.name, c.name, reach));
      const bool guarantees_all = planner.name == "leashed" || planner.name == "berg-complete";
      Context context(1);
      Path path;
      try {
        path = planner.make({}, brief_built_in())->plan(problem, context);
      } catch (const Infeasible& refusal) {
        EXPECT_FALSE(guarantees_all) << refusal.what();
        continue;
      }
      const Score result = score(problem, path);
      EXPECT_EQ(result.flaw, "");
      if (guarantees_all) { EXPECT_GE(result.value("coverage_upper").value_or(0), 0.99); }
    }
  }
}

// A million metres square, or a robot of a tenth of a millimetre in a room: no path covers that, and none is begun.
TEST(TooLarge, IsRefusedBeforeWorkBegins) {
  for (const auto& [free, scale] :
       {std::pair(box_region({0, 0}, {1e6, 1e6}), 1.0),
        std::pair(unite({box_region({0, 0}, {9, 9}), box_region({9, 3}, {18, 5})}), 5e-4)}) {
    const Problem problem({"too large", free, "test", "test"}, sized(scale));
    for (const PlannerInfo& planner : brief_built_in()) {
      if (planner.has(Capability::tether) || planner.name == "beachbot") continue;
      SCOPED_TRACE(planner.name);
      Context context(1, 30);
      std::string refusal;
      try {
        (void)planner.make({}, brief_built_in())->plan(problem, context);
      } catch (const Infeasible& e) { refusal = e.what(); } catch (const std::invalid_argument& e) {
        refusal = e.what();
      }
      EXPECT_TRUE(refusal.find("more than") != std::string::npos || refusal.find("at most") != std::string::npos)
          << refusal;
      EXPECT_GT(context.seconds_left(), 15);
    }
  }
}

// The remedies that the refusal names.
TEST(TooLarge, AWiderToolCoversTheLargeMap) {
  const Problem problem({"large", box_region({0, 0}, {1e6, 1e6}), "test", "test"}, sized(1e5));
  Context context(1);
  const Path path = brief_built_in().find("boustrophedon").make({}, brief_built_in())->plan(problem, context);
  EXPECT_GE(score(problem, path).value("coverage_lower").value_or(0), 0.99);
}

INSTANTIATE_TEST_SUITE_P(Set, Degenerate, testing::Range(std::size_t{0}, cases().size()));

}  // namespace
}  // namespace oxturn

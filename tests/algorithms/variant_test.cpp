// `variant = published` stands for the settings that a planner's description calls published.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/coverage_planner.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

namespace oxturn {
namespace {

std::vector<Polyline> points_of(const Path& path) {
  std::vector<Polyline> all;
  for (const Leg& leg : path.legs) all.push_back(leg.points);
  return all;
}

TEST(Variant, PublishedEqualsTheExplicitSettings) {
  for (const PlannerInfo& planner : built_in()) {
    if (planner.published.empty()) continue;
    SCOPED_TRACE(planner.name);
    Robot robot;
    if (planner.name == "rectangles") robot.tool_width = 0.6;  // its cells follow a tool wider than the robot
    if (planner.has(Capability::tether)) robot.tether = Tether{0, 1.1};
    Map map = generate("clutter", {{"width", 6.0}, {"height", 5.0}}, 2);
    map.free = transformed(map.free, 0.3, {0, 0});  // the published form of linked-spiral turns with the walls
    const Problem problem(map, robot);
    const auto path = [&](const Settings& settings) {
      return points_of(plan_recorded(planner.name, problem, settings).path);
    };
    EXPECT_EQ(path({{"variant", std::string("published")}}), path(planner.published));
    EXPECT_EQ(path({{"variant", std::string("improved")}}), path({}));
    EXPECT_NE(path(planner.published), path({})) << "the default is the published form already";
  }
}

TEST(Variant, GivenSettingsTakePrecedence) {
  const Settings settings =
      with_variant(built_in().find("stc"), {{"variant", std::string("published")}, {"components", std::string("all")}});
  EXPECT_EQ(settings.at("components"), Value(std::string("all")));
}

TEST(Variant, PlannersWithoutAPublishedFormHaveNoSuchParameter) {
  EXPECT_THAT(
      [] {
        built_in_planner("smart-dfs", {{"variant", std::string("published")}});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("unknown parameter 'variant'")));
}

// A published form that leaves out the outline does not promise what the default does.
TEST(Variant, PromisesDependOnTheSettings) {
  const auto promised = [](const char* planner, const Settings& settings) {
    return built_in().find(planner).promised(settings);
  };
  const Settings no_outline{{"outline", false}}, published{{"variant", std::string("published")}};
  for (const char* planner : {"boustrophedon", "zigzag", "hyun"}) {
    EXPECT_EQ(promised(planner, {}), Promise::target);
    EXPECT_EQ(promised(planner, no_outline), Promise::nothing);
    EXPECT_EQ(promised(planner, published), Promise::nothing);
  }
  EXPECT_EQ(promised("bsa", {{"partial", true}}), Promise::cells);
  EXPECT_EQ(promised("leashed", {{"planner", std::string("boustrophedon")}}), Promise::nothing);
}

}  // namespace
}  // namespace oxturn

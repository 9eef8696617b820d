// The parameter `variant` of planners with a published form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/coverage_planner.hpp"
#include "maps/generators.hpp"
#include "maps/path_file.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

namespace oxturn {
namespace {

TEST(Variant, PublishedIsTheSettingsThatItStandsFor) {
  int planners = 0;
  for (const PlannerInfo& planner : built_in()) {
    if (planner.published.empty()) continue;
    ++planners;
    for (const char* generator : {"clutter", "polygon"}) {
      SCOPED_TRACE(fmt::format("{} on {}", planner.name, generator));
      Robot robot;
      if (planner.has(Capability::tether)) robot.tether.emplace().reach = 1.1;
      const Problem problem(generate(generator, {{"width", 9.0}, {"height", 7.0}}, 2), robot);
      const auto path = [&](const Settings& settings) {
        Context context(3);
        return to_geojson(planner.make(settings, built_in())->plan(problem, context));
      };
      EXPECT_EQ(path({{"variant", std::string("published")}}), path(planner.published));
      EXPECT_EQ(path({{"variant", std::string("improved")}}), path({}));
    }
  }
  EXPECT_GE(planners, 5);
}

// A setting that is given beside the variant stays.
TEST(Variant, GivenSettingsComeFirst) {
  const Problem problem(generate("clutter", {{"width", 9.0}, {"height", 7.0}}, 2), Robot{});
  const auto path = [&](const Settings& settings) {
    Context context(3);
    return to_geojson(built_in_planner("boustrophedon", settings)->plan(problem, context));
  };
  Settings expected = built_in().find("boustrophedon").published, given{{"variant", std::string("published")}};
  expected["order"] = given["order"] = std::string("nearest");
  EXPECT_EQ(path(given), path(expected));
}

}  // namespace
}  // namespace oxturn

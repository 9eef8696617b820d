// What docs/add-a-planner.md, add-a-metric.md and add-a-map.md tell a newcomer to write works as written.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "base/files.hpp"
#include "bench/run_suite.hpp"
#include "reports/built_in_registry.hpp"
#include "tests/support/files.hpp"

namespace oxturn {

PlannerInfo onion();
extern const Metric kTransitShare;
namespace generator {
GeneratorInfo cross();
}

namespace {

using testing::HasSubstr;

TEST(Docs, TheCodeOfThePagesRunsAndIsScored) {
  Registry registry = built_in_registry();
  registry.planners.add(onion());
  registry.metrics.add(kTransitShare);
  registry.generators.add(generator::cross());
  Suite suite;
  suite.name = "docs";
  suite.robots.push_back(Robot{});
  for (const char* map : {"cross", "rooms"}) {
    MapSpec spec;
    spec.generator = map;
    suite.maps.push_back(spec);
  }
  suite.planners = {{"onion", {}}, {"onion", {{"spacing", 0.5}}}};
  const TemporaryFolder folder;
  SuiteRunOptions options;
  options.folder = folder.file("out");
  options.progress = false;
  const Results results = run_suite(suite, registry, options);
  ASSERT_EQ(results.rows.size(), 4u);
  for (const Row& row : results.rows) {
    SCOPED_TRACE(row.get("variant") + " on " + row.get("map"));
    EXPECT_THAT(row.get("outcome"), testing::AnyOf("ok", "partial")) << row.get("reason");
    EXPECT_GT(row.number("coverage").value_or(0), 0.9);
    EXPECT_LT(row.number("transit_share").value_or(1), 0.5);
  }
}

// README.md names planners one by one and counts the generators.
TEST(Readme, KnowsThePlannersAndCountsTheGenerators) {
  std::string text = read_file(OXTURN_SOURCE_DIR "/README.md");
  std::ranges::replace(text, '\n', ' ');
  const Registry registry = built_in_registry();
  for (const PlannerInfo& planner : registry.planners) EXPECT_THAT(text, HasSubstr("`" + planner.name + "`"));
  const std::array words{"twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen"};
  const std::size_t count = registry.generators.size();
  EXPECT_THAT(text, HasSubstr(std::string(words.at(count - 12)) + " seeded generators"));
}

}  // namespace
}  // namespace oxturn

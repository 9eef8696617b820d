#include "bench/suite.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.hpp"
#include "bench/run_id.hpp"
#include "maps/generators.hpp"
#include "maps/path_file.hpp"
#include "reports/built_in_registry.hpp"
#include "test_planners.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

namespace oxturn {
namespace {

/// All that a suite means, as text.
std::string described(const Suite& suite) {
  std::string text =
      fmt::format("{} seed {} repeats {} target {} wall {} cpu {} memory {}\n", suite.name, suite.seed, suite.repeats,
                  suite.target_coverage, suite.limits.wall_s, suite.limits.cpu_s, suite.limits.memory_mb);
  for (const Robot& robot : suite.robots) text += fmt::format("robot {} {}\n", robot.name, canonical_text(robot));
  for (const MapSpec& m : suite.maps) {
    text += fmt::format("map {} {} {} {} {}", m.name, m.generator, to_text(m.settings), m.seed, m.file);
    if (m.start) text += " start " + to_text(*m.start);
    if (m.anchor) text += " anchor " + to_text(*m.anchor);
    text += '\n';
  }
  for (const PlannerSpec& p : suite.planners) text += fmt::format("planner {}\n", p.variant());
  return text;
}

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kHead = "schema = 1\nname = \"t\"\n";
constexpr const char* kRobot = "[robots.disc]\nradius = 0.2\ntool_width = 0.4\n";
constexpr const char* kMap = "[[maps]]\ngenerator = \"rectangle\"\nwidth = 3\nheight = 2\n";
constexpr const char* kPlanner = "[[planners]]\nname = \"test\"\n";

/// The test planners, and one that plans for its tether.
const Registry& registry_with_tied() {
  static const Registry all = [] {
    Registry registry = testing::test_registry_copy();
    PlannerInfo tied = registry.planners.find("test");
    tied.name = "tied";
    tied.capabilities = {Capability::tether};
    registry.planners.add(tied);
    return registry;
  }();
  return all;
}

Suite suite_of(const std::string& text, const Registry& registry = testing::test_registry()) {
  const testing::Folder folder;
  write_file(folder.file("t.toml"), text);
  return read_suite(folder.file("t.toml"), registry);
}

std::string sentence_of(const std::string& text, const Registry& registry = testing::test_registry()) {
  try {
    suite_of(text, registry);
  } catch (const std::invalid_argument& e) {
    const std::string what = e.what();
    return what.substr(what.find("t.toml"));
  }
  return "accepted";
}

std::vector<std::string> map_names(const Suite& suite) {
  std::vector<std::string> names;
  for (const MapSpec& m : suite.maps) names.push_back(m.name);
  return names;
}
std::vector<std::string> variants(const Suite& suite) {
  std::vector<std::string> names;
  for (const PlannerSpec& p : suite.planners) names.push_back(p.variant());
  return names;
}

TEST(Suite, DefaultsAndValues) {
  const Suite plain = suite_of(fmt::format("{}{}{}{}", kHead, kRobot, kMap, kPlanner));
  EXPECT_EQ(plain.name, "t");
  EXPECT_EQ(plain.seed, 1u);
  EXPECT_EQ(plain.repeats, 1);
  EXPECT_EQ(plain.target_coverage, 0.99);
  EXPECT_TRUE(plain.scoring);
  EXPECT_EQ(plain.limits.wall_s, 60);
  const Suite full =
      suite_of(fmt::format("{}seed = 9\nrepeats = 3\ntarget_coverage = 0.5\nscoring = false\n[limits]\nwall_s = 2.5\n"
                           "memory_mb = 100\n{}speed = 1\ntether = {{ length = 4.0 }}\n{}{}",
                           kHead, kRobot, kMap, kPlanner));
  EXPECT_EQ(full.seed, 9u);
  EXPECT_EQ(full.repeats, 3);
  EXPECT_EQ(full.target_coverage, 0.5);
  EXPECT_FALSE(full.scoring);
  EXPECT_EQ(full.limits.wall_s, 2.5);
  EXPECT_EQ(full.limits.memory_mb, 100);
  ASSERT_EQ(full.robots.size(), 1u);
  EXPECT_EQ(full.robots[0].speed, 1);
  ASSERT_TRUE(full.robots[0].tether);
  EXPECT_EQ(full.robots[0].tether->length, 4);
}

TEST(Suite, ListsMultiplyInFileOrder) {
  const Suite suite =
      suite_of(fmt::format("{}[robots.r]\nradius = [0.1, 0.2]\n"
                           "[[maps]]\ngenerator = \"rectangle\"\nwidth = [3, 4]\nheight = [2, 1.5]\n"
                           "seeds = [1, 2]\n"
                           "[[planners]]\nname = \"test\"\nhow = [\"b\", \"a\"]\namount = [0, 1]\n",
                           kHead));
  EXPECT_THAT(map_names(suite), ElementsAre("rectangle-1[height=2;width=3]", "rectangle-2[height=2;width=3]",
                                            "rectangle-1[height=1.5;width=3]", "rectangle-2[height=1.5;width=3]",
                                            "rectangle-1[height=2;width=4]", "rectangle-2[height=2;width=4]",
                                            "rectangle-1[height=1.5;width=4]", "rectangle-2[height=1.5;width=4]"));
  // A value equal to the default is no setting.
  EXPECT_THAT(variants(suite),
              ElementsAre("test[how=b]", "test[amount=1;how=b]", "test[how=a]", "test[amount=1;how=a]"));
  ASSERT_EQ(suite.robots.size(), 2u);
  EXPECT_EQ(suite.robots[0].name, "r[radius=0.1]");
  EXPECT_EQ(suite.robots[1].radius, 0.2);
}

TEST(Suite, FootprintsAreNamedOrListed) {
  const std::string rest = std::string(kMap) + kPlanner;
  const Suite named =
      suite_of(fmt::format("{}[robots.r]\nfootprint = [\"octagon:1\", \"square:0.5\"]\n{}", kHead, rest));
  ASSERT_EQ(named.robots.size(), 2u);
  EXPECT_EQ(named.robots[0].name, "r[footprint=octagon:1]");
  EXPECT_EQ(named.robots[1].footprint, parse_footprint("square:0.5"));
  const Suite listed = suite_of(fmt::format("{}[robots.r]\nfootprint = [[1, 0], [0, 1], [-1, -1.5]]\n{}", kHead, rest));
  ASSERT_EQ(listed.robots.size(), 1u);
  EXPECT_EQ(listed.robots[0].name, "r");
  EXPECT_EQ(listed.robots[0].footprint, (Ring{{1, 0}, {0, 1}, {-1, -1.5}}));
  EXPECT_NE(described(named), described(listed));
}

TEST(Suite, TheStarNamesThoseNotNamed) {
  const std::string start = fmt::format("{}{}{}", kHead, kRobot, kMap);
  EXPECT_THAT(variants(suite_of(start + "[[planners]]\nname = \"*\"\n")), ElementsAre("test", "other"));
  EXPECT_THAT(variants(suite_of(start + kPlanner + "[[planners]]\nname = \"*\"\n")), ElementsAre("test", "other"));
  EXPECT_THAT(variants(suite_of(start + "[[planners]]\nname = \"*\"\nhow = \"x\"\n")),
              ElementsAre("test[how=x]", "other[how=x]"));
  EXPECT_THAT(sentence_of(start + "[[planners]]\nname = \"*\"\nlanes = 2\n"),
              AllOf(StartsWith("t.toml:12: "), HasSubstr("unknown parameter 'lanes' of planner 'test'")));
}

TEST(Suite, FilesByPattern) {
  const testing::Folder folder;
  MapFile map;
  map.map.name = "kitchen";
  map.map.free = box_region({0, 0}, {3, 2});
  for (const char* name : {"b.geojson", "a.geojson"}) write_file(folder.file(name), to_geojson(map));
  const auto read = [&](const std::string& maps) {
    write_file(folder.file("t.toml"), fmt::format("{}{}{}{}", kHead, kRobot, maps, kPlanner));
    return read_suite(folder.file("t.toml"), testing::test_registry());
  };
  const Suite suite = read("[[maps]]\nfile = \"*.geojson\"\nstart = [1, 0.5]\n");
  EXPECT_THAT(map_names(suite), ElementsAre("a", "b"));
  ASSERT_TRUE(suite.maps[0].start);
  EXPECT_EQ(suite.maps[0].start->point, Point(1, 0.5));
  ASSERT_TRUE(suite.maps[0].content);
  EXPECT_THAT([&] { read("[[maps]]\nfile = \"*.png\"\n"); },
              ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("t.toml:7: no file matches '*.png'")));
  write_file(folder.file("c.geojson"), "{");
  EXPECT_THAT([&] { read("[[maps]]\nfile = \"c.*\"\n"); },
              ::testing::ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("t.toml:7: "), HasSubstr("c.geojson"))));
}

TEST(Suite, TethersByLengthOrReach) {
  const auto robots = [](const std::string& lines) {
    return suite_of(fmt::format("{}[robots.r]\n{}\n{}{}", kHead, lines, kMap, kPlanner)).robots;
  };
  const auto reach = robots("tether = { reach = [0.6, 1.1], sharp_angle = 2.0 }");
  ASSERT_EQ(reach.size(), 2u);
  EXPECT_EQ(reach[0].name, "r[tether_reach=0.6]");
  EXPECT_EQ(reach[1].tether->reach, 1.1);
  EXPECT_EQ(reach[1].tether->length, 0);
  EXPECT_EQ(reach[1].tether->sharp_angle, 2);
  const auto length = robots("tether.length = 7");
  EXPECT_EQ(length[0].tether->length, 7);
  EXPECT_EQ(length[0].tether->reach, 0);
  EXPECT_EQ(length[0].tether->sharp_angle, Tether{}.sharp_angle);
}

TEST(Suite, StartsAndAnchorsByNameOrPosition) {
  const auto maps = [](const std::string& lines) {
    return suite_of(fmt::format("{}{}{}{}{}", kHead, kRobot, kMap, lines, kPlanner)).maps;
  };
  const auto one = maps("anchor = \"wall\"\n");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].name, "rectangle-1");
  EXPECT_FALSE(one[0].start);
  EXPECT_EQ(one[0].anchor->name, "wall");
  const Suite many =
      suite_of(fmt::format("{}{}{}start = [\"middle\", [1, 0.5]]\nanchor = [\"start\", \"corner\", [0.25, 2]]\n{}",
                           kHead, kRobot, kMap, kPlanner));
  EXPECT_THAT(map_names(many),
              ElementsAre("rectangle-1[anchor=start;start=middle]", "rectangle-1[anchor=corner;start=middle]",
                          "rectangle-1[anchor=0.25 2;start=middle]", "rectangle-1[anchor=start;start=1 0.5]",
                          "rectangle-1[anchor=corner;start=1 0.5]", "rectangle-1[anchor=0.25 2;start=1 0.5]"));
  EXPECT_EQ(many.maps[5].anchor->point, Point(0.25, 2));
  EXPECT_EQ(maps("anchor = [1, 2]\n").size(), 1u);
}

TEST(Suite, IgnoredTethersAreVariants) {
  const std::string start = fmt::format("{}{}{}", kHead, kRobot, kMap);
  const auto read = [&](const std::string& lines) {
    return suite_of(start + "[[planners]]\n" + lines, registry_with_tied());
  };
  const Suite both = read("name = \"test\"\nhow = \"x\"\nignore_tether = [true, false]\n");
  EXPECT_THAT(variants(both), ElementsAre("test[how=x;ignore_tether=true]", "test[how=x]"));
  EXPECT_TRUE(both.planners[0].ignore_tether);
  EXPECT_FALSE(both.planners[0].settings.contains("ignore_tether"));
  // Those that mind it run as always, once.
  EXPECT_THAT(variants(read("name = \"*\"\nignore_tether = [true, false]\n")),
              ElementsAre("test[ignore_tether=true]", "test", "other[ignore_tether=true]", "other", "tied"));
  EXPECT_THAT(variants(read("name = \"tied\"\nignore_tether = false\n")), ElementsAre("tied"));
  EXPECT_NE(described(read("name = \"test\"\nignore_tether = true\n")), described(read("name = \"test\"\n")));
  EXPECT_THAT(sentence_of(start + "[[planners]]\nname = \"tied\"\nignore_tether = true\n", registry_with_tied()),
              StartsWith("t.toml:11: planner 'tied' plans for the tether"));
  EXPECT_THAT(sentence_of(start + "[[planners]]\nname = \"test\"\nignore_tether = 1\n"),
              StartsWith("t.toml:12: ignore_tether is not true or false"));
}

TEST(Suite, RunsThatIgnoreTheTetherHaveNamesOfTheirOwn) {
  const PlannerInfo& planner = testing::test_registry().planners.find("test");
  Settings settings = full_settings(planner, {}, testing::test_registry().planners);
  const std::string plain = run_id("m", "r", "p", planner.name, settings, 7, 1, "b");
  settings[kIgnoreTether] = true;
  EXPECT_NE(run_id("m", "r", "p", planner.name, settings, 7, 1, "b"), plain);
  EXPECT_NE(run_id("m", "r", "p", planner.name, settings, 7, 1, "another build"), plain);
}

// Every kind of mistake: one sentence, with the line. Long because it is a table.
TEST(Suite, MistakesAreOneSentenceWithTheirLine) {
  const std::string start = fmt::format("{}{}{}", kHead, kRobot, kMap);  // 9 lines
  struct Mistake {
    std::string text, line, says;
  };
  const std::vector<Mistake> mistakes{
      {"schema = 1\nname = \"t\n", "t.toml:2: ", "bad TOML"},
      {"name = \"t\"\n", "t.toml:", "the suite has no 'schema'"},
      {"schema = 2\n", "t.toml:1: ", "schema is not 1"},
      {"schema = 1\nname = 7\n", "t.toml:2: ", "name is 7, expected a text"},
      {std::string(kHead) + "planers = 3\n",
       "t.toml:3: ", "unknown key 'planers' in the suite; expected: schema, name, seed"},
      {std::string(kHead) + "repeats = 0\n", "t.toml:3: ", "repeats is 0, expected a whole number"},
      {std::string(kHead) + "seed = \"x\"\n", "t.toml:3: ", "seed is the text \"x\", expected a whole number"},
      {std::string(kHead) + "target_coverage = nan\n", "t.toml:3: ", "expected a number from 0 to 1"},
      {std::string(kHead) + "scoring = 1\n", "t.toml:3: ", "scoring is 1, expected true or false"},
      {std::string(kHead) + "[limits]\nwall = 3\n",
       "t.toml:4: ", "unknown key 'wall' in [limits]; expected: wall_s, cpu_s, memory_mb"},
      {std::string(kHead) + "[limits]\nwall_s = -1\n", "t.toml:4: ", "wall_s is -1"},
      {std::string(kHead) + kMap + kPlanner, "t.toml:", "no [robots.NAME] table"},
      {std::string(kHead) + "[robots.r]\ntool_width = 0\n", "t.toml:4: ", "parameter 'tool_width' of robot 'r' is 0"},
      {std::string(kHead) + "[robots.r]\nwidth = 0\n", "t.toml:4: ", "unknown parameter 'width' of robot 'r'"},
      {std::string(kHead) + "[robots.r]\nradius = \"thin\"\n",
       "t.toml:4: ", "parameter 'radius' of robot 'r' is 'thin'"},
      {std::string(kHead) + "[robots.r]\nradius = 1\nfootprint = \"square:1\"\n",
       "t.toml:3: ", "a radius and a footprint, expected one of the two"},
      {std::string(kHead) + "[robots.r]\nfootprint = \"star:1\"\n", "t.toml:3: ", "footprint is 'star:1'"},
      {std::string(kHead) + "[robots.r]\nfootprint = [[1, 0], [0]]\n", "t.toml:4: ", "not a point [x, y]"},
      {std::string(kHead) + "[robots.r]\nfootprint = [[1, 0], [0, 1]]\n", "t.toml:3: ", "has 2 vertices"},
      {std::string(kHead) + "[robots.r]\nfootprint = \"square:1\"\ntether = { length = 3 }\n",
       "t.toml:3: ", "a tether needs a round robot"},
      {std::string(kHead) + "[robots.r]\ntether = { reach = 1, length = 2 }\n", "t.toml:3: ", "a length and a reach"},
      {std::string(kHead) + "[robots.r]\ntether = { reach = -1 }\n",
       "t.toml:4: ", "parameter 'tether_reach' of robot 'r' is -1"},
      {std::string(kHead) + "[robots.r]\ntether = { sharp_angle = 1 }\n", "t.toml:3: ", "tether has no length"},
      {std::string(kHead) + "[robots.r]\ntether = { long = 1 }\n", "t.toml:4: ", "unknown parameter 'tether_long'"},
      {std::string(kHead) + kRobot + kMap + "start = \"midle\"\n", "t.toml:10: ", "one of: middle, corner"},
      {std::string(kHead) + kRobot + kMap + "anchor = [\"wall\", [1]]\n",
       "t.toml:10: ", "anchor is neither [x, y] in metres nor one of \"start\", \"wall\", \"corner\""},
      {std::string(kHead) + kRobot + kMap + "anchor = []\n", "t.toml:10: ", "empty list"},
      {std::string(kHead) + kRobot + kPlanner, "t.toml:", "no [[maps]]"},
      {std::string(kHead) + kRobot + "[[maps]]\nseeds = [1]\n", "t.toml:6: ", "either 'generator' or 'file'"},
      {std::string(kHead) + kRobot + "[[maps]]\ngenerator = \"rectangel\"\n", "t.toml:7: ", "did you mean 'rectangle'"},
      {std::string(kHead) + kRobot + "[[maps]]\ngenerator = \"rectangle\"\nwidht = 3\n",
       "t.toml:8: ", "unknown parameter 'widht'"},
      {std::string(kHead) + kRobot + "[[maps]]\ngenerator = \"rectangle\"\nwidth = \"big\"\n", "t.toml:8: ", "width"},
      {std::string(kHead) + kRobot + "[[maps]]\ngenerator = \"rectangle\"\nwidth = [3, [4]]\n", "t.toml:8: ", "width"},
      {std::string(kHead) + kRobot + "[[maps]]\ngenerator = \"rectangle\"\nwidth = []\n", "t.toml:8: ", "empty list"},
      {std::string(kHead) + kRobot + "[[maps]]\ngenerator = \"rectangle\"\nseeds = [1, 1]\n" + kPlanner,
       "t.toml:", "listed twice"},
      {std::string(kHead) + kRobot + "[[maps]]\ngenerator = \"rectangle\"\nseeds = [-1]\n", "t.toml:8: ", "seeds"},
      {start, "t.toml:", "no [[planners]]"},
      {start + "[[planners]]\nname = \"tset\"\n", "t.toml:11: ", "did you mean 'test'"},
      {start + "[[planners]]\nhow = \"x\"\n", "t.toml:10: ", "has no 'name'"},
      {start + "[[planners]]\nname = \"test\"\nhwo = \"x\"\n",
       "t.toml:12: ", "unknown parameter 'hwo' of planner 'test'"},
      {start + "[[planners]]\nname = \"test\"\namount = 11\n", "t.toml:12: ", "amount"},
      {start + kPlanner + kPlanner, "t.toml:12: ", "planner variant 'test' is listed twice"}};
  for (const Mistake& m : mistakes) {
    const std::string sentence = sentence_of(m.text);
    EXPECT_THAT(sentence, AllOf(StartsWith(m.line), HasSubstr(m.says))) << m.text;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
  EXPECT_THAT([] { read_suite("/nowhere/t.toml", testing::test_registry()); },
              ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("no such file: '/nowhere/t.toml'")));
}

TEST(Suite, ReadsTheMeaningNotTheLooks) {
  const std::string a = fmt::format("{}{}{}{}", kHead, kRobot, kMap, kPlanner);
  EXPECT_EQ(described(suite_of(a)), described(suite_of("# a comment\n" + a)));
  EXPECT_NE(described(suite_of(a)), described(suite_of(a + "how = \"x\"\n")));
}

TEST(Suite, KeepsLocationsAndTethersApart) {
  const std::string maps = fmt::format("{}{}{}{}", kHead, kRobot, kMap, kPlanner);
  std::set<std::string> hashes{described(suite_of(maps))};
  const std::vector<std::string> robots{"tether.length = 4\n", "tether.reach = 4\n",
                                        "tether = { length = 4, sharp_angle = 1.0 }\n"};
  for (const std::string& line : robots)
    hashes.insert(described(suite_of(fmt::format("{}{}{}{}{}", kHead, kRobot, line, kMap, kPlanner))));
  for (const std::string line :
       {"anchor = \"start\"\n", "anchor = \"wall\"\n", "anchor = [1, 1]\n", "start = [1, 1]\n"})
    hashes.insert(described(suite_of(fmt::format("{}{}{}{}{}", kHead, kRobot, kMap, line, kPlanner))));
  EXPECT_EQ(hashes.size(), 8u);
}

const Registry& shipped_registry() {
  static const Registry registry = built_in_registry();
  return registry;
}

TEST(Suite, QuickIsWellFormed) {
  const Suite quick = read_suite(std::string(OXTURN_SOURCE_DIR) + "/bench/suites/quick.toml", shipped_registry());
  std::set<std::string> families;
  for (const MapSpec& m : quick.maps) families.insert(m.generator);
  EXPECT_EQ(families.size(), 9u);
  // Every planner except those for tethered robots, which are in `tether`, vacuum habits, which are in `grid`, the one
  // for drawings, and those that improve a path for seconds, which are in `lawn`.
  std::set<std::string> wanted, listed;
  for (const PlannerInfo& p : built_in())
    if (!p.has(Capability::tether) && p.family != "baseline" && p.family != "drawing") wanted.insert(p.name);
  for (const char* slow : {"shortest", "polished"}) EXPECT_EQ(wanted.erase(slow), 1u);
  for (const PlannerSpec& p : quick.planners) listed.insert(p.name);
  EXPECT_EQ(listed, wanted);
}

Suite shipped(const std::string& name) {
  return read_suite(std::string(OXTURN_SOURCE_DIR) + "/bench/suites/" + name + ".toml", shipped_registry());
}

TEST(Suite, AllThatComeWithOxturnAreWellFormed) {
  std::size_t suites = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(OXTURN_SOURCE_DIR) + "/bench/suites")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    ++suites;
    EXPECT_EQ(shipped(entry.path().stem().string()).name, entry.path().stem().string());
  }
  EXPECT_GE(suites, 4u);
}

TEST(Suite, TetherHasEveryFamilyAndEveryTetheredPlanner) {
  const Suite tether = shipped("tether");
  std::set<std::string> families, planners, anchors;
  for (const MapSpec& m : tether.maps) {
    families.insert(m.generator);
    ASSERT_TRUE(m.anchor);
    anchors.insert(m.anchor->name);
  }
  for (const PlannerSpec& p : tether.planners) planners.insert(p.name);
  // Three are made for one planner each, that knows nothing of tethers.
  const std::set<std::string> for_one{"hyun", "divided-corridor", "pillars", "speckle"};
  const std::string lawns = "polyomino";  // tests/algorithms/target_area_test.cpp covers them on a tether
  for (const GeneratorInfo& g : built_in_maps())
    EXPECT_TRUE(families.contains(g.name) || for_one.contains(g.name) || g.name == lawns) << g.name;
  for (const PlannerInfo& p : built_in())
    if (p.has(Capability::tether)) { EXPECT_TRUE(planners.contains(p.name)) << p.name; }
  EXPECT_TRUE(anchors.contains("start") && anchors.contains("wall"));
}

// The page docs/leashed.md is about the tether suite's maps.
TEST(Suite, LeashedHasTheRobotsAndMapsOfTether) {
  Suite leashed = shipped("leashed"), tether = shipped("tether");
  for (Suite* suite : {&leashed, &tether}) {
    suite->name = "";
    suite->planners.clear();
  }
  EXPECT_EQ(described(leashed), described(tether));
}

// And so is docs/tether-online.md, but its robots have a lidar besides.
TEST(Suite, TetherOnlineHasTheMapsAndTethersOfTether) {
  Suite online = shipped("tether-online"), tether = shipped("tether");
  for (Suite* suite : {&online, &tether}) {
    suite->name = "";
    suite->planners.clear();
    for (auto& robot : suite->robots) robot.lidar.reset();
  }
  EXPECT_EQ(described(online), described(tether));
}

}  // namespace
}  // namespace oxturn

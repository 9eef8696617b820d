#include "bench/suite.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_planners.hpp"

namespace oxturn {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kHead = "schema = 1\nname = \"t\"\n";
constexpr const char* kRobot = "[robots.disc]\nradius = 0.2\ntool_width = 0.4\n";
constexpr const char* kMap = "[[maps]]\ngenerator = \"rectangle\"\nwidth = 3\nheight = 2\n";
constexpr const char* kPlanner = "[[planners]]\nname = \"test\"\n";

Suite suite_of(const std::string& text) {
  const testing::Folder folder;
  write_file(folder.file("t.toml"), text);
  return read_suite(folder.file("t.toml"), testing::test_planners());
}

std::string sentence_of(const std::string& text) {
  try {
    suite_of(text);
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
  EXPECT_EQ(plain.limits.wall_s, 60);
  const Suite full =
      suite_of(fmt::format("{}seed = 9\nrepeats = 3\ntarget_coverage = 0.5\n[limits]\nwall_s = 2.5\n"
                           "memory_mb = 100\n{}speed = 1\ntether = {{ length = 4.0 }}\n{}{}",
                           kHead, kRobot, kMap, kPlanner));
  EXPECT_EQ(full.seed, 9u);
  EXPECT_EQ(full.repeats, 3);
  EXPECT_EQ(full.target_coverage, 0.5);
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
    return read_suite(folder.file("t.toml"), testing::test_planners());
  };
  const Suite suite = read("[[maps]]\nfile = \"*.geojson\"\nstart = [1, 0.5]\n");
  EXPECT_THAT(map_names(suite), ElementsAre("a", "b"));
  ASSERT_TRUE(suite.maps[0].start);
  EXPECT_EQ(suite.maps[0].start->y(), 0.5);
  ASSERT_TRUE(suite.maps[0].content);
  EXPECT_THAT([&] { read("[[maps]]\nfile = \"*.png\"\n"); },
              ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("t.toml:7: no file matches '*.png'")));
  write_file(folder.file("c.geojson"), "{");
  EXPECT_THAT([&] { read("[[maps]]\nfile = \"c.*\"\n"); },
              ::testing::ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("t.toml:7: "), HasSubstr("c.geojson"))));
}

// Every kind of mistake: one sentence, with the line.
TEST(Suite, MistakesAreOneSentenceWithTheirLine) {
  const std::string start = fmt::format("{}{}{}", kHead, kRobot, kMap);  // 9 lines
  struct Mistake {
    std::string text, place, says;
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
      {std::string(kHead) + "[limits]\nwall = 3\n",
       "t.toml:4: ", "unknown key 'wall' in [limits]; expected: wall_s, memory_mb"},
      {std::string(kHead) + "[limits]\nwall_s = -1\n", "t.toml:4: ", "wall_s is -1"},
      {std::string(kHead) + kMap + kPlanner, "t.toml:", "no [robots.NAME] table"},
      {std::string(kHead) + "[robots.r]\ntool_width = 0\n", "t.toml:3: ", "tool_width is 0"},
      {std::string(kHead) + "[robots.r]\nwidth = 0\n", "t.toml:4: ", "unknown key 'width' in robot 'r'"},
      {std::string(kHead) + "[robots.r]\nradius = \"thin\"\n", "t.toml:4: ", "radius is not a number"},
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
    EXPECT_THAT(sentence, AllOf(StartsWith(m.place), HasSubstr(m.says))) << m.text;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
  EXPECT_THAT([] { read_suite("/nowhere/t.toml", testing::test_planners()); },
              ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("no such file: '/nowhere/t.toml'")));
}

TEST(Suite, HashKnowsMeaningFromLooks) {
  const std::string a = fmt::format("{}{}{}{}", kHead, kRobot, kMap, kPlanner);
  EXPECT_EQ(content_hash(suite_of(a)), content_hash(suite_of("# a comment\n" + a)));
  EXPECT_NE(content_hash(suite_of(a)), content_hash(suite_of(a + "how = \"x\"\n")));
}

TEST(Suite, QuickIsWellFormed) {
  const Suite quick = read_suite(std::string(OXTURN_SOURCE_DIR) + "/bench/suites/quick.toml", zoo());
  std::set<std::string> families;
  for (const MapSpec& m : quick.maps) families.insert(m.generator);
  EXPECT_EQ(families.size(), 9u);
  EXPECT_EQ(quick.planners.size(), zoo().size());
}

}  // namespace
}  // namespace oxturn

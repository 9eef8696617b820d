// One of each kind, added from outside the library: it appears wherever the built-in ones do, with no list edited.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "algorithms/coverage_planner.hpp"
#include "base/files.hpp"
#include "cli/program.hpp"
#include "reports/built_in_registry.hpp"
#include "tests/support/files.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

struct Params {
  double lane = 0.3;
};

/// Lanes over a rectangle, from one wall to the other.
class Snake final : public CoveragePlanner {
 public:
  explicit Snake(Params p) : p_(p) {}
  Path plan(const Problem& problem, Context& context) const override {
    const Box box = bounding_box(problem.configuration_space());
    PathBuilder path(problem.start());
    bool right = true;
    for (double y = box.low.y(); y <= box.high.y(); y += p_.lane, right = !right) {
      path.drive({right ? box.low.x() : box.high.x(), y}, true);
      path.drive({right ? box.high.x() : box.low.x(), y}, true);
    }
    context.record("lane", p_.lane);
    return path.take();
  }

 private:
  Params p_;
};

struct Size {
  double side = 3;
};
Region square(const Size& size, Rng&) { return box_region({0, 0}, {size.side, size.side}); }

/// "WIDTH HEIGHT" of a rectangle.
struct NoOptions {};
MapFile read_size(const std::string& file, const NoOptions&) {
  std::ifstream in(file);
  double width = 0, height = 0;
  in >> width >> height;
  return {{"sized", box_region({0, 0}, {width, height}), "file", file}, {}, {}, {}, {}};
}
std::string write_size(const MapFile& file) {
  const Box box = bounding_box(file.map.free);
  return std::to_string(box.size().x()) + " " + std::to_string(box.size().y()) + "\n";
}

Registry extended() {
  Registry registry = built_in_registry();
  registry.planners.add(
      describe<Snake, Params>({.name = "snake",
                               .family = "mine",
                               .title = "lanes over a rectangle",
                               .citation = "none",
                               .capabilities = {},
                               .guarantee = "none",
                               .parameters = {{"lane", &Params::lane, Range{0, 10, true}, "metres"}}}));
  registry.metrics.add({"legs", "count", Better::lower, "number of legs", [](const Scored& s) {
                          return std::optional<double>(static_cast<double>(s.path.legs.size()));
                        }});
  registry.generators.add(describe_generator<Size>("square", "a square", "one polygon",
                                                   {{"side", &Size::side, Range{1, 10}, "metres"}}, square));
  registry.formats.add(describe_format<NoOptions>("size", "width and height", {".size"}, {}, read_size, write_size));
  registry.tables.add({"count", "How many",
                       [](const Results& results) { return std::to_string(results.rows.size()) + " rows in all\n"; }});
  return registry;
}

struct Output {
  int code = 0;
  std::string out, err;
};

Output run(const std::vector<std::string>& words) {
  static const Registry registry = extended();
  std::vector<const char*> argv{"oxturn"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Output output;
  output.code = cli::run_program(static_cast<int>(argv.size()), argv.data(), registry);
  output.out = testing::internal::GetCapturedStdout();
  output.err = testing::internal::GetCapturedStderr();
  return output;
}

TEST(Registry, WhatIsAddedIsListed) {
  EXPECT_THAT(run({"list", "planners"}).out, HasSubstr("snake (mine): lanes over a rectangle"));
  EXPECT_THAT(run({"list", "metrics"}).out, HasSubstr("number of legs"));
  EXPECT_THAT(run({"list", "columns"}).out, HasSubstr("legs"));
  EXPECT_THAT(run({"list", "maps"}).out, HasSubstr("square: a square"));
  EXPECT_THAT(run({"list", "formats"}).out, HasSubstr(".size"));
  EXPECT_THAT(run({"list", "tables"}).out, HasSubstr("How many"));
}

TEST(Registry, WhatIsAddedPlansReadsAndWrites) {
  const TemporaryFolder folder;
  const std::string file = folder.file("hall.size"), copy = folder.file("copy.size");
  write_file(file, "4 2.5\n");
  const Output planned = run({"plan", "snake", file, "--set", "lane=0.2", "--json"});
  ASSERT_EQ(planned.code, 0) << planned.err;
  const Json json = Json::parse(planned.out);
  EXPECT_EQ(json.at("planner"), "snake[lane=0.2]");
  EXPECT_EQ(json.at("metrics").at("legs"), 1);
  EXPECT_EQ(json.at("records").at("lane"), 0.2);
  ASSERT_EQ(run({"map", file, "-o", copy}).code, 0);
  EXPECT_EQ(read_file(copy), "4.000000 2.500000\n");
  EXPECT_EQ(run({"plan", "snake", "square:2"}).code, 0);
  EXPECT_THAT(run({"plan", "snaek", file}).err, HasSubstr("did you mean 'snake'"));
}

TEST(Registry, WhatIsAddedRunsInSuitesAndReports) {
  const TemporaryFolder folder;
  write_file(folder.file("hall.size"), "4 2.5\n");
  write_file(folder.file("mine.toml"),
             "schema = 1\nname = \"mine\"\n[robots.disc]\nradius = 0.2\n[robots.tied]\ntether = { reach = 1.2 }\n"
             "[[maps]]\ngenerator = \"square\"\nside = 4\n[[maps]]\nfile = \"hall.size\"\n"
             "[[planners]]\nname = \"snake\"\nlane = [0.2, 0.4]\n"
             "[[planners]]\nname = \"leashed\"\nplanner = \"snake\"\nlane = 0.2\n");
  const std::string out = folder.file("out");
  const Output done = run({"run", folder.file("mine.toml"), "-o", out, "-q"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Results results = read_results(out);
  ASSERT_EQ(results.rows.size(), 12u);
  for (const Row& row : results.rows) {
    SCOPED_TRACE(row.get("variant") + " " + row.get("robot"));
    const bool fits = (row.get("planner") == "leashed") == (row.get("robot") == "tied");
    EXPECT_EQ(row.get("outcome"), fits ? "partial" : "unsupported") << row.get("reason");
    if (fits) { EXPECT_GE(row.number("legs").value_or(0), 1); }
  }
  EXPECT_THAT(read_file(out + "/report.md"), HasSubstr("## How many\n\n12 rows in all"));
  EXPECT_THAT(read_file(out + "/metrics.csv"), HasSubstr(",lane,0.2"));
}

TEST(Registry, ANameIsTakenOnce) {
  Registry registry = extended();
  PlannerInfo again = registry.planners.find("snake");
  EXPECT_EQ(complaint([&] { registry.planners.add(again); }),
            "there is a planner 'snake' already; choose another name");
}

}  // namespace
}  // namespace oxturn

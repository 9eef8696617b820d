// The viewer's page as text: its data, its policy, and that no text of a drawing can break out of it. What it does in a
// browser: viewer_browser.py.
#include "reports/viewer/viewer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/reports/sample_drawing.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}
Json data_of(const std::string& page) {
  return Json::parse(between(page, "<script type=\"application/json\" id=\"data\">", "</script>"));
}
std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Viewer, HoldsThePathWithTheTimesOfTheMission) {
  const Problem problem = sample::problem();
  const Path path = sample::path(problem.start());
  const Json data = data_of(viewer_page({.problem = problem, .path = &path, .traces = sample::traces()}));
  ASSERT_EQ(data["legs"].size(), path.legs.size());
  double before = 0;
  for (std::size_t i = 0; i < path.legs.size(); ++i) {
    const Json& leg = data["legs"][i];
    EXPECT_EQ(leg["tool"], path.legs[i].tool);
    ASSERT_EQ(leg["points"].size(), 2 * path.legs[i].points.size());
    ASSERT_EQ(leg["times"].size(), path.legs[i].points.size());
    for (const double time : leg["times"]) {
      EXPECT_GE(time, before);
      before = time;
    }
  }
  EXPECT_NEAR(before, *score(problem, path).value("mission_s"), 1e-3);
  EXPECT_EQ(data["traces"].size(), 2u);
  EXPECT_EQ(data["drawing"]["strokes"].size(), 6u);
  EXPECT_EQ(data["drawing"]["areas"][0]["rings"].size(), 2u) << "a letter with a hole";
}

TEST(Viewer, ForbidsEveryRequest) {
  const Problem problem = sample::problem();
  const std::string page = viewer_page({.problem = problem});
  EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                              "img-src data: blob:"));
  for (const char* request : {"http://", "https://", "fetch(", "XMLHttpRequest", "import(", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(request)));
}

TEST(Viewer, NamesCannotBreakOut) {
  Map map{"</title><script>alert(1)</script>", box_region({0, 0}, {5, 5}), "file", "x"};
  Drawing drawing;
  drawing.strokes = {sample::stroke("</script><!-- \xff \u2028 @SCRIPT@", {{1, 1}, {4, 4}})};
  map.drawing = std::make_shared<const Drawing>(drawing);
  const Problem problem(map, Robot{}, Point(1, 1));
  const std::string page = viewer_page({.problem = problem});
  EXPECT_EQ(count(page, "</script"), 2u);
  EXPECT_EQ(count(page, "<script"), 2u);
  EXPECT_EQ(data_of(page)["drawing"]["strokes"][0]["element"], "</script><!-- \uFFFD \u2028 @SCRIPT@");
}

TEST(Viewer, APageWithoutPathOrDrawing) {
  const Problem problem({"hall", box_region({0, 0}, {10, 5}), "file", "hand"}, Robot{}, Point(1, 1));
  const Json data = data_of(viewer_page({.problem = problem}));
  EXPECT_TRUE(data["drawing"].is_null());
  EXPECT_TRUE(data["legs"].empty());
  EXPECT_EQ(data["map"][0][0].size(), 8u);
}

// As a faulty planner may return them.
TEST(Viewer, APathThatIsNoneIsLeftOut) {
  const Problem problem = sample::problem();
  for (const Polyline& points : {Polyline{{1, 0.6}, {NAN, 2}}, Polyline(1, Point(1, 0.6)), Polyline()}) {
    Path path;
    path.legs = {{true, points}};
    const Json data = data_of(viewer_page({.problem = problem, .path = &path, .score = score(problem, path)}));
    EXPECT_TRUE(data["legs"].empty());
    EXPECT_NE(data["flaw"], "");
  }
}

TEST(Viewer, EditsAreHandedThrough) {
  const Problem problem = sample::problem();
  const std::string edits = R"({"oxturn_edits": 1, "drawing_sha256": "5a3e", "start": [2, 0.1]})";
  EXPECT_EQ(data_of(viewer_page({.problem = problem, .edits = edits}))["edits"], Json::parse(edits));
  EXPECT_THROW(viewer_page({.problem = problem, .edits = "[1"}), std::invalid_argument);
}

// A map of a millimetre and one of 10 km keep seven digits.
TEST(Viewer, CoordinatesAreRoundedByTheMapsExtent) {
  for (const double size : {1e-3, 20.0, 1e4}) {
    const double third = size / 3;
    Robot robot;
    robot.radius = size / 100;
    robot.tool_width = size / 100;
    const Problem problem({"x", box_region({0, 0}, {size, third}), "file", "hand"}, robot);
    const double written = data_of(viewer_page({.problem = problem}))["box"][1][1];
    EXPECT_NEAR(written, third, 1e-6 * size);
  }
}

}  // namespace
}  // namespace oxturn

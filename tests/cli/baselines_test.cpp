// docs/planners: paths from elsewhere, recorded or made by a slicer, are scored as any planner's.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;

/// 4 m x 3 m; the recordings below drive lanes of 3.6 m at y = 0.2, 0.6, ... 2.6 and 2.8.
const std::string kHall = R"({"type": "Feature", "properties": {"name": "hall", "start": [0.2, 0.2]},
"geometry": {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]}})";
constexpr double kLanes = 8 * 3.6 + 2.6;  // metres, with the moves between lanes

std::vector<std::pair<double, double>> lanes() {
  std::vector<std::pair<double, double>> points;
  for (int k = 0; k < 8; ++k) {
    const double y = std::min(0.2 + 0.4 * k, 2.8);
    points.insert(points.end(), {{k % 2 == 0 ? 0.2 : 3.8, y}, {k % 2 == 0 ? 3.8 : 0.2, y}});
  }
  return points;
}

class Recording : public ::testing::Test {
 protected:
  Recording() {
    map_ = folder_.write("hall.geojson", kHall);
    std::filesystem::create_directories(folder_ / "recordings");
  }
  Said plan(const std::string& more = "--json") {
    return oxturn("plan --exec 'python3 " OXTURN_SOURCE_DIR "/docs/planners/recording.py " + (folder_ / "recordings") +
                  "' '" + map_ + "' " + more);
  }
  void expect_lanes() {
    const Said said = plan();
    ASSERT_EQ(said.code, 0) << said.out << said.err;
    const auto result = nlohmann::json::parse(said.out);
    EXPECT_EQ(result.at("outcome"), "ok");
    EXPECT_NEAR(result.at("metrics").at("work_m").get<double>(), kLanes, 1e-9);
    EXPECT_NEAR(result.at("metrics").at("path_m").get<double>(), kLanes, 1e-9);
  }

  Folder folder_;
  std::string map_;
};

TEST_F(Recording, OfPosesIsScored) {
  std::string csv = "time,x,y,yaw\n";
  for (const auto& [x, y] : lanes()) csv += fmt::format("17.5,{},{},0\n", x, y);
  folder_.write("recordings/hall.csv", csv);
  expect_lanes();
}

// As `ros2 topic echo` prints it. A planner publishes its path again and again: the last message counts.
TEST_F(Recording, OfARosPathIsScored) {
  const auto message = [](const std::vector<std::pair<double, double>>& points) {
    std::string text = "header:\n  stamp:\n    sec: 5\n    nanosec: 0\n  frame_id: map\nposes:\n";
    for (const auto& [x, y] : points)
      text += fmt::format(
          "- header:\n    stamp:\n      sec: 5\n      nanosec: 0\n    frame_id: map\n  pose:\n    position:\n"
          "      x: {}\n      y: {}\n      z: 0.0\n    orientation:\n      x: 0.0\n      y: 0.0\n      z: 0.0\n"
          "      w: 1.0\n",
          x, y);
    return text + "---\n";
  };
  folder_.write("recordings/hall.yaml", message({{1, 1}, {2, 1}}) + message(lanes()));
  expect_lanes();
}

TEST_F(Recording, MessagesOfOnePoseEachAreAPath) {
  std::string text;
  for (const auto& [x, y] : lanes())
    text += fmt::format("pose:\n  pose:\n    position:\n      x: {}\n      y: {}\n      z: 0.0\n---\n", x, y);
  folder_.write("recordings/hall.yaml", text);
  expect_lanes();
}

TEST_F(Recording, WithTheToolOffIsTransit) {
  folder_.write("recordings/hall.csv", "x,y,tool\n1.2,0.2,1\n2.2,0.2,1\n3.7,0.2,0\n");
  const auto metrics = nlohmann::json::parse(plan().out).at("metrics");
  EXPECT_NEAR(metrics.at("work_m").get<double>(), 1, 1e-9);
  EXPECT_NEAR(metrics.at("transit_m").get<double>(), 1 + 1.5, 1e-9);  // from the start to the first pose, too
}

TEST_F(Recording, ThatIsMissingOrBadIsOneSentence) {
  EXPECT_THAT(plan().out + plan("").err, HasSubstr("there is no recording for 'hall'"));
  folder_.write("recordings/hall.csv", "0.2,0.2\n1,one\n");
  EXPECT_THAT(plan("").err, HasSubstr("hall.csv: line 2 is '1,one', expected x,y,yaw,tool"));
  folder_.write("recordings/hall.csv", "x,y\n");
  EXPECT_THAT(plan("").err, HasSubstr("the recording for 'hall' has no poses"));
}

TEST(Slicer, ItsInfillIsAPath) {
  if (std::system("slic3r --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "needs slic3r (apt install slic3r)";
  for (const std::string map : {"rectangle", "cave:1", "rooms:7"})
    for (const std::string pattern : {"rectilinear", "concentric"}) {
      const std::string arguments = map + " --set pattern=" + pattern + " --json";
      SCOPED_TRACE(arguments);
      const Said said = oxturn("plan --exec 'python3 " OXTURN_SOURCE_DIR "/docs/planners/slicer.py' " + arguments);
      ASSERT_EQ(said.code, 0) << said.out << said.err;  // a valid path
      EXPECT_GT(nlohmann::json::parse(said.out).at("metrics").at("coverage").get<double>(), 0.85);
    }
}

}  // namespace
}  // namespace oxturn

#include "algorithms/drawing/last_detours.hpp"

#include <gtest/gtest.h>

#include "geometry/bends.hpp"

namespace oxturn {
namespace {

using End = LastDetour::End;

constexpr double kHalf = 0.1, kRadius = 0.5;

/// A canvas of 10 m x 6 m, and what is drawn on it.
struct Canvas {
  explicit Canvas(const std::vector<Polyline>& lines)
      : problem(Map{"canvas", Region{{{{{0, 0}, {10, 0}, {10, 6}, {0, 6}}, {}}}}, "test", ""}, robot(), Point(1, 1)),
        work(pieces(lines), kHalf) {
    for (std::size_t k = 0; k < lines.size(); ++k) work.finish(k);
  }
  static Robot robot() {
    Robot robot;
    robot.radius = 0.1, robot.tool_width = 0.2, robot.min_turn_radius = kRadius;
    return robot;
  }
  static std::vector<DrawnPiece> pieces(const std::vector<Polyline>& lines) {
    std::vector<DrawnPiece> all;
    for (const Polyline& line : lines) all.push_back({line, kHalf});
    return all;
  }
  LastDetour find(const Pose& from, const Pose& to, double radius) {
    return LastDetours(problem, work, radius).find(from, to, Context());
  }
  Problem problem;
  FinishedWork work;
};

TEST(LastDetours, GoRoundWhatIsDrawn) {
  Canvas canvas({{{5, 0}, {5, 4.5}}});  // open above
  for (const double radius : {0.0, kRadius}) {
    const LastDetour d = canvas.find({{4, 1}, 0}, {{6, 1}, 0}, radius);
    ASSERT_EQ(d.end, End::found) << radius;
    EXPECT_EQ(d.path.front(), Point(4, 1));
    EXPECT_EQ(d.path.back(), Point(6, 1));
    EXPECT_EQ(canvas.work.crossing_m(d.path), 0);
    if (radius > 0)
      for (const Bend& bend : bends({{{false, d.path}}}, 1e-9, 0.2)) EXPECT_FALSE(too_sharp(bend, radius));
    else
      EXPECT_NEAR(length(d.path), 2 * std::hypot(1, 3.6), 0.5);
  }
}

TEST(LastDetours, AnEnclosedPointHasNone) {
  Canvas canvas({{{4, 1}, {8, 1}, {8, 5}, {4, 5}, {4, 1}}});
  for (const double radius : {0.0, kRadius}) {
    EXPECT_EQ(canvas.find({{2, 3}, 0}, {{6, 3}, 0}, radius).end, End::enclosed);
    EXPECT_EQ(canvas.find({{6, 3}, 0}, {{2, 3}, 0}, radius).end, End::enclosed);
  }
}

// A passage of 0.6 m: the robot cannot turn round in it, nor come out of it backwards.
TEST(LastDetours, ADeadEndHasNoCurve) {
  Canvas canvas({{{3, 2}, {8, 2}, {8, 2.8}, {3, 2.8}}});
  EXPECT_EQ(canvas.find({{6, 2.4}, 0}, {{1, 5}, 0}, 0).end, End::found);
  EXPECT_EQ(canvas.find({{6, 2.4}, 0}, {{1, 5}, 0}, kRadius).end, End::no_curve);
  EXPECT_EQ(canvas.find({{1, 5}, 0}, {{6, 2.4}, kPi}, kRadius).end, End::no_curve);
  EXPECT_EQ(canvas.find({{6, 2.4}, kPi}, {{1, 5}, 0}, kRadius).end, End::found);
}

// What is finished between two calls counts.
TEST(LastDetours, WorkIsFinishedOnTheWay) {
  Canvas canvas({{{5, 0}, {5, 4.5}}, {{5, 4.5}, {5, 6}}});
  canvas.work.undo(1);
  LastDetours detours(canvas.problem, canvas.work, kRadius);
  EXPECT_EQ(detours.find({{4, 1}, 0}, {{6, 1}, 0}, Context()).end, End::found);
  canvas.work.finish(1);
  EXPECT_EQ(detours.find({{4, 1}, 0}, {{6, 1}, 0}, Context()).end, End::enclosed);
}

}  // namespace
}  // namespace oxturn

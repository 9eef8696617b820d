// Values that a pencil knows, to the last digit where nothing is estimated.
#include <gmock/gmock.h>

#include "metrics/score.hpp"
#include "shapes.hpp"

namespace oxturn {
namespace {

constexpr double kTool = 0.4;

Problem hall(double radius = 0.2) { return problem_in(box_region({0, 0}, {20, 20}), {2, 2}, radius, kTool); }
double value(const std::string& metric, const Problem& p, const Path& path) {
  return score(p, path).value(metric).value();
}

TEST(Values, Lengths) {
  const Path path{{Leg{true, {{2, 2}, {5, 6}}}, Leg{false, {{5, 6}, {5, 8}, {7, 8}}}, Leg{true, {{7, 8}, {19, 13}}},
                   Leg{true, {{19, 13}, {19, 14}}}}};
  EXPECT_NEAR(value("path_m", hall(), path), 5 + 4 + 13 + 1, 1e-9);
  EXPECT_NEAR(value("work_m", hall(), path), 5 + 13 + 1, 1e-9);
  EXPECT_NEAR(value("transit_m", hall(), path), 4, 1e-9);
  EXPECT_NEAR(value("turn_rad", hall(), work({{2, 2}, {9, 2}, {9, 5}, {12, 8}, {9, 8}})),
              kPi / 2 + kPi / 4 + 3 * kPi / 4, 1e-9);
  EXPECT_NEAR(value("mission_s", hall(), work({{2, 2}, {12, 2}})), 10 / 0.5 + 0.5 / 0.5, 1e-9);
  EXPECT_NEAR(value("mission_s", hall(), work({{2, 2}, {2.3, 2.4}})), 2 * std::sqrt(0.5 / 0.5), 1e-9);
}

TEST(Values, LengthRatioCountsTheToolsDisc) {
  // A tool that covers all of a narrow room: the covered area is the target, exactly.
  const Problem closet = problem_in(box_region({0, 0}, {6, 1}), {0.5, 0.5}, 0.2, 1.6);
  const Path path = work({{0.5, 0.5}, {5.5, 0.5}});
  const Score s = score(closet, path);
  ASSERT_EQ(s.value("coverage_upper"), 1);
  EXPECT_NEAR(*s.value("length_ratio"), 5 * 1.6 / (*s.value("target_m2") - kPi * 1.6 * 1.6 / 4), 1e-9);
  // One straight lane is the shortest there is.
  EXPECT_GE(value("length_ratio", hall(), work({{2, 2}, {18, 2}})), 1);
  EXPECT_LE(value("length_ratio", hall(), work({{2, 2}, {18, 2}})), 1 + 1e-3);
}

TEST(Values, OverlapOfKnownShapes) {
  const double disc = kPi * kTool * kTool / 4, lane = 10 * kTool + disc;
  EXPECT_EQ(value("overlap", hall(), work({{2, 2}, {12, 2}})), 0);
  EXPECT_NEAR(value("overlap", hall(), work({{2, 2}, {12, 2}, {2, 2}})), 20 * kTool / lane - 1, 1e-4);
  EXPECT_NEAR(value("overlap", hall(), work({{2, 2}, {12, 2}, {2, 2}, {12, 2}})), 30 * kTool / lane - 1, 2e-4);
  const Path cross{{Leg{true, {{2, 7}, {12, 7}}}, Leg{false, {{12, 7}, {7, 2}}}, Leg{true, {{7, 2}, {7, 12}}}}};
  EXPECT_NEAR(value("overlap", hall(), cross), std::max(0.0, 20 * kTool / (2 * lane - kTool * kTool) - 1), 1e-4);
  EXPECT_NEAR(value("overlap", hall(), work(arc({7, 7}, 3, 0, 6 * kPi, 3000))), 2, 2e-3) << "three laps of a circle";
  EXPECT_NEAR(value("revisits", hall(), work(arc({7, 7}, 3, 0, 6 * kPi, 3000))), 2, 2e-2);
}

// A tool that reaches into the walls of a corridor on both sides, there and back: overlap counts all that it sweeps,
// revisits only the target. Around the turn there is one visit.
TEST(Values, OverlapAndRevisitsOfAToolWiderThanTheCorridor) {
  const Problem corridor = problem_in(box_region({0, 0}, {12, 1}), {1, 0.5}, 0.2, 1.6);
  const Path path = work({{1, 0.5}, {11, 0.5}, {1, 0.5}});
  EXPECT_NEAR(value("overlap", corridor, path), 20 * 1.6 / (10 * 1.6 + kPi * 0.64) - 1, 1e-3);
  const double around_the_turn = std::sqrt(0.39) + 1.28 * std::asin(0.5 / 0.8);  // the tool's disc within the walls
  EXPECT_NEAR(value("revisits", corridor, path), 10 / (10 + around_the_turn), 5e-3);
}

TEST(Values, Clearance) {
  Region room = box_region({0, 0}, {20, 20});
  room.polygons[0].holes.push_back({{10, 10}, {10, 12}, {12, 12}, {12, 10}});
  const Problem p = problem_in(room, {2, 2}, 0.2, kTool);
  EXPECT_NEAR(value("clearance_m", p, work({{2, 2}, {18, 2}})), 1.8, 1e-9);
  EXPECT_NEAR(value("clearance_m", p, work({{9, 9}, {9, 5}})), std::sqrt(2) - 0.2, 1e-9);
  EXPECT_NEAR(value("clearance_m", p, work({{2, 2}, {5, 10}, {9.5, 11}, {5, 12}})), 0.3, 1e-9);
  EXPECT_NEAR(value("clearance_m", p, work(arc({10, 10}, 1, kPi, 3 * kPi / 2, 4))), std::cos(kPi / 16) - 0.2, 1e-9);
}

// A path at the distance `off` from walls and corners, beyond the robot's radius.
class AtTheRadius : public testing::Test {
 public:
  static Path along_wall(double off) { return work({{2, 2}, {2, 0.2 + off}, {18, 0.2 + off}}); }
  static Path past_corner(double off) {  // diagonally past (10, 10)
    const Point nearest = Point(10, 10) - Point(1, 1) / std::sqrt(2) * (0.2 + off);
    return work({{2, 2}, nearest + Point(-2, 2), nearest + Point(2, -2)});
  }
  static Path round_corner(double off) {  // chords whose middles are at that distance
    const int n = 40;
    Polyline line = arc({10, 10}, (0.2 + off) / std::cos(kPi / 2 / n / 2), kPi, 3 * kPi / 2, n);
    line.insert(line.begin(), {{2, 2}, {5, 10}});
    return work(line);
  }
  static Problem room() {
    Region room = box_region({0, 0}, {20, 20});
    room.polygons[0].holes.push_back({{10, 10}, {10, 12}, {12, 12}, {12, 10}});
    return problem_in(room, {2, 2}, 0.2, kTool);
  }
};

TEST_F(AtTheRadius, TwiceTheToleranceTellsValidFromInvalid) {
  const Problem p = room();
  const double twice = 2 * p.tolerance();
  for (const auto path : {along_wall, past_corner, round_corner}) {
    EXPECT_EQ(find_flaw(p, path(twice)), "");
    EXPECT_EQ(find_flaw(p, path(0)), "");
    EXPECT_THAT(find_flaw(p, path(-twice)), testing::StartsWith("leaves configuration space"));
  }
}

TEST_F(AtTheRadius, AnAdditionalToleranceAdmitsMore) {
  const Problem p = room();
  const ScoreOptions millimetre{.tolerance = 1e-3};
  for (const auto path : {along_wall, past_corner, round_corner}) {
    EXPECT_EQ(find_flaw(p, path(-0.99e-3), millimetre), "");
    EXPECT_NE(find_flaw(p, path(-1.01e-3), millimetre), "");
    EXPECT_EQ(score(p, path(-0.99e-3), millimetre).flaw, "");
  }
  const Path jump{{Leg{true, {{2.0005, 2}, {5, 2}}}, Leg{true, {{5, 2.0005}, {5, 7}}}}};
  EXPECT_NE(find_flaw(p, jump), "");
  EXPECT_EQ(find_flaw(p, jump, millimetre), "");
  EXPECT_FALSE(score(p, jump).value("length_ratio").has_value());
  EXPECT_TRUE(score(p, jump, millimetre).value("length_ratio").has_value());
}

TEST(Promise, WhatIsPromisedIsMeasured) {
  const Problem p = hall();
  const Path path = work({{2, 2}, {12, 2}});
  EXPECT_FALSE(score(p, path).value("promise_coverage").has_value());
  const Score target = score(p, path, ScoreOptions{.promise = Promise::target});
  EXPECT_EQ(target.value("promise_coverage"), target.value("coverage_lower"));
  const Region kept = box_region({3, 1.9}, {11, 2.1}), half = box_region({3, 1.8}, {11, 2.6}), none{};
  const auto of = [&](const Region* cells) {
    return score(p, path, ScoreOptions{.promise = Promise::cells, .promised = cells}).value("promise_coverage");
  };
  EXPECT_EQ(of(&kept), 1);
  EXPECT_NEAR(*of(&half), 0.5, 1e-3);
  EXPECT_FALSE(of(&none).has_value());
  EXPECT_FALSE(of(nullptr).has_value());
}

}  // namespace
}  // namespace oxturn

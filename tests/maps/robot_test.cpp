#include "maps/robot.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/text.hpp"
#include "tests/support/files.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

std::string why_not(const std::function<void(Robot&)>& edit) {
  Robot robot;
  edit(robot);
  return complaint([&] { check(robot); });
}

TEST(Robot, EachNumberIsChecked) {
  EXPECT_EQ(why_not([](Robot&) {}), "");
  EXPECT_EQ(why_not([](Robot& r) { r.radius = 0; }), "");
  EXPECT_EQ(why_not([](Robot& r) { r.tool_width = 0; }),
            "parameter 'tool_width' of robot 'disc' is 0, expected a number above 0, at most 1e+09");
  EXPECT_EQ(why_not([](Robot& r) { r.radius = -1; }),
            "parameter 'radius' of robot 'disc' is -1, expected a number from 0 to 1e+09");
  EXPECT_THAT(why_not([](Robot& r) { r.speed = std::nan(""); }), HasSubstr("'speed' of robot 'disc' is nan"));
  EXPECT_THAT(why_not([](Robot& r) { r.acceleration = 0; }), HasSubstr("'acceleration' of robot 'disc' is 0"));
  EXPECT_THAT(why_not([](Robot& r) { r.turn_rate = INFINITY; }), HasSubstr("'turn_rate' of robot 'disc' is inf"));
  EXPECT_THAT(why_not([](Robot& r) { r.min_turn_radius = -2; }), HasSubstr("'min_turn_radius' of robot 'disc' is -2"));
  EXPECT_THAT(why_not([](Robot& r) { r.tether = Tether{0}; }), HasSubstr("tether has no length"));
  EXPECT_THAT(why_not([](Robot& r) { r.tether = Tether{4, 2}; }), HasSubstr("a length and a reach"));
  EXPECT_THAT(why_not([](Robot& r) { r.lidar = Lidar{5, 0}; }), HasSubstr("'lidar_rays' of robot 'disc' is 0"));
}

TEST(Robot, ALidarWithARangeAloneHasARayForEachDegree) {
  Robot robot;
  change(robot, {{"lidar_range", 6.0}});
  check(robot);
  EXPECT_EQ(robot.lidar->rays, 360);
}

TEST(Robot, SettingsThereAndBack) {
  Robot robot;
  change(robot, {{"name", std::string("cleaner")},
                 {"radius", 0.17},
                 {"tether_length", 12.0},
                 {"lidar_range", 6.0},
                 {"lidar_rays", std::int64_t{360}}});
  Robot back;
  change(back, settings_of(robot));
  EXPECT_EQ(settings_of(back), settings_of(robot));
  EXPECT_EQ(back.tether->length, 12.0);
  EXPECT_EQ(back.lidar->rays, 360);
  EXPECT_EQ(canonical_text(back), canonical_text(robot));
  back.name = "other";
  EXPECT_EQ(canonical_text(back), canonical_text(robot));
}

// Every parameter changes the robot and its written form, so no field can be lost.
TEST(Robot, EveryParameterIsWrittenAndHashed) {
  for (const Parameter<Robot>& parameter : robot_parameters()) {
    const std::string& name = parameter.info.name;
    if (name == "name") continue;
    SCOPED_TRACE(name);
    const Value plain = parameter.get(Robot{});
    const Value other = name == "footprint"                           ? Value(std::string("octagon:1"))
                        : std::holds_alternative<std::int64_t>(plain) ? Value(std::int64_t{7})
                        : std::holds_alternative<bool>(plain)         ? Value(!std::get<bool>(plain))
                                                                      : Value(0.375);
    Robot robot;
    if (name == "reverse") robot.min_turn_radius = 1;  // has no effect otherwise
    const std::string before = canonical_text(robot);
    change(robot, {{name, other}});
    EXPECT_NE(parameter.get(robot), plain);
    EXPECT_TRUE(settings_of(robot).contains(name));
    EXPECT_NE(canonical_text(robot), before);
    Robot back;
    change(back, settings_of(robot));
    EXPECT_EQ(parameter.get(back), parameter.get(robot));
  }
}

TEST(Robot, WhatReplacesWhat) {
  Robot robot;
  change(robot, {{"footprint", std::string("square:1")}});
  change(robot, {{"radius", 0.3}});
  EXPECT_TRUE(robot.footprint.empty());
  change(robot, {{"tether_length", 5.0}});
  change(robot, {{"tether_reach", 1.5}});
  EXPECT_EQ(robot.tether->length, 0);
  EXPECT_THAT(complaint([&] {
                change(robot, {{"radius", 0.3}, {"footprint", std::string("square:1")}});
              }),
              HasSubstr("a radius and a footprint"));
  EXPECT_THAT(complaint([&] { change(robot, {{"rays", 3.0}}); }), HasSubstr("unknown parameter 'rays' of robot"));
}

}  // namespace
}  // namespace oxturn

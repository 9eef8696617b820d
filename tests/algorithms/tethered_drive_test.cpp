// Tethered shortest paths from goal to goal.
#include "algorithms/transit/tethered_drive.hpp"

#include <gtest/gtest.h>

#include "tether_checks.hpp"

namespace oxturn {
namespace {

// The robot went home and out again wherever the search among the classes ran out of budget.
TEST(TetheredDrive, WithoutASearchAComponentIsEnteredFromWhereTheRobotIs) {
  const Problem problem(generate("speckle", {{"width", 30.0}, {"height", 30.0}}, 1), tethered_robot(1));
  const TetherSpace space(problem, "test");
  ASSERT_GE(space.components().size(), 50u);
  int unproven = 0;
  for (std::size_t k = 1; k < space.components().size(); ++k) {
    const TetherSpace::Component &at = space.components()[k - 1], &next = space.components()[k];
    const Point from = at.problem.start(), to = next.problem.start();
    TetheredRobot robot(space.world(), problem.start());
    robot.drive(at.entry_path);
    const auto found = robot.path_to(to, Retraction::automatic, 1);
    ASSERT_TRUE(found.has_value());
    if (!found->shortest) ++unproven;
    EXPECT_LE(length(found->points), length(space.path(at, from, next, to)) * (1 + 1e-9));
    Path path;
    path.legs = {{false, at.entry_path}, {false, found->points}};
    EXPECT_LE(drive_tethered(problem, path, 0.5).longest, space.tether_length() + problem.tolerance());
  }
  EXPECT_GT(unproven, 10);
}

}  // namespace
}  // namespace oxturn

#include "algorithms/transit/tethered_drive.hpp"

namespace oxturn {
namespace {

constexpr double kMostWound = 3;  // tether lengths

}  // namespace

TetheredDrive::TetheredDrive(const TetherSpace& space, Settings settings)
    : space_(space),
      settings_(settings),
      robot_(space.world(), space.problem().start()),
      path_(space.problem().start()) {}

bool TetheredDrive::go(const Point& goal) {
  if (goal == robot_.at()) return true;
  if (robot_.trail().length() > kMostWound * space_.tether_length()) unwind();
  const auto next = robot_.path_to(goal, settings_.retraction, settings_.budget);
  if (!next) return false;
  if (!next->shortest) ++unproven_;
  robot_.drive(next->points);
  path_.drive(next->points, true);
  return true;
}

void TetheredDrive::go_home() {
  if (const auto home = robot_.path_home()) path_.drive(*home, false);
}

/// About an obstacle much smaller than the robot the tether can wind again and again, and gets hardly longer. The path
/// driven, pulled taut, does; what it costs to follow it back must be bounded. Back home along itself it is undone.
void TetheredDrive::unwind() {
  const auto home = robot_.path_home();
  if (!home) return;
  path_.drive(*home, true);
  robot_ = TetheredRobot(space_.world(), space_.problem().start());
}

}  // namespace oxturn

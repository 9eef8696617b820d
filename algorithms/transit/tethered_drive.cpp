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

/// Points between which the straight path is free, and certainly within the tether length limit, are driven together.
std::size_t TetheredDrive::go_along(const Polyline& points) {
  constexpr std::size_t kTogether = 16;
  const TetheredWorld& world = space_.world();
  std::size_t missed = 0;
  Polyline part;
  for (std::size_t i = 0; i < points.size();) {
    const bool wound = robot_.trail().length() > kMostWound * space_.tether_length();
    double tether = robot_.tether().length();
    part.clear();
    for (Point from = at(); !wound && i < points.size() && part.size() < kTogether; from = points[i++]) {
      tether += distance(from, points[i]);
      if (!(tether <= world.longest) || !world.walls.contains(from, points[i])) break;
      part.push_back(points[i]);
    }
    if (part.empty()) {
      missed += !go(points[i++]);
      continue;
    }
    robot_.drive(part);
    path_.drive(part, true);
  }
  return missed;
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

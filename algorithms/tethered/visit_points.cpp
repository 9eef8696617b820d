#include "algorithms/tethered/visit_points.hpp"

namespace oxturn {

Path visit_points(const TetherSpace& leash, const std::vector<Point>& places, const VisitSettings& settings,
                  Context& context) {
  TetheredRobot robot(leash.world(), leash.problem().start());
  PathBuilder path(leash.problem().start());
  std::vector<Polyline> missed;
  std::size_t unproven = 0;
  const std::size_t milestone = std::max<std::size_t>(1, places.size() / 16);
  for (std::size_t k = 0; k < places.size() && !context.cancelled(); ++k) {
    if (places[k] == robot.at()) continue;
    const auto way = robot.path_to(places[k], settings.retraction, settings.budget);
    if (!way) {
      const double arm = leash.problem().robot().tool_width / 4;
      missed.push_back({places[k] - Point(arm, 0), places[k] + Point(arm, 0)});
      continue;
    }
    if (!way->shortest) ++unproven;
    robot.drive(way->points);
    path.drive(way->points, true);
    if (k % milestone == milestone - 1) {
      context.progress(double(k + 1) / static_cast<double>(places.size()));
      context.publish(PathBuilder(path).take());
    }
  }
  if (settings.return_home && !context.cancelled())
    if (const auto home = robot.path_home()) path.drive(home->points, false);
  context.record("cells_missed", static_cast<double>(missed.size()));
  context.record("paths_unproven", static_cast<double>(unproven));
  if (context.wants_traces() && !missed.empty()) context.trace("missed", std::move(missed));
  return path.take();
}

}  // namespace oxturn

#include "algorithms/tethered/visit_cells.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kPublications = 16;

}  // namespace

Path visit_cells(const TetherSpace& space, const TetherCells& cells, const CellList& order, const VisitParameters& how,
                 Context& context) {
  TetheredRobot robot(space.world(), space.problem().start());
  PathBuilder path(space.problem().start());
  std::vector<Polyline> missed;  // a short level line at each
  std::size_t unproven = 0;
  const std::size_t period = std::max<std::size_t>(1, order.size() / kPublications);
  for (std::size_t k = 0; k < order.size() && !context.cancelled(); ++k) {
    const Point& goal = cells[order[k]].at;
    if (goal == robot.at()) continue;
    const auto next = robot.path_to(goal, how.retraction, static_cast<std::size_t>(how.budget));
    if (!next) {
      const Point arm(space.problem().robot().tool_width / 4, 0);
      missed.push_back({goal - arm, goal + arm});
      continue;
    }
    if (!next->shortest) ++unproven;
    robot.drive(next->points);
    path.drive(next->points, true);
    if (k % period == period - 1) {
      context.progress(static_cast<double>(k + 1) / static_cast<double>(order.size()));
      context.publish(PathBuilder(path).take());
    }
  }
  if (how.return_home && !context.cancelled())
    if (const auto home = robot.path_home()) path.drive(*home, false);
  context.record("cells_missed", static_cast<double>(missed.size()));
  context.record("paths_unproven", static_cast<double>(unproven));
  if (context.wants_traces() && !missed.empty()) context.trace("missed", std::move(missed));
  return path.take();
}

}  // namespace oxturn

#include "algorithms/tethered/visit_cells.hpp"

#include "algorithms/lattice/promised_cells.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kPublications = 16;
constexpr double kMostWound = 3;    // tether lengths
constexpr double kRounding = 1e-9;  // cell sides

/// One run.
class CellVisits {
 public:
  CellVisits(const TetherSpace& space, const TetherCells& cells, const VisitParameters& how)
      : space_(space),
        cells_(cells),
        how_(how),
        robot_(space.world(), space.problem().start()),
        trail_(space.world().space, space.problem().start()),
        path_(space.problem().start()) {}

  void visit(std::size_t cell) {
    bool all = go(cells_[cell].at);
    if (all) visited_.push_back(cell);
    for (Polyline wall : cells_.walls(cell)) {
      if (distance(robot_.at(), wall.back()) < distance(robot_.at(), wall.front()))
        std::reverse(wall.begin(), wall.end());
      for (const Point& p : wall) all &= go(p);
    }
    if (!all) miss(cells_[cell].at);
  }

  Path take(Context& context) {
    if (how_.return_home && !context.cancelled())
      if (const auto home = robot_.path_home()) path_.drive(*home, false);
    context.record("cells_missed", static_cast<double>(missed_.size()));
    context.record("paths_unproven", static_cast<double>(unproven_));
    if (context.wants_promise() && !context.cancelled()) promise(context);
    if (context.wants_traces() && !missed_.empty()) context.trace("missed", std::move(missed_));
    return path_.take();
  }
  Path so_far() const { return PathBuilder(path_).take(); }

 private:
  /// False if no path keeps the tether length limit.
  bool go(const Point& goal) {
    if (goal == robot_.at()) return true;
    if (trail_.length() > kMostWound * space_.tether_length()) unwind();
    const auto next = robot_.path_to(goal, how_.retraction, static_cast<std::size_t>(how_.budget));
    if (!next) return false;
    if (!next->shortest) ++unproven_;
    drive(next->points);
    return true;
  }
  void drive(const Polyline& points) {
    robot_.drive(points);
    trail_.drive(points);
    path_.drive(points, true);
  }
  /// About an obstacle much smaller than the robot the tether can wind again and again, and gets hardly longer. The
  /// path driven, pulled taut, does; what it costs to follow it back must be bounded. Back home along itself it is
  /// undone.
  void unwind() {
    const auto home = robot_.path_home();
    if (!home) return;
    path_.drive(*home, true);
    robot_ = TetheredRobot(space_.world(), space_.problem().start());
    trail_ = TautTether(space_.world().space, space_.problem().start());
  }
  void miss(const Point& at) {
    const Point arm(space_.problem().robot().tool_width / 4, 0);
    missed_.push_back({at - arm, at + arm});
  }
  void promise(Context& context) const {
    const double w = space_.problem().robot().tool_width;
    if (how_.cells == CellKind::partial && missed_.empty() && cells_.side() <= w / std::sqrt(2.0) * (1 + kRounding))
      promise_region(context, space_.problem().configuration_space());
    else
      promise_cells(context, cells_.lattice(), cells_.central(visited_), w);
  }

  const TetherSpace& space_;
  const TetherCells& cells_;
  const VisitParameters& how_;
  TetheredRobot robot_;
  TautTether trail_;  // the path driven, pulled taut
  PathBuilder path_;
  CellList visited_;
  std::vector<Polyline> missed_;  // a short level line at each
  std::size_t unproven_ = 0;
};

}  // namespace

Path visit_cells(const TetherSpace& space, const TetherCells& cells, const CellList& order, const VisitParameters& how,
                 Context& context) {
  CellVisits visits(space, cells, how);
  const std::size_t period = std::max<std::size_t>(1, order.size() / kPublications);
  for (std::size_t k = 0; k < order.size() && !context.cancelled(); ++k) {
    visits.visit(order[k]);
    if (k % period != period - 1) continue;
    context.progress(static_cast<double>(k + 1) / static_cast<double>(order.size()));
    context.publish(visits.so_far());
  }
  return visits.take(context);
}

}  // namespace oxturn

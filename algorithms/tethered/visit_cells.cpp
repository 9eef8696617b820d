#include "algorithms/tethered/visit_cells.hpp"

#include "algorithms/grown_path.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/transit/tethered_drive.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kReports = 256;  // of progress
constexpr double kRounding = 1e-9;     // cell sides

/// One run.
class CellVisits {
 public:
  CellVisits(const TetherSpace& space, const TetherCells& cells, const VisitParameters& how)
      : space_(space),
        cells_(cells),
        how_(how),
        drive_(space, {how.retraction, static_cast<std::size_t>(how.budget)}) {}

  void visit(std::size_t cell) {
    bool all = drive_.go(cells_[cell].at);
    if (all) visited_.push_back(cell);
    for (Polyline wall : cells_.walls(cell)) {
      if (distance(drive_.at(), wall.back()) < distance(drive_.at(), wall.front()))
        std::reverse(wall.begin(), wall.end());
      for (const Point& p : wall) all &= drive_.go(p);
    }
    if (!all) miss(cells_[cell].at);
  }

  Path take(Context& context) {
    if (how_.return_home && !context.cancelled()) drive_.go_home();
    context.record("cells_missed", static_cast<double>(missed_.size()));
    context.record("paths_unproven", static_cast<double>(drive_.unproven()));
    if (context.wants_promise() && !context.cancelled()) promise(context);
    if (context.wants_traces() && !missed_.empty()) context.trace("missed", std::move(missed_));
    return drive_.take();
  }
  const Path& so_far() const { return drive_.path(); }

 private:
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
  TetheredDrive drive_;
  CellList visited_;
  std::vector<Polyline> missed_;  // a short level line at each
};

}  // namespace

Path visit_cells(const TetherSpace& space, const TetherCells& cells, const CellList& order, const VisitParameters& how,
                 Context& context) {
  CellVisits visits(space, cells, how);
  GrownPath grown(context);
  const std::size_t period = std::max<std::size_t>(1, order.size() / kReports);
  for (std::size_t k = 0; k < order.size() && !context.cancelled(); ++k) {
    visits.visit(order[k]);
    grown.offer(visits.so_far());
    if (k % period == 0) context.progress(static_cast<double>(k + 1) / static_cast<double>(order.size()));
  }
  return visits.take(context);
}

}  // namespace oxturn

// Visits grid cells in bands of similar tether distance, each band by angle about the last bend of the tether.
//
// Source      Berg 2021, chapter 4.1: an improvement of Shnaps and Rimon 2014
// Model       grid, offline, disc footprint of one cell
// Guarantee   as shnaps-rimon: visits every cell in which the robot fits (`cells`); keeps the tether length limit
// Complexity  n cells: O(n log n) for their order, then n tethered shortest paths. With group = none, as published,
//             the cells about different bends of one band are mixed: the path grows as n^1.5, as that of shnaps-rimon.
//             With group = piece nearly all paths lead to a cell near by.
// Decisions   1. The angle is that of the cell seen from the last corner of its geodesic, counter-clockwise from the x
//                axis; Berg 2021 says no more. So cells about different bends are mixed, which is a weakness.
//             2. `group = bend` (ours) keeps the cells about one bend together, bends by their distance. By default
//                `piece` (ours) divides bands into the pieces of band_forest.hpp and goes depth-first over them.
//             3. `alternate` (ours, the default) reverses every second band; `band` (ours) is the depth of a band in
//                cells.
//             4. All paths are driven with the tool on, and `cells = partial` (ours) drives walls, as in shnaps-rimon.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "algorithms/online/survey_then_plan.hpp"
#include "algorithms/tethered/band_forest.hpp"
#include "algorithms/tethered/visit_cells.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kSameDistance = 1e-6;  // cell sides
constexpr double kSameAngle = 1e-6;     // radians; what is closer than that differs by rounding only

/// The direction of `arm`, counter-clockwise from the x axis, in steps of kSameAngle: cells of one row or diagonal are
/// in one direction, and a cell due east is in direction 0, whatever rounding says.
long long direction(const Point& arm) {
  const auto full = std::llround(2 * kPi / kSameAngle);
  const auto angle = std::llround(math::atan2(arm.y(), arm.x()) / kSameAngle);
  return angle < 0 ? angle + full : angle;
}

enum class Group { none, bend, piece };

struct Params : VisitParameters {
  double band = 1;
  bool alternate = true;
  Group group = Group::piece;
};

CellList banded(const Params& p, const TetherCells& cells, const GeodesicField& field) {
  const double depth = p.band * cells.side();
  // Band; the bend, if cells are grouped by it (tether up to it, position); direction; cell.
  using Key = std::tuple<long long, long long, double, double, long long, std::size_t>;
  std::vector<Key> keys;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const GeodesicField::Sight sight = field.sight(cells[c].at);
    const Point arm = cells[c].at - sight.from;
    long long angle = direction(arm);
    const auto band = static_cast<long long>(cells[c].distance / depth + kSameDistance);
    if (p.alternate && band % 2 == 1) angle = -angle;
    if (p.group == Group::bend)
      keys.emplace_back(band, std::llround(sight.before / (kSameDistance * cells.side())), sight.from.x(),
                        sight.from.y(), angle, c);
    else
      keys.emplace_back(band, 0, 0, 0, angle, c);
  }
  const auto sort = [&](CellList& list) {
    std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  };
  if (p.group == Group::piece) return forest_order(cells, depth, sort).cells;
  CellList order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sort(order);
  return order;
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const TetherSpace space(problem, "shnaps-rimon-banded");
  const TetherCells cells(problem, problem.configuration_space(), p.side(problem.robot()), p.cells);
  return visit_cells(space, cells, banded(p, cells, space.field()), p, context);
}

}  // namespace

PlannerInfo shnaps_rimon_banded() {
  return with_sensing(describe<Params, plan>(
      {.name = "shnaps-rimon-banded",
       .family = "tethered",
       .title = "cells in bands of similar tether distance, by angle",
       .citation = "Berg 2021, after Shnaps & Rimon 2014",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "visits every cell; length at most 2 L n, home included",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_visit_parameters<Params>(
           {{"band", &Params::band, Range{0.01, 1000}, "depth of a band, in cells"},
            {"alternate", &Params::alternate, "every second band in the opposite direction"},
            {"group", &Params::group, Choices{"none", "bend", "piece"},
             "of a band: bend: cells about one bend of the tether together; piece: one side of an obstacle is finished "
             "before the other, as with order = split of shnaps-rimon"}}),
       .published = {
           {"band", 1.0}, {"alternate", false}, {"group", std::string("none")}, {"cells", std::string("joined")}}}));
}

}  // namespace oxturn

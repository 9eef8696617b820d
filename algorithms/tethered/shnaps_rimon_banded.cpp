// Cells in bands of like tether distance, each band by angle about the latest bend.
//
// Source      Berg 2021, chapter 4.1: the thesis's mend for Shnaps & Rimon 2014
// Model       grid, offline, disc footprint of one cell
// Guarantee   as shnaps-rimon: visits every cell in which the robot can stand (`cells`); string within the leash
// Complexity  n cells: O(n log n) for their order, then n tethered shortest paths
// Decisions   1. The angle is that of the cell seen from the last corner of its geodesic, from the x axis
//                counter-clockwise; the thesis says no more. So cells about different bends mix, which is its flaw.
//             2. `group = bend` (ours) keeps the cells about one bend together, bends by their distance.
//             3. `alternate` (ours) turns every second band round; `band` (ours) is the band's depth in cells.
//             4. Every way is driven with the tool on, as in shnaps-rimon.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "algorithms/online/sensing.hpp"
#include "algorithms/transit/tether_space.hpp"
#include "algorithms/tethered/tether_cells.hpp"
#include "algorithms/tethered/visit_points.hpp"

namespace oxturn {
namespace {

struct Params {
  double band = 1;
  bool alternate = false;
  std::string group = "none";
  std::string cells = "any";
  double cell_size = 0;
  std::string retraction = "automatic";
  int budget = 2000;
  bool return_home = true;
};

class ShnapsRimonBanded final : public CoveragePlanner {
 public:
  explicit ShnapsRimonBanded(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace leash(problem, "shnaps-rimon-banded");
    const TetherCells cells(problem, problem.configuration_space(), cell_side(p_.cell_size, problem.robot()),
                            p_.cells == "any" ? CellKind::any : CellKind::joined);
    struct Entry {
      long long band;
      double before, x, y;  // the bend, if bends are kept together
      double angle;
      std::size_t cell;
    };
    std::vector<Entry> order;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const GeodesicField::Sight sight = leash.field().sight(cells[c].place);
      const Point arm = cells[c].place - sight.from;
      double angle = std::atan2(arm.y(), arm.x());
      if (angle < 0) angle += 2 * kPi;
      const auto band = static_cast<long long>(cells[c].distance / (p_.band * cells.side()) + 1e-6);
      const double sign = p_.alternate && band % 2 == 1 ? -1 : 1;
      Entry entry{band, 0, 0, 0, sign * angle, c};
      if (p_.group == "bend") {
        entry.before = sight.before;
        entry.x = sight.from.x();
        entry.y = sight.from.y();
      }
      order.push_back(entry);
    }
    std::sort(order.begin(), order.end(), [](const Entry& a, const Entry& b) {
      return std::tie(a.band, a.before, a.x, a.y, a.angle, a.cell) <
             std::tie(b.band, b.before, b.x, b.y, b.angle, b.cell);
    });
    std::vector<Point> places;
    for (const Entry& entry : order) places.push_back(cells[entry.cell].place);
    return visit_points(leash, places,
                        {p_.retraction == "untangle" ? Retraction::untangle : Retraction::automatic,
                         static_cast<std::size_t>(p_.budget), p_.return_home},
                        context);
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo shnaps_rimon_banded() {
  return with_sensing(describe<ShnapsRimonBanded, Params>(
      {.name = "shnaps-rimon-banded",
       .family = "tethered",
       .title = "cells in bands of like tether distance, by angle",
       .citation = "Berg 2021, after Shnaps & Rimon 2014",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "visits every cell; length at most 2 L n, home included",
       .parameters = {
           {"band", &Params::band, Range{0.01, 1000}, "depth of a band, in cells"},
           {"alternate", &Params::alternate, "every second band the other way round"},
           {"group", &Params::group, Choices{"none", "bend"}, "bend: cells about one bend of the tether together"},
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side D of a cell, metres; 0: tool width / sqrt 2"},
           {"cells", &Params::cells, Choices{"any", "joined"},
            "any: at walls, a cell's free place nearest to its centre counts for it; joined: wholly free cells only"},
           {"retraction", &Params::retraction, Choices{"automatic", "untangle"},
            "untangle: back along the way driven until the next cell is in straight reach"},
           {"budget", &Params::budget, Range{0, 1e9}, "expansions a way, of the search for another class"},
           {"return_home", &Params::return_home, "drive back to the start at the end, tether taken in"}}}));
}

}  // namespace oxturn

// Cuts the world into rectangles of cells and cleans them one by one, column by column.
//
// Source      MyCarbot, "Rechteck-Partitionierungs-Strategie" (TH Nuernberg), sections 2 and 5
// Model       grid, offline, or online by lidar (`sensing = lidar`), disc footprint
// Guarantee   every cell of a drivable rectangle of at least 2 x 2 cells is cleaned, except skipped columns and cells
//             below a shifted start; with `revisit_skipped` every lattice point that the robot can reach is driven
// Complexity  n cells: world and partition O(n), a way between rectangles O(cells nearer than its end); some 60 bytes a
//             cell. `choose = first` goes back to the lower end after each column of rectangles: O(n^1.5) driven at worst
// Decisions   1. Cells default to half the robot's width (its robot is larger than a cell). A cell is wall unless it
//                lies wholly in free space.
//             2. "First from the lower left" may run row by row or column by column (`scan`); the
//                source does not say. Columns is the default: it covered more on six of seven maps tried.
//             3. The source mends gaps and partitions anew after each rectangle and each skipped column, with done cells
//                as obstacles. Done cells are no wall that a gap could be in, and taking them away leaves all other
//                rectangles as they are (rectangle_world.hpp): so both are done once, and a rectangle loses its skipped
//                columns.
//             4. A column is driven where the robot's centre fits, all of its stretches, up and down by turns. Ways
//                between stretches and columns that are not straight are planned on the lattice and pulled straight;
//                where the lattice does not lead on they are shortest paths among the walls.
//             5. The centre is visited on the way (seed 2.3) if the robot fits there.
//             6. `columns = tool` (ours) steps as many columns as the tool covers, instead of one.
//             7. The outlooks: `choose = nearest` takes the start with the fewest planned steps, so a divided corridor is
//                cleaned one side after the other; `lanes = diagonal` makes no rectangles but lanes at 45
//                degrees ("Schraegen ueber das Grid"), each as long as it goes, on to the nearest end of one, for
//                pillars set in staggered rows (rectangles on a turned grid were tried: worse than straight ones).
//                Beside slanted walls rectangles are strips one cell wide, which the source does not drive:
//                `smallest = 1` (ours) does.
//             8. Online: scan (world_scan.hpp), then the same on what is believed, on a lattice that hangs on the start.
//                Driven nodes are done. The world is partitioned anew where an obstacle stops the robot, and after a
//                rectangle if more than four cells' area has been seen since. Ends when nothing new is seen.
#include <fmt/format.h>

#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/rectangle_cleaner.hpp"
#include "algorithms/grid/world_scan.hpp"
#include "geometry/trace.hpp"

namespace oxturn {
namespace {

struct Params : RectangleSettings {
  std::string sensing = "map";
};

constexpr int kLevel = 2;  // of the belief: radius / 24
constexpr int kMostPartitions = 2000;

double turn_of(const Params& p) { return p.lanes == "diagonal" ? kPi / 4 : 0; }

void report_left(Context& context, const RectangleCleaner::Counts& counts) {
  context.record("skipped_columns", static_cast<double>(counts.skipped_columns));
  context.record("skipped_cells", static_cast<double>(counts.skipped_cells));
  context.record("small_cells", static_cast<double>(counts.small_cells));
}

Path clean_known(const Params& p, const Problem& problem, Context& context) {
  const double side = p.side(problem.robot());
  const GridGraph graph = make_grid_graph(problem, {p.cell_size, p.align, 0, 0, turn_of(p)}, side, 1,
                                          static_cast<int>(std::ceil(problem.robot().radius / side)) + 1);
  RectangleCleaner cleaner(p, problem, graph, std::vector<bool>(graph.size(), false), context);
  Path path = cleaner.clean();
  context.record("rectangles", static_cast<double>(cleaner.counts().rectangles));
  report_left(context, cleaner.counts());
  return path;
}

/// The robot in a world that it sees by lidar.
class Discovery {
 public:
  Discovery(const Params& p, OnlineRobot& robot, Context& context) : p_(p), robot_(robot), context_(context) {}

  void run() {
    WorldScan scan;
    while (const auto motion = scan.next(view())) {
      robot_.go(*motion);
      if (context_.cancelled()) return;
    }
    context_.record("scan_m", view().driven());
    RectangleCleaner::Counts last;  // what stays skipped is what the last partition skips
    std::size_t partitions = 0;
    double before = -1;
    while (partitions < kMostPartitions && !context_.cancelled()) {
      const std::uint64_t seen = view().belief().revision();
      const auto path = partition(last);
      if (!path || path->legs.empty()) break;
      ++partitions;
      const bool whole = clean(*path);
      // The same plan again would end the same way.
      const bool on = view().driven() > before;
      before = view().driven();
      if (!on || (whole && view().belief().revision() == seen)) break;
    }
    context_.record("partitions", static_cast<double>(partitions));
    report_left(context_, last);
  }

 private:
  const View& view() const { return robot_.view(); }

  std::optional<Problem> world() const {
    for (int level = kLevel; level > 0; --level)
      if (auto believed = believed_problem(view(), view().pose(), level)) return believed;
    return believed_problem(view(), view().pose(), 0);
  }

  std::optional<Path> partition(RectangleCleaner::Counts& counts) {
    const std::optional<Problem> believed = world();
    if (!believed) return std::nullopt;
    if (!angle_) angle_ = (p_.align == "edges" ? dominant_direction(believed->map().free) : 0) + turn_of(p_);
    const GridGraph graph =
        make_grid_graph_at(believed->configuration_space(), "belief", view().start(), p_.side(view().robot()), *angle_);
    // Its own context: only the partition is shown.
    Context::Sinks sinks;
    if (context_.wants_traces()) sinks.trace = [&](const Trace& trace) { context_.trace(trace.name, trace.lines); };
    Context inside(1, context_.seconds_left(), sinks);
    RectangleCleaner cleaner(p_, *believed, graph, done(graph), inside);
    Path path = cleaner.clean();
    counts = cleaner.counts();
    if (!path.legs.empty() && believed->start() != view().pose())
      robot_.go({{view().pose(), believed->start()}, false});
    return path;
  }

  /// The nodes that have been driven with the tool on, along lanes or across them.
  std::vector<bool> done(const GridGraph& graph) const {
    std::vector<bool> nodes(graph.size(), false);
    constexpr double kOff = 1e-3;
    for (const Leg& leg : view().path().legs)
      for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k) {
        const Point a = graph.coordinates(leg.points[k - 1]), b = graph.coordinates(leg.points[k]);
        const int i = static_cast<int>(std::lround(a.x()));
        if (std::abs(a.x() - i) > kOff || std::abs(b.x() - i) > kOff) continue;
        const int low = static_cast<int>(std::ceil(std::min(a.y(), b.y()) - kOff));
        const int high = static_cast<int>(std::floor(std::max(a.y(), b.y()) + kOff));
        for (int j = low; j <= high; ++j)
          if (graph.inside(i, j)) nodes[graph.at(i, j)] = true;
      }
    return nodes;
  }

  /// False if the world has to be partitioned anew before the end.
  bool clean(const Path& path) {
    const double cell = view().belief().cell(), side = p_.side(view().robot());
    const auto enough = static_cast<std::uint64_t>(4 * side * side / (cell * cell));
    const std::uint64_t before = view().belief().gained();
    for (const Leg& leg : path.legs) {
      if (!robot_.go({leg.points, leg.tool})) return false;
      if (leg.tool && view().belief().gained() > before + enough) return false;
    }
    return true;
  }

  const Params& p_;
  OnlineRobot& robot_;
  Context& context_;
  std::optional<double> angle_;
};

class Rectangles final : public CoveragePlanner {
 public:
  explicit Rectangles(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    Path path =
        p_.sensing == "map"
            ? clean_known(p_, problem, context)
            : drive_online(
                  problem, [&](OnlineRobot& robot, Context& inside) { Discovery(p_, robot, inside).run(); }, context);
    if (path.legs.empty())
      throw Infeasible(fmt::format("no rectangle of at least {} x {} cells can be driven; a smaller cell_size may help",
                                   p_.smallest, p_.smallest));
    return path;
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo rectangles() {
  return describe<Rectangles, Params>(
      {.name = "rectangles",
       .family = "grid",
       .title = "rectangle partition, column by column",
       .citation = "MyCarbot (TH Nuernberg)",
       .capabilities = {Capability::online, Capability::holes, Capability::footprint},
       .guarantee = "every cell of a drivable rectangle of at least 2 x 2 cells, except skipped columns",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: half the robot's width"},
           {"choose", &Params::choose, Choices{"first", "nearest"},
            "next rectangle: first from the lower left, or the one with the shortest planned way to its start"},
           {"columns", &Params::columns, Choices{"each", "tool"},
            "drive each column, or step as far as the tool covers"},
           {"scan", &Params::scan, Choices{"columns", "rows"}, "how the first cell from the lower left is looked for"},
           {"lanes", &Params::lanes, Choices{"straight", "diagonal"},
            "diagonal: no rectangles but lanes at 45 degrees, for staggered pillars"},
           {"smallest", &Params::smallest, Range{1, 1000},
            "rectangles with fewer cells a side are not driven; 1: strips beside slanted walls are"},
           {"gap", &Params::gap, Range{0, 100}, "gaps in walls up to so many cells are closed"},
           {"small_obstacle", &Params::small_obstacle, Range{0, 100},
            "obstacles up to so many cells a side get their missing corners"},
           {"shift", &Params::shift, Range{0, 1000},
            "how many cells the start is moved up before the column is skipped"},
           {"via_centre", &Params::via_centre, "go to the rectangle's centre first, then to its lower left"},
           {"revisit_skipped", &Params::revisit_skipped, "in the end, drive what was skipped"},
           {"align", &Params::align, Choices{"axes", "edges"},
            "edges: turn the grid to the direction most walls run in"},
           {"sensing", &Params::sensing, Choices{"map", "lidar"},
            "map: known beforehand; lidar: seen by the robot's lidar, its outer wall scanned first"}}});
}

}  // namespace oxturn

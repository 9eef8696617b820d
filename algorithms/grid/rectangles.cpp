// Partitions the world into rectangles of cells and cleans them one by one, lane by lane.
//
// Source      MyCarbot (TH Nuernberg), "Rechteck-Partitionierungs-Strategie", sections 2 and 5. The defaults are the
//             source, but for `cells`, `choose`, `columns`, `along` and `smallest`
// Model       grid, offline, or online by lidar (`sensing = lidar`), disc footprint
// Guarantee   every cell of a driven column (or row) of a drivable rectangle of at least `smallest` cells a side is
//             cleaned, except those before a shifted start; with `columns = each` columns are skipped only where the
//             robot does not fit; with `revisit_skipped` every lattice node that the robot can reach is driven
// Complexity  n cells: world and partition O(n), a path between rectangles O(cells nearer than its end); some 60 bytes
//             a cell. `choose = nearest` searches the nodes that are nearer than the next rectangle; where walls have
//             few edges, after 20,000 nodes the triangles of free space (nearest_component.hpp). `choose = first` may
//             cross the map after each column of rectangles: O(n^1.5) driven at worst
// Decisions   1. Cells default to half the robot's width (`cells = robot`; the source's robot is larger than a cell) or
//                to half the tool's, whichever is more: narrow lanes under a wide tool are driven many times over,
//                and a tool covers cells up to 0.7 of its width. A cell is wall unless it lies entirely in free space,
//                or is larger than the robot and its centre can be driven: what else lies in it is under the tool.
//                Rectangles one cell wide are driven from their nearer end. The source leaves them (`smallest = 2`):
//                between obstacles that are not aligned with the grid these are most of the area.
//             2. "First from the lower left" may run row by row or column by column (`scan`); the source does not say.
//                Columns is the default: it covered more on six of seven maps tried.
//             3. The source closes gaps and partitions anew after each rectangle and each skipped column, with cleaned
//                cells as obstacles. Cleaned cells are no wall beside a gap, and removing them leaves all other
//                rectangles as they are (rectangle_world.hpp). So gaps are closed once, and the partition is repeated
//                only without the columns that rectangles begin with and that have to be skipped: of all rectangles at
//                once, until there are none. (Else a notch too narrow for the robot would cut a strip as high as itself
//                out of a whole room.) Columns skipped inside a rectangle change nothing.
//             4. A column is driven where the robot's centre fits, in all of its runs, up and down in turn. Paths
//                between runs and columns that are not straight are planned on the lattice and pulled straight; where
//                the lattice leads nowhere they are shortest paths among the walls.
//             5. The centre is visited on the way (section 2.3) if the robot fits there.
//             6. `columns = tool` (ours, the default) steps as many columns as the tool covers, instead of one, but so
//                that cells in between are under the tool from both sides: beside walls it steps less.
//                `along = longer` (ours, the default) drives rectangles that are wider than high in rows: the mirror
//                image of what the source does. Among slanted walls and scattered obstacles most rectangles are one
//                to three cells high: the paths are as long as in columns, with half the turns.
//             7. The outlooks of section 5: `choose = nearest` takes the start with the fewest planned steps, or
//                with the shortest path among walls where the lattice leads to none near by, so a divided corridor is
//                cleaned one side after the other; it is the default. What the lattice does not connect is cleaned
//                after the rectangle that is nearest to it (component_links.hpp). `lanes = diagonal` makes no
//                rectangles but lanes at 45 degrees ("Schraegen ueber das Grid"), each as long as possible, on to the
//                nearest end of one, for pillars in staggered rows (rectangles on a turned grid were tried: worse than
//                straight ones).
//             8. Online: a scan of the world (world_scan.hpp), then the same on what is believed, on a lattice with a
//                node at the start. Driven nodes are done, and those between two lanes under the tool
//                (driven_nodes.hpp; driven nodes alone: paths up to twice as long). The world is partitioned anew
//                where an obstacle stops the robot, and after a rectangle if more than the area of four cells has been
//                seen since. Ends when nothing new is seen.
#include <fmt/format.h>

#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/driven_nodes.hpp"
#include "algorithms/grid/rectangle_cleaner.hpp"
#include "algorithms/grid/world_scan.hpp"

namespace oxturn {
namespace {

constexpr int kBeliefLevel = 2;        // cells of radius / 4
constexpr int kMostPartitions = 2000;  // a belief that never settles must not keep the robot driving
constexpr double kNewCells = 4;        // area seen since the partition, in cells, that makes a new one worthwhile

double turn_of(const RectangleOptions& p) { return p.lanes == Lanes::diagonal ? kPi / 4 : 0; }

void record_left(Context& context, const CleanedRectangles& counts) {
  context.record("skipped_columns", static_cast<double>(counts.skipped_columns));
  context.record("skipped_cells", static_cast<double>(counts.skipped_cells));
  context.record("small_cells", static_cast<double>(counts.small_cells));
}

Path clean_known(const RectangleOptions& p, const Problem& problem, Context& context) {
  const double side = p.side(problem.robot());
  const GridGraph graph =
      make_grid_graph(problem, {.side = side,
                                .angle = lattice_angle(p.align, problem.map().free) + turn_of(p),
                                .margin = static_cast<int>(std::ceil(problem.robot().radius / side)) + 1});
  CleanedRectangles cleaned = clean_rectangles(p, problem, graph, std::vector<bool>(graph.size(), false), context);
  context.record("rectangles", static_cast<double>(cleaned.rectangles));
  record_left(context, cleaned);
  return std::move(cleaned.path);
}

/// Scans and cleans a world that the robot sees by lidar.
class Discovery {
 public:
  Discovery(const RectangleOptions& p, OnlineRobot& robot, Context& context)
      : p_(p), robot_(robot), context_(context) {}

  void run() {
    scan_world(robot_, context_);
    if (context_.cancelled()) return;
    context_.record("scan_m", view().driven);
    CleanedRectangles last;  // what the last partition skips stays skipped
    std::size_t partitions = 0;
    double before = -1;
    while (partitions < kMostPartitions && !context_.cancelled()) {
      const std::uint64_t seen = view().belief.revision();
      const std::optional<Problem> believed = world();
      if (!believed) break;
      last = partition(*believed);
      if (last.path.legs.empty()) break;
      ++partitions;
      const bool finished = clean(last.path);
      const bool moved = view().driven > before;
      before = view().driven;
      // Otherwise the next partition would end in the same way.
      if (!moved || (finished && view().belief.revision() == seen)) break;
    }
    context_.record("partitions", static_cast<double>(partitions));
    record_left(context_, last);
  }

 private:
  const View& view() const { return robot_.view(); }

  std::optional<Problem> world() const {
    for (int level = kBeliefLevel; level > 0; --level)
      if (auto believed = believed_problem(view(), view().pose, level)) return believed;
    return believed_problem(view(), view().pose, 0);
  }

  CleanedRectangles partition(const Problem& believed) {
    if (!angle_) angle_ = lattice_angle(p_.align, believed.map().free) + turn_of(p_);
    const GridGraph graph =
        make_grid_graph_at(believed.configuration_space(), "belief", view().start, p_.side(view().robot), *angle_);
    Context inner(1, context_.seconds_left(), context_.traces_only());
    CleanedRectangles cleaned = clean_rectangles(p_, believed, graph, done(graph), inner);
    if (!cleaned.path.legs.empty() && believed.start() != view().pose)
      robot_.go({{view().pose, believed.start()}, false});
    return cleaned;
  }

  /// The nodes that have been driven along their column or row with the tool on; with columns = tool, those between
  /// two such lanes under the tool as well.
  std::vector<bool> done(const GridGraph& graph) const {
    DrivenNodes driven(graph);
    for (const Leg& leg : view().path.legs)
      for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k) driven.add(leg.points[k - 1], leg.points[k]);
    return driven.covered(p_.lane_distance(view().robot));
  }

  /// False if the world has to be partitioned anew before the end of the path.
  bool clean(const Path& path) {
    const double cell = view().belief.cell(), side = p_.side(view().robot);
    const auto enough = static_cast<std::uint64_t>(kNewCells * side * side / (cell * cell));
    const std::uint64_t before = view().belief.gained();
    for (const Leg& leg : path.legs) {
      if (!robot_.go({leg.points, leg.tool})) return false;
      if (leg.tool && view().belief.gained() > before + enough) return false;
    }
    return true;
  }

  const RectangleOptions& p_;
  OnlineRobot& robot_;
  Context& context_;
  std::optional<double> angle_;
};

Path plan(const RectangleOptions& p, const Problem& problem, Context& context) {
  const auto by_lidar = [&](OnlineRobot& robot, Context& inner) { Discovery(p, robot, inner).run(); };
  Path path = p.sensing == Sensing::map ? clean_known(p, problem, context) : drive_online(problem, by_lidar, context);
  if (path.legs.empty())
    throw Infeasible(fmt::format("no rectangle of at least {} x {} cells can be driven; a smaller cell_size may help",
                                 p.cells_needed(problem.robot()), p.cells_needed(problem.robot())));
  return path;
}

}  // namespace

PlannerInfo rectangles() {
  using P = RectangleOptions;
  return describe<P, plan>(
      {.name = "rectangles",
       .family = "grid",
       .title = "rectangle partition, lane by lane",
       .citation = "MyCarbot (TH Nuernberg)",
       .capabilities = {Capability::online, Capability::holes, Capability::footprint},
       .guarantee = "every cell of the driven columns or rows of rectangles of at least `smallest` cells a side",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters =
           {cell_size_line<P>("side of a cell, metres; 0: as `cells` says"),
            {"cells", &P::cells, Choices{"wider", "robot"},
             "cell_size = 0: cells are half as wide as the robot (as published), or as the wider of robot and tool"},
            {"choose", &P::choose, Choices{"first", "nearest"},
             "next rectangle: first from the lower left, or the one with the shortest planned path to its start"},
            {"columns", &P::columns, Choices{"each", "tool"},
             "drive each column (or row), or step as far as the tool covers"},
            {"along", &P::along, Choices{"columns", "longer"},
             "lanes run in columns (as published), or along the longer side of each rectangle"},
            {"scan", &P::scan, Choices{"columns", "rows"},
             "in which order the first cell from the lower left is searched"},
            {"lanes", &P::lanes, Choices{"straight", "diagonal"},
             "diagonal: no rectangles but lanes at 45 degrees, for staggered pillars"},
            {"smallest", &P::smallest, Range{0, 1000},
             "rectangles with fewer cells a side are not driven; 0: 2, or 1 if cells are as wide as the robot; 2: "
             "as published, strips beside slanted walls are left"},
            {"gap", &P::gap, Range{0, 100}, "gaps in walls of up to so many cells are closed"},
            {"small_obstacle", &P::small_obstacle, Range{0, 100},
             "obstacles of up to so many cells a side get their missing corners"},
            {"shift", &P::shift, Range{0, 1000}, "how many cells the start may move up before the column is skipped"},
            {"via_centre", &P::via_centre, "drive to the rectangle's centre first, then to its lower left"},
            {"revisit_skipped", &P::revisit_skipped, "at the end, drive what was skipped"},
            align_line<P>(),
            sensing_line<P>("map: known beforehand; lidar: seen by the robot's lidar, its outer wall scanned first")},
       .published = {{"cells", std::string("robot")},
                     {"choose", std::string("first")},
                     {"columns", std::string("each")},
                     {"along", std::string("columns")},
                     {"smallest", 2}}});
}

}  // namespace oxturn

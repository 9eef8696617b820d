// Cuts the world into rectangles of cells and cleans them one by one, column by column.
//
// Source      MyCarbot, "Rechteck-Partitionierungs-Strategie" (TH Nuernberg), sections 2.2 to 2.4 and 5
// Model       grid, offline (the known world; the scan of an unknown one is not needed here), disc footprint
// Guarantee   every cell of a drivable rectangle of at least 2 x 2 cells is cleaned, except skipped columns and cells
//             below a shifted start; with `revisit_skipped` every lattice point that the robot can reach is driven
// Complexity  n cells: time and memory O(n) for world and partition, plus a shortest path for each rectangle
// Decisions   1. Cells default to half the robot's width (its robot is larger than a cell). A cell is wall unless it
//                lies wholly in free space.
//             2. "First from the lower left" may run row by row or column by column (`scan`); the
//                source does not say. Columns is the default: it covered more on six of seven maps tried.
//             3. The source partitions anew after each rectangle and each skipped column, with done cells as
//                obstacles. That leaves all other rectangles as they are (rectangle_world.hpp), so the partition is
//                made once, and a rectangle loses its skipped columns.
//             4. A column is driven where the robot's centre fits, all of its stretches, up and down by turns; ways
//                between stretches and columns that are not straight are shortest paths.
//             5. The centre is visited on the way (seed 2.3) if the robot fits there.
//             6. `columns = tool` (ours) steps as many columns as the tool covers, instead of one.
#include <algorithm>
#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/grid_graph.hpp"
#include "algorithms/grid/nearest_part.hpp"
#include "algorithms/grid/rectangle_world.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string choose = "first";
  std::string columns = "each";
  std::string scan = "columns";
  int gap = 1;
  int small_obstacle = 4;
  int shift = 4;
  bool via_centre = true;
  bool revisit_skipped = false;
  std::string align = "axes";
};

// A run of lattice nodes in one column that can be driven without leaving it.
struct Stretch {
  int column, low, high;
};

class Cleaner {
 public:
  Cleaner(const Params& p, const Problem& problem, Context& context)
      : p_(p),
        problem_(problem),
        context_(context),
        graph_(make_grid_graph(problem, {p.cell_size, p.align, 0, 0}, side_of(p, problem), 1,
                               static_cast<int>(std::ceil(problem.robot().radius / side_of(p, problem))) + 1)),
        side_(graph_.side()),
        driven_(graph_.size(), false),
        path_(problem.start()) {}

  Path clean() {
    const BitGrid world = without_gaps(dirty_cells(), p_.gap, p_.small_obstacle);
    const std::vector<CellRectangle> all = rectangles_of(world, p_.scan == "rows");
    if (context_.wants_traces()) context_.trace("rectangles", outlines(all));

    std::vector<CellRectangle> drivable;
    std::vector<Stretch> starts;
    for (CellRectangle r : all) {
      const std::optional<Stretch> start = start_of(r);
      if (!start || r.width() < 2 || r.height() < 2) continue;
      drivable.push_back(r);
      starts.push_back(*start);
    }
    NearestPart nearest(problem_);
    if (p_.choose == "nearest")
      for (std::size_t k = 0; k < drivable.size(); ++k)
        nearest.add(node(starts[k].column, starts[k].low), static_cast<int>(k), k);
    for (std::size_t n = 0; n < drivable.size() && !context_.cancelled(); ++n) {
      std::size_t k = n;
      if (p_.choose == "nearest") {
        const auto found = nearest.from(path_.at());
        if (!found) break;
        k = found->id;
        nearest.drop(static_cast<int>(k));
      }
      clean(drivable[k], starts[k]);
      context_.progress(double(n + 1) / static_cast<double>(drivable.size()));
    }
    if (p_.revisit_skipped) revisit();
    if (context_.wants_traces()) context_.trace("skipped", skipped_);
    return path_.take();
  }

 private:
  static double side_of(const Params& p, const Problem& problem) {
    if (p.cell_size > 0) return p.cell_size;
    return problem.robot().radius > 0 ? problem.robot().radius : problem.robot().tool_width / 2;
  }
  Point node(int i, int j) const { return graph_.centre(i, j); }

  // The cells that lie wholly in free space, in the frame of the lattice.
  BitGrid dirty_cells() const {
    const Point corner = graph_.centre(-0.5, -0.5);
    const Point across = graph_.centre(0.5, -0.5) - corner;
    const double angle = std::atan2(across.y(), across.x());
    return rasterise(transformed(problem_.map().free, -angle, Point(0, 0)), rotated(corner, -angle), side_,
                     graph_.columns(), graph_.rows(), CellRule::inside);
  }

  std::vector<Stretch> stretches(int i, int bottom, int top) const {
    std::vector<Stretch> found;
    for (int j = bottom; j <= top; ++j) {
      if (!graph_.free(i, j)) continue;
      int end = j;
      while (end < top && graph_.passable(i, end, kNorth)) ++end;
      found.push_back({i, j, end});
      j = end;
    }
    return found;
  }

  // Seed 2.3: as near to the lower left as possible; up to `shift` cells up, then the next column. Columns without a
  // place are skipped: the rectangle loses them.
  std::optional<Stretch> start_of(CellRectangle& r) {
    for (; r.left <= r.right; ++r.left) {
      const std::vector<Stretch> runs = stretches(r.left, r.bottom, std::min(r.top, r.bottom + p_.shift));
      if (!runs.empty()) return runs.front();
      if (context_.wants_traces()) skipped_.push_back({node(r.left, r.bottom), node(r.left, r.top)});
    }
    return std::nullopt;
  }

  void clean(const CellRectangle& r, const Stretch& start) {
    const Point middle = graph_.centre((r.left + r.right) / 2.0, (r.bottom + r.top) / 2.0);
    if (p_.via_centre && problem_.walls().contains(middle)) go(middle, false);
    const int step =
        p_.columns == "tool" ? std::max(1, static_cast<int>(problem_.robot().tool_width / side_ + 1e-9)) : 1;
    bool up = true, first = true;
    for (int i = r.left;; i = std::min(i + step, r.right)) {
      // The first column counts from the start; cells below a shifted one stay (seed).
      std::vector<Stretch> runs = stretches(i, i == r.left ? start.low : r.bottom, r.top);
      if (runs.empty() && context_.wants_traces()) skipped_.push_back({node(i, r.bottom), node(i, r.top)});
      if (!up) std::reverse(runs.begin(), runs.end());
      for (const Stretch& s : runs) {
        drive(s, up, !first);
        first = false;
      }
      if (!runs.empty()) up = !up;
      if (i == r.right) break;
    }
  }

  void drive(const Stretch& s, bool up, bool may_work) {
    // A stretch of one node has no length to sweep: there the tool comes down for the last bit of the way.
    go(node(s.column, up ? s.low : s.high), may_work, s.low == s.high ? side_ : 0);
    path_.drive(node(s.column, up ? s.high : s.low), true);
    for (int j = s.low; j <= s.high; ++j) driven_[graph_.at(s.column, j)] = true;
  }

  // Straight with the tool on for the short step to the next column, else the shortest way with the tool off but for
  // its last `tail` metres.
  void go(const Point& to, bool may_work, double tail = 0) {
    if (distance(path_.at(), to) == 0) return;
    if (may_work && distance(path_.at(), to) <= 2 * std::max(side_, problem_.robot().tool_width) &&
        problem_.walls().contains(path_.at(), to)) {
      path_.drive(to, true);
      return;
    }
    auto way = problem_.transit().path(path_.at(), to);
    if (!way) throw std::logic_error("two places in configuration space are not connected");
    Polyline last{way->back()};
    while (way->size() > 1 && tail > 0) {
      const Point end = way->back();
      way->pop_back();
      const double step = distance(way->back(), end);
      if (step > tail) way->push_back(lerp(end, way->back(), tail / step));
      last.insert(last.begin(), way->back());
      tail -= step;
    }
    path_.drive(*way, false);
    if (last.size() > 1) path_.drive(last, true);
  }

  // Ours: whatever lattice node the robot can reach and has not driven.
  void revisit() {
    std::vector<Stretch> open;
    for (int i = 0; i < graph_.columns(); ++i)
      for (const Stretch& s : stretches(i, 0, graph_.rows() - 1))
        for (int j = s.low; j <= s.high; ++j) {
          if (driven_[graph_.at(i, j)]) continue;
          int end = j;
          while (end < s.high && !driven_[graph_.at(i, end + 1)]) ++end;
          open.push_back({i, j, end});
          j = end;
        }
    NearestPart nearest(problem_);
    for (std::size_t k = 0; k < open.size(); ++k)
      for (const bool up : {true, false})
        nearest.add(node(open[k].column, up ? open[k].low : open[k].high), static_cast<int>(k), 2 * k + (up ? 0 : 1));
    while (!context_.cancelled()) {
      const auto found = nearest.from(path_.at());
      if (!found) return;
      drive(open[found->id / 2], found->id % 2 == 0, true);
      nearest.drop(static_cast<int>(found->id / 2));
    }
  }

  std::vector<Polyline> outlines(const std::vector<CellRectangle>& rectangles) const {
    std::vector<Polyline> lines;
    for (const CellRectangle& r : rectangles) {
      const Point a = graph_.centre(r.left - 0.5, r.bottom - 0.5), b = graph_.centre(r.right + 0.5, r.bottom - 0.5);
      const Point c = graph_.centre(r.right + 0.5, r.top + 0.5), d = graph_.centre(r.left - 0.5, r.top + 0.5);
      lines.push_back({a, b, c, d, a});
    }
    return lines;
  }

  const Params& p_;
  const Problem& problem_;
  Context& context_;
  GridGraph graph_;
  double side_;
  std::vector<bool> driven_;
  std::vector<Polyline> skipped_;
  PathBuilder path_;
};

class Rectangles final : public CoveragePlanner {
 public:
  explicit Rectangles(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    Path path = Cleaner(p_, problem, context).clean();
    if (path.legs.empty())
      throw Infeasible("no rectangle of at least 2 x 2 cells can be driven; a smaller cell_size may help");
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
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "every cell of a drivable rectangle of at least 2 x 2 cells, except skipped columns",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: half the robot's width"},
           {"choose", &Params::choose, Choices{"first", "nearest"},
            "next rectangle: first from the lower left, or the one with the shortest way to its start"},
           {"columns", &Params::columns, Choices{"each", "tool"},
            "drive each column, or step as far as the tool covers"},
           {"scan", &Params::scan, Choices{"columns", "rows"}, "how the first cell from the lower left is looked for"},
           {"gap", &Params::gap, Range{0, 100}, "gaps in walls up to so many cells are closed"},
           {"small_obstacle", &Params::small_obstacle, Range{0, 100},
            "obstacles up to so many cells a side get their missing corners"},
           {"shift", &Params::shift, Range{0, 1000},
            "how many cells the start is moved up before the column is skipped"},
           {"via_centre", &Params::via_centre, "go to the rectangle's centre first, then to its lower left"},
           {"revisit_skipped", &Params::revisit_skipped, "in the end, drive what was skipped"},
           {"align", &Params::align, Choices{"axes", "edges"},
            "edges: turn the grid to the direction most walls run in"}}});
}

}  // namespace oxturn

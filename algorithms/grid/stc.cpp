// Spanning tree coverage, offline: round a tree of coarse cells, each sub-cell once.
//
// Source      Gabriely & Rimon, "Spanning-tree based coverage of continuous areas by a mobile robot", ICRA 2001
// Model       grid of coarse cells 2D x 2D, offline, disc footprint
// Guarantee   each sub-cell (side D) of the free coarse cells connected to the first one exactly once; the round
//             is closed and its length is the number of sub-cells times D
// Complexity  n sub-cells: time and memory O(n); `weighted` and `minimum-turn` O(n log n)
// Decisions   1. A coarse cell is free if the square through its four sub-cell centres, which is all that is driven
//                inside it, lies in configuration space; two are adjacent if both ways between them do.
//             2. D defaults to w / sqrt 2, so that a disc tool covers each sub-cell from its centre line; the
//                paper's square tool is cell_size = w.
//             3. The paper starts in a cell. Here the robot first drives the shortest way to the nearest sub-cell.
//             4. `components = all` (ours) goes on to the other parts of the free coarse cells, nearest first, by
//                shortest paths in configuration space; `start` is the paper.
//             5. The tree: breadth-first (counter-clockwise from east), depth-first, `minimum-turn` (depth-first
//                that goes straight on while it can), `random`, `weighted` (minimum spanning tree, vertical edges
//                dearer: long horizontal lanes).
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/coarse_cells.hpp"
#include "algorithms/grid/nearest_part.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string tree = "bfs";
  std::string components = "all";
  std::string align = "axes";
  double shift_x = 0, shift_y = 0;
};

// The connected parts of the free coarse cells: a number for each cell, -1 for cells that are not free.
std::vector<int> parts_of(const CoarseCells& cells, int& count) {
  std::vector<int> part(cells.size(), -1);
  std::vector<std::size_t> queue;
  count = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!cells.free(c) || part[c] >= 0) continue;
    part[c] = count;
    queue.assign(1, c);
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (const Direction d : kAllDirections)
        if (cells.adjacent(queue[k], d) && part[cells.neighbour(queue[k], d)] < 0) {
          part[cells.neighbour(queue[k], d)] = count;
          queue.push_back(cells.neighbour(queue[k], d));
        }
    ++count;
  }
  return part;
}

// Depth-first without recursion: a million cells are a deep tree. `straight`: go on as one came, if possible.
void grow_depth_first(CoarseCells& cells, std::size_t root, bool straight, Rng* shuffled) {
  struct Step {
    std::size_t cell;
    std::array<Direction, 4> order;
    int next;
  };
  const auto order_from = [&](Direction came) {
    std::array<Direction, 4> order = kAllDirections;
    if (straight) order = {came, left_of(came), right_of(came), opposite(came)};
    if (shuffled) shuffled->shuffle(order);
    return order;
  };
  std::vector<bool> seen(cells.size(), false);
  std::vector<Step> stack{{root, order_from(kEast), 0}};
  seen[root] = true;
  while (!stack.empty()) {
    Step& top = stack.back();
    if (top.next == 4) {
      stack.pop_back();
      continue;
    }
    const Direction d = top.order[static_cast<std::size_t>(top.next++)];
    if (!cells.adjacent(top.cell, d)) continue;
    const std::size_t to = cells.neighbour(top.cell, d);
    if (seen[to]) continue;
    seen[to] = true;
    cells.link(top.cell, d);
    stack.push_back({to, order_from(d), 0});
  }
}

// Kruskal over the part with two weights: all horizontal edges first, then vertical ones.
void grow_weighted(CoarseCells& cells, const std::vector<int>& part, int which) {
  std::vector<std::uint32_t> parent(cells.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::size_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  for (const Direction d : {kEast, kNorth})
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (part[c] != which || !cells.adjacent(c, d)) continue;
      const std::size_t a = find(c), b = find(cells.neighbour(c, d));
      if (a == b) continue;
      parent[b] = static_cast<std::uint32_t>(a);
      cells.link(c, d);
    }
}

void grow_tree(CoarseCells& cells, std::size_t root, const std::vector<int>& part, const std::string& kind, Rng& rng) {
  if (kind == "bfs")
    grow_breadth_first(cells, root);
  else if (kind == "weighted")
    grow_weighted(cells, part, part[root]);
  else
    grow_depth_first(cells, root, kind == "minimum-turn", kind == "random" ? &rng : nullptr);
}

class Stc final : public CoveragePlanner {
 public:
  explicit Stc(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const double side = p_.cell_size > 0 ? p_.cell_size : problem.robot().tool_width / std::sqrt(2.0);
    const GridGraph fine = make_grid_graph(problem, {p_.cell_size, p_.align, p_.shift_x, p_.shift_y}, side, 2);
    CoarseCells cells(fine);
    int count = 0;
    const std::vector<int> part = parts_of(cells, count);
    if (count == 0) throw Infeasible("no coarse cell of twice the cell size fits; a smaller cell_size may");

    NearestPart nearest(problem);
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (part[c] >= 0 && on_rim(cells, c))
        for (int k = 0; k < 4; ++k)
          nearest.add(sub_cell(fine, cells, c, k), part[c], c * 4 + static_cast<std::size_t>(k));
    PathBuilder path(problem.start());
    std::vector<Polyline> trees;
    for (int done = 0; done < count && !context.cancelled(); ++done) {
      const std::optional<NearestPart::Found> found =
          next_part(problem, fine, cells, part, nearest, path.at(), done == 0);
      if (!found) break;
      const std::size_t cell = found->id / 4;
      const int k = static_cast<int>(found->id % 4);
      grow_tree(cells, cell, part, p_.tree, context.rng());
      path.drive(found->way, false);
      path.drive(round_tree(fine, cells, 2 * cells.column(cell) + k % 2, 2 * cells.row(cell) + k / 2), true);
      nearest.drop(part[cell]);
      context.progress(double(done + 1) / count);
      if (p_.components == "start") break;
    }
    if (context.wants_traces()) context.trace("tree", tree_lines(cells));
    return path.take();
  }

 private:
  static Point sub_cell(const GridGraph& fine, const CoarseCells& cells, std::size_t c, int k) {
    return fine.centre(2 * cells.column(c) + k % 2, 2 * cells.row(c) + k / 2);
  }
  // Only cells at the edge of their part can be where a way from another part first comes in.
  static bool on_rim(const CoarseCells& cells, std::size_t c) {
    return std::any_of(kAllDirections.begin(), kAllDirections.end(),
                       [&](Direction d) { return !cells.adjacent(c, d); });
  }
  // The start may stand in the middle of a part: there the sub-cell under the robot is nearest.
  static std::optional<NearestPart::Found> next_part(const Problem& problem, const GridGraph& fine,
                                                     const CoarseCells& cells, const std::vector<int>& part,
                                                     NearestPart& nearest, const Point& from, bool first) {
    if (first) {
      const Point at = fine.coordinates(from);
      const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
      if (fine.inside(i, j)) {
        const std::size_t c = cells.at(i / 2, j / 2);
        const int k = i % 2 + 2 * (j % 2);
        if (part[c] >= 0)
          if (auto way = problem.transit().path(from, sub_cell(fine, cells, c, k)))
            return NearestPart::Found{c * 4 + static_cast<std::size_t>(k), std::move(*way)};
      }
    }
    return nearest.from(from);
  }
  Params p_;
};

}  // namespace

PlannerInfo stc() {
  return describe<Stc, Params>(
      {.name = "stc",
       .family = "grid",
       .title = "spanning tree coverage, offline",
       .citation = "Gabriely & Rimon 2001",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "each sub-cell of the wholly free coarse cells exactly once, in a closed round",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side D of a sub-cell, metres; 0: tool width / sqrt 2"},
           {"tree", &Params::tree, Choices{"bfs", "dfs", "minimum-turn", "random", "weighted"}, "how the tree grows"},
           {"components", &Params::components, Choices{"all", "start"},
            "start: only the free cells connected to the first one, as published; all: then the other parts"},
           {"align", &Params::align, Choices{"axes", "edges"},
            "edges: turn the grid to the direction most walls run in"},
           {"shift_x", &Params::shift_x, Range{-1, 1}, "shift of the grid, in cells"},
           {"shift_y", &Params::shift_y, Range{-1, 1}, "shift of the grid, in cells"}}});
}

}  // namespace oxturn

// Spanning tree coverage with loops round obstacles and border, so that what the coarse cells leave there is swept too.
//
// Source      slides "Improving Coverage" (seed improving-spanning-tree-coverage); the tree below it is `stc`'s
// Model       grid of coarse cells 2D x 2D and polygonal walls, offline, disc footprint
// Guarantee   what `stc` sweeps is swept; every stretch of a loop that the robot can drive is driven; the path is one
//             round of a tree, closed
// Complexity  n sub-cells and nodes: O(n), and a way for each piece that sees no vertex nearby (branch_tree.hpp)
// Decisions   1. The slides offset the map's walls, so this does, too; whatever of a loop is not in configuration space is
//                invalid: a node that is outside, or an edge of which goes outside. That holds for the loop's own
//                obstacle as well (notches narrower than the robot, walls traced from pixels).
//             2. The slides' epsilon 0.01 has no unit; here it is a share of the radius. As 0.01 m it leaves a strip bare
//                that alone is 2 % of a narrow corridor (the slides' reading on a robot of 0.2 m: epsilon = 0.05). It is
//                at least twice the chord error of configuration space (w / 500).
//             3. The slides' arccos is right at convex corners only; see bisector_nodes.hpp, also for sharp corners.
//             4. d_node is not given: default D.
//             5. A loop begins at the first corner; if it touches itself there, it is cut in two, as the slides' walk
//                ends where it meets the start's coordinates.
//             6. The round passes the four sub-cell centres about a coarse cell, never its centre. So a branch hangs on the
//                nearest visible sub-cell centre of the round (or node of a branch hung before), and is an excursion
//                from there: all of it lies in configuration space.
//             7. No vertex visible: by a way to one, whose corners become vertices (reported as `branches_by_path`). The
//                parts of coarse cells that `stc` drives one after another hang on the tree likewise, so there is one
//                tree; each is hung where it is nearest to what is in the tree.
//             8. No coarse cell fits: the tree is the start alone, and loops hang on it.
//             9. One lap along the walls leaves bands up to 2D wide bare between it and the coarse cells. `fill = none` is
//                the slides; `cells` (ours) also hangs every free sub-cell that is not yet swept as a branch of one
//                node; `spots`, the default, goes on to what is left about sub-cells whose centre is in a wall, and
//                where loops are broken. Swept is looked up on a lattice of D / 4.
//            10. `close_loops = true`, the default, drives an unbroken loop round once; false is the slides' tree walk, there
//                and back.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/uncovered_samples.hpp"
#include "algorithms/grid/bisector_nodes.hpp"
#include "algorithms/grid/branch_tree.hpp"
#include "algorithms/grid/coarse_components.hpp"
#include "algorithms/grid/node_loops.hpp"
#include "algorithms/grid/component_order.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string tree = "bfs";
  std::string components = "all";
  std::string align = "axes";
  double shift_x = 0, shift_y = 0;
  double epsilon = 0.01;
  double miter_limit = 2;
  double d_node = 0;
  std::string fill = "spots";
  bool close_loops = true;
};

/// The walls of the room that the robot is in, free space at their right.
std::vector<Ring> walls_of(const Problem& problem) {
  const Point inside = problem.configuration_space().polygons.front().outer.front();
  std::vector<Ring> walls;
  for (const Polygon& polygon : problem.map().free.polygons) {
    if (problem.map().free.polygons.size() > 1 && !contains(Region{{polygon}}, inside)) continue;
    for_each_ring(Region{{polygon}}, [&](const Ring& ring) { walls.emplace_back(ring.rbegin(), ring.rend()); });
  }
  return walls;
}

/// Crosses of the given size, for pictures.
std::vector<Polyline> crosses(const std::vector<Point>& points, double size) {
  std::vector<Polyline> lines;
  for (const Point& p : points) {
    lines.push_back({p - Point(size, size), p + Point(size, size)});
    lines.push_back({p - Point(size, -size), p + Point(size, -size)});
  }
  return lines;
}

class StcLoops final : public CoveragePlanner {
 public:
  explicit StcLoops(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const double side = cell_side(p_.cell_size, problem.robot());
    const GridGraph fine = make_grid_graph(problem, {p_.cell_size, p_.align, p_.shift_x, p_.shift_y}, side, 2);
    CoarseCells cells(fine);
    LatticePaths ways(fine, problem.walls());
    BranchTree tree(problem, side, ways);
    PathBuilder path(problem.start());
    Figures figures;
    const std::vector<bool> in_tree = attach_parts(problem, fine, cells, ways, tree, path, figures, context);
    attach_chains(make_chains(problem, side, figures, context), tree, figures, context);
    if (p_.fill != "none") fill(problem, fine, cells, in_tree, tree, figures, context);
    path.drive(tree.way_round(), true);
    if (path.at() == problem.start() && tree.vertices().size() < 2)
      throw Infeasible("neither a coarse cell nor a node of a loop fits; a smaller cell_size may");

    if (context.wants_traces()) {
      std::vector<Polyline> merged = tree_lines(cells);
      for (const auto& [a, b] : tree.edges()) merged.push_back({tree.vertices()[a], tree.vertices()[b]});
      context.trace("merged tree", std::move(merged));
    }
    context.record("loops", figures.loops);
    context.record("broken_loops", figures.broken);
    context.record("chains", figures.chains);
    context.record("branches_by_path", figures.by_path);
    context.record("branches_lost", figures.lost);
    context.record("fill_places", figures.places);
    return path.take();
  }

 private:
  struct Figures {
    int loops = 0, broken = 0, chains = 0, by_path = 0, lost = 0, places = 0;
  };

  static bool hang(BranchTree& tree, const Polyline& piece, BranchTree::Kind kind, Figures& figures) {
    const BranchTree::Hung how = tree.hang(piece, kind);
    figures.by_path += how == BranchTree::Hung::by_path;
    figures.lost += how == BranchTree::Hung::not_at_all;
    return how != BranchTree::Hung::not_at_all;
  }

  // The part that stc begins with is where the robot drives from its start; of the others always the one nearest to the
  // tree comes next. Tells which cells the tree has.
  std::vector<bool> attach_parts(const Problem& problem, const GridGraph& fine, CoarseCells& cells, LatticePaths& ways,
                               BranchTree& tree, PathBuilder& path, Figures& figures, Context& context) const {
    std::vector<bool> in_tree(cells.size(), false);
    const CoarseParts parts = parts_of(cells);
    std::vector<bool> hung(static_cast<std::size_t>(parts.count), false);
    PartOrder order(problem, fine, cells, parts, ways);
    TreeGrower grower(cells, p_.tree, context.rng());
    const auto attach_part = [&](const PartOrder::Entry& entry) {
      grower.grow(entry.coarse);
      const Polyline round = round_tree(fine, cells, entry.i, entry.j, true);
      if (tree.vertices().empty())
        tree.begin(round, BranchTree::Kind::round);
      else if (!hang(tree, round, BranchTree::Kind::round, figures))
        return;
      hung[static_cast<std::size_t>(parts.of[entry.coarse])] = true;
    };
    std::optional<PartOrder::Entry> entry = order.first();
    if (entry) path.drive(entry->way, false);
    while (entry && !context.cancelled()) {
      attach_part(*entry);
      if (p_.components == "start") break;
      for (const PartOrder::Entry& other : order.branches()) {
        if (context.cancelled()) break;
        attach_part(other);
      }
      entry = order.next(problem.start());
    }
    if (tree.vertices().empty()) tree.begin({problem.start()}, BranchTree::Kind::chain);
    for (std::size_t c = 0; c < cells.size(); ++c)
      in_tree[c] = parts.of[c] >= 0 && hung[static_cast<std::size_t>(parts.of[c])];
    if (context.wants_traces()) context.trace("spanning tree", tree_lines(cells));
    return in_tree;
  }

  // The slides' steps up to the connected components.
  std::vector<NodeChain> make_chains(const Problem& problem, double side, Figures& figures, Context& context) const {
    const double radius = problem.robot().radius;
    const double offset = radius + std::max(p_.epsilon * radius, problem.robot().tool_width / 500);
    const double d_node = p_.d_node > 0 ? p_.d_node : side;
    const EdgeIndex& space = problem.walls();
    std::vector<NodeChain> chains;
    std::vector<Polyline> bisectors, whole, broken;
    std::vector<Point> valid_nodes, invalid;
    for (const Ring& wall : walls_of(problem)) {
      if (context.cancelled()) break;
      std::vector<Point> corners;
      for (const BisectorNode& node : bisector_nodes(wall, offset, p_.miter_limit)) {
        corners.push_back(node.at);
        if (context.wants_traces()) bisectors.push_back({node.corner, node.at});
      }
      for (const NodeLoop& loop : node_loops(corners, d_node)) {
        std::vector<bool> out(loop.at.size(), false);
        for (std::size_t k = 0; k + 1 < loop.at.size(); ++k)
          if (!space.contains(loop.at[k], loop.at[k + 1])) out[k] = out[k + 1] = true;
        out.front() = out.back() = out.front() || out.back();  // one place
        const std::vector<std::size_t> bad = invalid_nodes(loop, 0, [&](std::size_t k) { return out[k]; });
        ++figures.loops;
        figures.broken += !bad.empty();
        for (NodeChain& chain : chains_of(loop, bad)) chains.push_back(std::move(chain));
        if (!context.wants_traces()) continue;
        whole.push_back(loop.at);
        for (std::size_t k = 0; k < loop.at.size(); ++k) (out[k] ? invalid : valid_nodes).push_back(loop.at[k]);
      }
    }
    if (context.wants_traces()) {
      context.trace("bisectors", std::move(bisectors));
      context.trace("all loops", std::move(whole));
      context.trace("nodes", crosses(valid_nodes, side / 10));
      context.trace("invalid nodes", crosses(invalid, side / 10));
      for (const NodeChain& chain : chains) broken.push_back(chain.nodes);
      context.trace("broken loops", std::move(broken));
    }
    return chains;
  }

  void attach_chains(const std::vector<NodeChain>& chains, BranchTree& tree, Figures& figures, Context& context) const {
    figures.chains = static_cast<int>(chains.size());
    for (const NodeChain& chain : chains) {
      if (context.cancelled()) return;
      const auto kind = !chain.closed    ? BranchTree::Kind::chain
                        : p_.close_loops ? BranchTree::Kind::round
                                         : BranchTree::Kind::loop;
      hang(tree, chain.nodes, kind, figures);
    }
  }

  // Decision 9.
  void fill(const Problem& problem, const GridGraph& fine, const CoarseCells& cells, const std::vector<bool>& in_tree,
            BranchTree& tree, Figures& figures, Context& context) const {
    const double reach = problem.robot().tool_width / 2;
    UncoveredSamples samples(fine, problem.map().free, reach);
    const auto note = [&] { tree.for_each_new_segment([&](const Point& a, const Point& b) { samples.sweep(a, b); }); };
    note();
    if (tree.vertices().size() == 1) samples.sweep(tree.vertices().front(), tree.vertices().front());
    const EdgeIndex& space = problem.walls();

    // The place from which a bare point is swept; nullopt: it is no target.
    const auto place_for = [&](const Point& q) -> std::optional<Point> {
      if (space.contains(q)) return q;
      const auto hit = space.nearest(q, reach * (1 - 1e-3));
      if (!hit) return std::nullopt;
      return space.contains(hit->point) ? std::optional<Point>(hit->point) : inner_point(space, hit->point, problem);
    };
    const auto visit = [&](const Point& place) {
      ++figures.places;
      hang(tree, {place}, BranchTree::Kind::chain, figures);
      note();
    };
    for (int j = -1; j <= fine.rows(); ++j) {
      if (context.cancelled()) return;
      for (int i = -1; i <= fine.columns(); ++i) {
        if (fine.inside(i, j) && in_tree[cells.at(i / 2, j / 2)]) continue;
        if (!samples.any_uncovered(i, j)) continue;
        bool centre_tried = !fine.free(i, j);
        for (int k = 0; k < UncoveredSamples::kPerCell; ++k) {
          if (!samples.bare(i, j, k)) continue;
          std::optional<Point> place = place_for(samples.place(i, j, k));
          if (!place) continue;
          if (!centre_tried) {
            centre_tried = true;
            visit(fine.centre(i, j));
            if (!samples.bare(i, j, k)) continue;
          }
          if (p_.fill == "spots") visit(*place);
        }
      }
    }
  }

  // A place on the border of configuration space is outside it by rounding as often as not: a hair further in.
  static std::optional<Point> inner_point(const EdgeIndex& space, const Point& p, const Problem& problem) {
    const double hair = problem.robot().tool_width / 1000;
    for (int k = 0; k < 16; ++k) {
      const Point q = p + hair * Point(std::cos(k * kPi / 8), std::sin(k * kPi / 8));
      if (space.contains(q)) return q;
    }
    return std::nullopt;
  }
  Params p_;
};

}  // namespace

PlannerInfo stc_loops() {
  return describe<StcLoops, Params>(
      {.name = "stc-loops",
       .family = "grid",
       .title = "spanning tree coverage with loops round obstacles",
       .citation = "slides \"Improving Coverage\", after Gabriely & Rimon 2001",
       .capabilities = {Capability::holes},
       .guarantee = "what stc sweeps, and one lap along every wall that the robot can follow",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side D of a sub-cell, metres; 0: tool width / sqrt 2"},
           {"tree", &Params::tree, Choices{"bfs", "dfs", "minimum-turn", "random", "weighted"}, "how the tree grows"},
           {"components", &Params::components, Choices{"all", "start"},
            "start: only the free coarse cells connected to the first one; all: the other parts hang on the tree"},
           {"align", &Params::align, Choices{"axes", "edges"},
            "edges: turn the grid to the direction most walls run in"},
           {"shift_x", &Params::shift_x, Range{-1, 1}, "shift of the grid, in cells"},
           {"shift_y", &Params::shift_y, Range{-1, 1}, "shift of the grid, in cells"},
           {"epsilon", &Params::epsilon, Range{0, 1}, "how much farther than the radius loops keep off, in radii"},
           {"miter_limit", &Params::miter_limit, Range{1, 100},
            "sharp corners are cut where their node would lie farther off, in offsets"},
           {"d_node", &Params::d_node, Range{0, 1000}, "longest gap between nodes, metres; 0: cell_size"},
           {"fill", &Params::fill, Choices{"spots", "cells", "none"},
            "what is hung on the tree beside the loops: none (the slides), bare sub-cells, bare spots as well"},
           {"close_loops", &Params::close_loops,
            "drive unbroken loops round once; false: there and back, as the tree is walked on the slides"}}});
}

}  // namespace oxturn

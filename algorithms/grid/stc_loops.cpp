// Spanning tree coverage with loops around obstacles and boundary, which cover what the coarse cells leave there.
//
// Source      "Improving Spanning Tree Coverage" (lecture slides); the tree below is that of `stc`
// Model       grid of coarse cells 2D x 2D and polygonal walls, offline, disc footprint
// Guarantee   what `stc` covers is covered; every part of a loop that the robot can drive is driven; the path is one
//             closed round of a tree
// Complexity  n sub-cells and nodes: O(n log n), and a path for each piece that sees no vertex nearby (branch_tree.hpp)
// Decisions   1. The source offsets the map's walls, and so does this. The parts of a loop outside configuration space
//                are invalid: nodes outside, and both nodes of an edge that leaves it. This also holds for the loop's
//                own obstacle (notches narrower than the robot, walls traced from pixels).
//             2. The source's epsilon of 0.01 has no unit; here it is a share of the radius. As 0.01 m on a robot of
//                0.2 m (epsilon = 0.05, the source's reading) it leaves a strip uncovered that alone is 2 % of a narrow
//                corridor. It is at least twice the chord error of configuration space (w / 500).
//             3. The source's arccos is right at convex vertices only; see wall_loops.hpp, also for sharp vertices.
//             4. d_node is not given in the source: default D.
//             5. A loop begins at its first vertex. If it touches itself there, it is cut into two, because the
//                source's walk ends where it meets the start's coordinates.
//             6. The path passes the four sub-cell centres around a coarse cell's centre, never that centre. So a
//                branch is attached to the nearest visible sub-cell centre of the path (or node of an earlier branch),
//                and is an excursion from there: all of it lies in configuration space.
//             7. Where no vertex is visible, a path leads to one, and its own vertices join the tree (recorded as
//                `branches_by_path`). The components of coarse cells, which `stc` drives one after the other, are
//                attached likewise, so there is one tree; each is attached where it is nearest to the tree so far.
//             8. If no coarse cell fits, the tree is the start alone, and loops are attached to it.
//             9. One lap along the walls leaves bands up to 2D wide uncovered between it and the coarse cells. `fill =
//                none` is the source. `cells` (ours) also attaches the free sub-cells that are not yet covered, as
//                chains from one to the next (uncovered_chains.hpp). `spots`, the default, continues with what is left
//                around sub-cells whose centre is in a wall, and where loops are broken. Coverage is looked up on a
//                lattice of D / 4.
//            10. `close_loops = true`, the default, drives an unbroken loop around once; false is the source' walk of
//                the tree, there and back.
#include <algorithm>
#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/branch_tree.hpp"
#include "algorithms/grid/component_order.hpp"
#include "algorithms/grid/uncovered_chains.hpp"
#include "algorithms/grid/wall_loops.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/lattice/spanning_trees.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

enum class Fill { spots, cells, none };

struct Params : TreeOptions {
  double epsilon = 0.01;
  double miter_limit = 2;
  double d_node = 0;
  Fill fill = Fill::spots;
  bool close_loops = true;
};

/// The walls of the room that the robot is in, with free space on their right.
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

/// The source's steps from the walls to the connected components of the loops.
class Loops {
 public:
  Loops(const Params& p, const Problem& problem, double side, Context& context)
      : p_(p), problem_(problem), side_(side), context_(context) {
    const double radius = problem.robot().radius;
    const double offset = radius + std::max(p.epsilon * radius, problem.robot().tool_width / 500);
    for (const Ring& wall : walls_of(problem)) {
      if (context.cancelled()) break;
      add_loops(bisector_nodes(wall, offset, p.miter_limit));
    }
    if (context.wants_traces()) trace();
  }

  const std::vector<NodeChain>& chains() const { return chains_; }
  int count() const { return count_; }
  int broken() const { return broken_; }

 private:
  void add_loops(const std::vector<BisectorNode>& around_wall) {
    std::vector<Point> vertices;
    for (const BisectorNode& node : around_wall) {
      vertices.push_back(node.at);
      if (context_.wants_traces()) bisectors_.push_back({node.vertex, node.at});
    }
    for (const Polyline& loop : node_loops(vertices, p_.d_node > 0 ? p_.d_node : side_)) {
      const std::vector<bool> outside = nodes_outside(loop);
      ++count_;
      broken_ += std::find(outside.begin(), outside.end(), true) != outside.end();
      for (NodeChain& chain : chains_of(loop, outside)) chains_.push_back(std::move(chain));
      if (!context_.wants_traces()) continue;
      whole_.push_back(loop);
      for (std::size_t k = 0; k < loop.size(); ++k) (outside[k] ? invalid_ : valid_).push_back(loop[k]);
    }
  }

  /// Decision 1.
  std::vector<bool> nodes_outside(const Polyline& loop) const {
    std::vector<bool> outside(loop.size(), false);
    for (std::size_t k = 0; k + 1 < loop.size(); ++k)
      if (!problem_.walls().contains(loop[k], loop[k + 1])) outside[k] = outside[k + 1] = true;
    outside.front() = outside.back() = outside.front() || outside.back();  // the same point
    return outside;
  }

  void trace() {
    std::vector<Polyline> broken;
    for (const NodeChain& chain : chains_) broken.push_back(chain.nodes);
    context_.trace("bisectors", std::move(bisectors_));
    context_.trace("all loops", std::move(whole_));
    context_.trace("nodes", crosses(valid_, side_ / 10));
    context_.trace("invalid nodes", crosses(invalid_, side_ / 10));
    context_.trace("broken loops", std::move(broken));
  }

  const Params& p_;
  const Problem& problem_;
  double side_;
  Context& context_;
  std::vector<NodeChain> chains_;
  int count_ = 0, broken_ = 0;
  std::vector<Polyline> bisectors_, whole_;  // for pictures
  std::vector<Point> valid_, invalid_;
};

/// What the tool covers along a line, without its round ends.
void add_swath(const Polyline& line, double tool_width, std::vector<Region>& parts) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Point &a = line[k - 1], &b = line[k];
    const Point along = (b - a).normalized(), left = tool_width / 2 * Point(-along.y(), along.x());
    parts.push_back({{{{a - left, b - left, b + left, a + left}, {}}}});
  }
}

/// One run of the planner.
class StcWithLoops {
 public:
  StcWithLoops(const Params& p, const Problem& problem, Context& context)
      : p_(p),
        problem_(problem),
        context_(context),
        side_(p.side(problem.robot())),
        fine_(p.lattice(problem, 2)),
        cells_(fine_),
        paths_(fine_, problem.walls()),
        tree_(problem, side_, paths_),
        in_tree_(cells_.size(), false),
        path_(problem.start()) {}

  Path run() {
    attach_components();
    const Loops loops(p_, problem_, side_, context_);
    attach_chains(loops.chains());
    if (p_.fill != Fill::none) fill();
    path_.drive(tree_.path_around(), true);
    if (path_.at() == problem_.start() && tree_.vertices().size() < 2)
      throw Infeasible("neither a coarse cell nor a node of a loop fits; a smaller cell_size may");
    if (context_.wants_promise()) promise(loops.chains());
    if (context_.wants_traces()) trace_merged_tree();
    context_.record("loops", loops.count());
    context_.record("broken_loops", loops.broken());
    context_.record("chains", static_cast<double>(loops.chains().size()));
    context_.record("branches_by_path", by_path_);
    context_.record("branches_lost", lost_);
    context_.record("fill_points", fill_points_);
    return path_.take();
  }

 private:
  void attach(const Polyline& piece, BranchTree::Kind kind) {
    const BranchTree::Attached how = tree_.attach(piece, kind);
    by_path_ += how == BranchTree::Attached::by_path;
    lost_ += how == BranchTree::Attached::not_at_all;
  }

  /// The robot drives from its start to the component that stc begins with; of the others, always the one nearest to
  /// the tree comes next.
  void attach_components() {
    const ConnectedComponents components = components_of(cells_);
    std::vector<bool> attached(static_cast<std::size_t>(components.count), false);
    ComponentOrder order(problem_, fine_, cells_, components, paths_);
    TreeGrower grower(cells_, p_.tree, context_.rng());
    const auto attach_component = [&](const ComponentOrder::Entry& entry) {
      grower.grow(entry.coarse);
      const Polyline round = round_tree(fine_, cells_, entry.at, RoundPoints::at_every_cell);
      if (tree_.vertices().empty())
        tree_.begin(round, BranchTree::Kind::round);
      else
        by_path_ += tree_.attach(round, BranchTree::Kind::round, entry.path) == BranchTree::Attached::by_path;
      attached[static_cast<std::size_t>(components.of[entry.coarse])] = true;
    };
    if (const std::optional<ComponentOrder::Entry> root = order.first()) {
      path_.drive(root->path, false);
      first_ = Cell{root->at.i & ~1, root->at.j & ~1};
      attach_component(*root);
      if (p_.components == Components::all)
        for (const ComponentOrder::Entry& branch : order.branches()) {
          if (context_.cancelled()) break;
          attach_component(branch);
        }
    }
    if (tree_.vertices().empty()) tree_.begin({problem_.start()}, BranchTree::Kind::chain);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      in_tree_[c] = components.of[c] >= 0 && attached[static_cast<std::size_t>(components.of[c])];
    if (context_.wants_traces()) context_.trace("spanning tree", tree_lines(cells_));
  }

  void attach_chains(const std::vector<NodeChain>& chains) {
    const BranchTree::Kind unbroken = p_.close_loops ? BranchTree::Kind::round : BranchTree::Kind::loop;
    for (const NodeChain& chain : chains) {
      if (context_.cancelled()) return;
      attach(chain.nodes, chain.closed ? unbroken : BranchTree::Kind::chain);
    }
  }

  /// Decision 9.
  void fill() {
    UncoveredSamples samples(fine_, problem_.map().free, problem_.robot().tool_width / 2);
    cover_new_segments(samples);
    if (tree_.vertices().size() == 1) samples.cover(tree_.vertices().front(), tree_.vertices().front());
    UncoveredChains chains(problem_, fine_, samples,
                           p_.fill == Fill::spots ? UncoveredChains::From::anywhere : UncoveredChains::From::centres);
    for (int j = -1; j <= fine_.rows(); ++j) {
      if (context_.cancelled()) return;
      for (int i = -1; i <= fine_.columns(); ++i) {
        if (fine_.inside(i, j) && in_tree_[cells_.at(i / 2, j / 2)]) continue;
        while (const std::optional<NodeChain> chain = chains.from(i, j)) {
          fill_points_ += static_cast<int>(chain->nodes.size()) - chain->closed;
          attach(chain->nodes, chain->closed ? BranchTree::Kind::round : BranchTree::Kind::chain);
          cover_new_segments(samples);
        }
      }
    }
  }
  void cover_new_segments(UncoveredSamples& samples) {
    tree_.for_each_new_segment([&](const Point& a, const Point& b) { samples.cover(a, b); });
  }

  void promise(const std::vector<NodeChain>& chains) {
    std::vector<Polyline> laps;
    for (const NodeChain& chain : chains) laps.push_back(chain.nodes);
    const double width = problem_.robot().tool_width;
    context_.promise([fine = fine_, first = first_, components = p_.components, laps = std::move(laps), width] {
      std::vector<Region> parts;
      if (first) parts.push_back(squares_of(fine, coarse_sub_cells(fine, components, *first), width));
      for (const Polyline& lap : laps) add_swath(lap, width, parts);
      return unite(parts);
    });
  }

  void trace_merged_tree() {
    std::vector<Polyline> merged = tree_lines(cells_);
    for (const auto& [a, b] : tree_.edges()) merged.push_back({tree_.vertices()[a], tree_.vertices()[b]});
    context_.trace("merged tree", std::move(merged));
  }

  const Params& p_;
  const Problem& problem_;
  Context& context_;
  double side_;
  GridGraph fine_;
  CoarseCells cells_;
  LatticePaths paths_;
  BranchTree tree_;
  std::vector<bool> in_tree_;  // coarse cells
  std::optional<Cell> first_;  // the lower left sub-cell of the coarse cell that the tree begins with
  PathBuilder path_;
  int by_path_ = 0, lost_ = 0, fill_points_ = 0;
};

Path plan(const Params& p, const Problem& problem, Context& context) { return StcWithLoops(p, problem, context).run(); }

}  // namespace

PlannerInfo stc_loops() {
  return describe<Params, plan>(
      {.name = "stc-loops",
       .family = "grid",
       .title = "spanning tree coverage with loops around obstacles",
       .citation = "Improving Spanning Tree Coverage (lecture slides), after Gabriely & Rimon 2001",
       .capabilities = {Capability::holes},
       .guarantee = "what stc covers, and one lap along every wall that the robot can follow",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_tree_options<Params>(
           {{"epsilon", &Params::epsilon, Range{0, 1},
             "how much farther off the walls than the radius loops run, in radii"},
            {"miter_limit", &Params::miter_limit, Range{1, 100},
             "sharp vertices are cut where their node would lie farther off, in offsets"},
            {"d_node", &Params::d_node, Range{0, 1000}, "longest gap between nodes, metres; 0: cell_size"},
            {"fill", &Params::fill, Choices{"spots", "cells", "none"},
             "what the tree gets besides the loops: none (as published); uncovered sub-cells; uncovered spots as well"},
            {"close_loops", &Params::close_loops,
             "drive unbroken loops around once; false: there and back (as published)"}}),
       .published = {{"components", "start"}, {"epsilon", 0.05}, {"fill", "none"}, {"close_loops", false}}});
}

}  // namespace oxturn

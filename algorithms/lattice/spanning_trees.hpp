/// Spanning trees of coarse cells: how they grow, and the parameters that choose it.
///
///   struct Params : TreeOptions {};
///   CoarseCells cells(p_.lattice(problem, 2));
///   TreeGrower grower(cells, p_.tree, context.rng());
///   grower.grow(root);                        // the tree of the component that contains `root`
///
/// All components O(cells), `weighted` O(cells log cells).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algorithms/lattice/coarse_cells.hpp"
#include "algorithms/lattice/grid_options.hpp"
#include "base/disjoint_sets.hpp"
#include "base/graph_search.hpp"
#include "base/random.hpp"

namespace oxturn {

enum class TreeKind {
  bfs,           // breadth-first, neighbours counter-clockwise from east
  dfs,           // depth-first, in the same order
  minimum_turn,  // depth-first, straight on while possible
  random,        // depth-first, in random order
  weighted       // minimum spanning tree in which vertical edges cost more: long horizontal lanes
};

struct TreeOptions : GridOptions {
  TreeKind tree = TreeKind::bfs;
  Components components = Components::all;
};
template <class P>
std::vector<Parameter<P>> with_tree_options(std::vector<Parameter<P>> own) {
  std::vector<Parameter<P>> all{
      {"tree", &P::tree, Choices{"bfs", "dfs", "minimum-turn", "random", "weighted"}, "how the spanning tree grows"},
      components_line<P>()};
  all.insert(all.end(), own.begin(), own.end());
  return with_grid_options<P>(std::move(all));
}

/// The connected components of the free coarse cells.
ConnectedComponents components_of(const CoarseCells& cells);

/// Grows a tree depth-first without recursion, for a million cells make a deep one. `kind` decides in which order the
/// directions are tried; each has `edges_per_side` candidates. try_link(node, direction, k) links candidate k and
/// returns the node beyond, or nullopt.
template <class Node, class TryLink>
void grow_depth_first(const Node& root, TreeKind kind, Rng& rng, int edges_per_side, TryLink try_link) {
  struct Visit {
    Node node;
    std::array<Direction, 4> order;
    int next;  // candidate
  };
  const auto order_from = [&](Direction came) {
    std::array<Direction, 4> order = kAllDirections;
    if (kind == TreeKind::minimum_turn) order = {came, left_of(came), right_of(came), opposite(came)};
    if (kind == TreeKind::random) rng.shuffle(order);
    return order;
  };
  std::vector<Visit> stack{{root, order_from(kEast), 0}};
  while (!stack.empty()) {
    Visit& top = stack.back();
    if (top.next == 4 * edges_per_side) {
      stack.pop_back();
      continue;
    }
    const Direction d = top.order[static_cast<std::size_t>(top.next / edges_per_side)];
    const int k = top.next++ % edges_per_side;
    if (const std::optional<Node> beyond = try_link(top.node, d, k)) stack.push_back({*beyond, order_from(d), 0});
  }
}

/// Links one component after another to trees.
class TreeGrower {
 public:
  /// Both must outlive it.
  TreeGrower(CoarseCells& cells, TreeKind kind, Rng& rng);
  /// Links the component that contains `root`, once. O(cells of the component), `weighted` with a sort.
  void grow(std::size_t root);

 private:
  void grow_weighted(std::size_t root);
  CoarseCells& cells_;
  TreeKind kind_;
  Rng& rng_;
  DisjointSets joined_;      // weighted: cells that are in one tree
  std::vector<bool> taken_;  // weighted: cells of components grown so far
};

}  // namespace oxturn

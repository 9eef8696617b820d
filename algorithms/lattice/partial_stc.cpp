#include "algorithms/lattice/partial_stc.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/lattice/linked_rounds.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/lattice/sub_cell_tree.hpp"
#include "algorithms/transit/component_links.hpp"

namespace oxturn {
namespace {

struct Passable {
  const GridGraph* fine;
  bool operator()(const Cell& c, Direction d) const { return fine->passable(c, d); }
};
using Tree = SubCellTree<Passable>;

/// The two sub-cells on side d of a coarse cell, counter-clockwise.
std::array<Cell, 2> on_side(const Cell& base, Direction d) {
  Cell first = base;
  if (d == kEast || d == kNorth) first = neighbour(first, kEast);
  if (d == kNorth || d == kWest) first = neighbour(first, kNorth);
  return {first, neighbour(first, left_of(d))};
}

/// Links the node beyond candidate k (0 or 1) on side d of a coarse cell, and returns the lower left sub-cell of its
/// coarse cell; nullopt if c is not in the tree, or the node beyond cannot be reached or is in the tree.
std::optional<Cell> try_link(Tree& tree, const Cell& base, Direction d, int k) {
  const Cell c = on_side(base, d)[static_cast<std::size_t>(k)], beyond = neighbour(c, d);
  if (!tree.contains(c) || !tree.passable(c, d) || tree.contains(beyond)) return std::nullopt;
  tree.link(c, d);
  return tree.base(beyond);
}

void grow_breadth_first(Tree& tree, const Cell& root) {
  std::vector<Cell> queue{tree.base(root)};
  breadth_first(queue, [&](const Cell& base, const auto& reach) {
    for (const Direction d : kAllDirections)
      for (const int k : {0, 1})
        if (const auto beyond = try_link(tree, base, d, k)) reach(*beyond);
  });
}

/// The connected components of the free sub-cells.
struct SubCellComponents {
  std::vector<int> of;
  std::vector<std::vector<Cell>> cells;  // breadth-first from the component's lowest sub-cell

  explicit SubCellComponents(const GridGraph& fine) : of(fine.size(), -1) {
    for (std::size_t node = 0; node < fine.size(); ++node) {
      const Cell first = fine.cell(node);
      if (!fine.free(first) || of[node] >= 0) continue;
      const int number = static_cast<int>(cells.size());
      std::vector<Cell> component{first};
      of[node] = number;
      breadth_first(component, [&](const Cell& at, const auto& reach) {
        for (const Direction d : kAllDirections) {
          const Cell c = neighbour(at, d);
          if (!fine.passable(at, d) || of[fine.at(c)] >= 0) continue;
          of[fine.at(c)] = number;
          reach(c);
        }
      });
      cells.push_back(std::move(component));
    }
  }
};

class PartialStc {
 public:
  PartialStc(const Problem& problem, const GridGraph& fine, const TreeOptions& options, Context& context)
      : problem_(problem),
        fine_(fine),
        options_(options),
        context_(context),
        components_(fine),
        tree_(Passable{&fine}, {0, 0}),
        joined_(options.tree == TreeKind::weighted ? fine.size() : 0),
        path_(problem.start()) {}

  Path run() {
    const std::optional<Entry> entry = entry_from_start(problem_, fine_);
    if (!entry) throw Infeasible("no sub-cell is free; a smaller cell_size may help");
    promise_free_cells(context_, fine_, options_.components, entry->cell, problem_.robot().tool_width);
    if (options_.components == Components::all && components_.cells.size() > 1) find_links(entry->cell);
    std::vector<LinkedRounds::Link> links;
    for (const ComponentLinks::Link& link : links_) links.push_back({link.from, fine_.cell(link.to), &link.path});
    LinkedRounds(fine_, std::move(links), path_)
        .drive({.to = entry->cell, .path = &entry->path}, context_,
               [&](const Cell& root) { return steps_around_component(root); });
    return path_.take();
  }

 private:
  void grow_tree(const Cell& root, const std::vector<Cell>& cells) {
    tree_.add_node(root);
    if (options_.tree == TreeKind::bfs)
      grow_breadth_first(tree_, root);
    else if (options_.tree == TreeKind::weighted)
      grow_weighted(cells);
    else
      grow_depth_first(tree_.base(root), options_.tree, context_.rng(), 2,
                       [&](const Cell& base, Direction d, int k) { return try_link(tree_, base, d, k); });
  }

  // Kruskal's algorithm with two weights: horizontal edges first.
  void grow_weighted(const std::vector<Cell>& cells) {
    const auto unite = [&](const Cell& c, Direction d) {
      const Cell to = neighbour(c, d);
      return joined_.unite(fine_.at(c), fine_.at(to));
    };
    for (const Cell& c : cells)
      if (!tree_.contains(c)) tree_.add_node(c);
    for (const Cell& c : cells)
      for (const Direction d : {kEast, kNorth})
        if (tree_.inner(c, d) && tree_.open(c, d)) unite(c, d);
    for (const Direction d : {kEast, kNorth})
      for (const Cell& c : cells)
        if (!tree_.inner(c, d) && tree_.passable(c, d) && unite(c, d)) tree_.join(c, d);
  }

  void find_links(const Cell& root) {
    ComponentLinks links(problem_);
    for (const std::vector<Cell>& cells : components_.cells)
      for (const Cell& c : cells)
        if (on_boundary(c)) links.add(fine_.centre(c), components_.of[fine_.at(c)], fine_.at(c));
    links_ = links.tree(components_.of[fine_.at(root)]);
  }

  /// Grows the tree of the component that contains `root`, and goes round it.
  std::vector<Direction> steps_around_component(const Cell& root) {
    grow_tree(root, components_.cells[static_cast<std::size_t>(components_.of[fine_.at(root)])]);
    std::vector<Direction> steps;
    const auto step = [&](Direction d) {
      steps.push_back(d);
      return true;
    };
    tree_.go_round(
        root, [](const Cell&, Direction) { return false; }, step);
    context_.progress(static_cast<double>(++entered_) / static_cast<double>(components_.cells.size()));
    return steps;
  }
  bool on_boundary(const Cell& c) const {
    return std::any_of(kAllDirections.begin(), kAllDirections.end(),
                       [&](Direction d) { return !fine_.passable(c, d); });
  }

  const Problem& problem_;
  const GridGraph& fine_;
  const TreeOptions& options_;
  Context& context_;
  SubCellComponents components_;
  Tree tree_;
  DisjointSets joined_;                      // weighted: sub-cells in one tree
  std::vector<ComponentLinks::Link> links_;  // to the other components
  std::size_t entered_ = 0;                  // components
  PathBuilder path_;
};

}  // namespace

Path cover_partial_cells(const Problem& problem, const GridGraph& fine, const TreeOptions& options, Context& context) {
  return PartialStc(problem, fine, options, context).run();
}

}  // namespace oxturn

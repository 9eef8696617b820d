#include "algorithms/grid/partial_stc.hpp"

#include <algorithm>
#include <array>

#include "algorithms/grid/sub_cell_tree.hpp"
#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/transit/nearest_component.hpp"

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
    std::optional<Entry> entry = entry_from_start(problem_, fine_);
    if (!entry) throw Infeasible("no sub-cell is free; a smaller cell_size may help");
    promise_free_cells(context_, fine_, options_.components, entry->cell, problem_.robot().tool_width);
    const std::size_t count = options_.components == Components::all ? components_.cells.size() : 1;
    for (std::size_t done = 0; entry && !context_.cancelled();) {
      const Cell root = entry->cell;
      const int component = components_.of[fine_.at(root)];
      const std::vector<Cell>& cells = components_.cells[static_cast<std::size_t>(component)];
      grow_tree(root, cells);
      path_.drive(entry->path, cells.size() == 1);  // a single sub-cell is covered on arrival
      path_.drive(round(root), true);
      context_.progress(static_cast<double>(++done) / static_cast<double>(components_.cells.size()));
      if (done == count) break;
      entry = next_entry(component);
    }
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

  /// The closed path around the tree, with a point at each turn.
  Polyline round(const Cell& root) {
    Polyline line{fine_.centre(root)};
    Cell at = root;
    std::optional<Direction> last;
    const auto drive = [&](Direction d) {
      at = neighbour(at, d);
      if (last == d) line.pop_back();
      line.push_back(fine_.centre(at));
      last = d;
      return true;
    };
    tree_.go_round(
        root, [](const Cell&, Direction) { return false; }, drive);
    return line;
  }

  /// Where to enter the nearest component that is left, after `component`.
  std::optional<Entry> next_entry(int component) {
    if (!nearest_) {
      nearest_.emplace(problem_);
      for (const std::vector<Cell>& cells : components_.cells)
        for (const Cell& c : cells)
          if (on_boundary(c)) nearest_->add(fine_.centre(c), components_.of[fine_.at(c)], fine_.at(c));
    }
    nearest_->remove(component);
    auto found = nearest_->from(path_.at());
    if (!found) return std::nullopt;
    return Entry{fine_.cell(found->id), std::move(found->path)};
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
  DisjointSets joined_;  // weighted: sub-cells in one tree
  std::optional<NearestComponent> nearest_;
  PathBuilder path_;
};

}  // namespace

Path cover_partial_cells(const Problem& problem, const GridGraph& fine, const TreeOptions& options, Context& context) {
  return PartialStc(problem, fine, options, context).run();
}

}  // namespace oxturn

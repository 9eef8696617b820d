#include "algorithms/grid/partial_stc.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "algorithms/grid/sub_cell_tree.hpp"
#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/lattice/promised_cells.hpp"
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
    enter(entry->cell, entry->path);
    while (!open_.empty() && !context_.cancelled()) step();
    drive_line();
    return path_.take();
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Round {
    std::vector<Cell> cells;
    std::size_t driven;       // index of the cell where the robot is
    const Polyline* arrival;  // the path that led to the first cell
  };

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
    first_link_.assign(fine_.size(), kNone);
    next_link_.assign(links_.size(), kNone);
    for (std::size_t k = links_.size(); k-- > 0;)
      next_link_[k] = std::exchange(first_link_[links_[k].from], static_cast<std::uint32_t>(k));
  }

  /// Drives to the component that contains `root` and opens the round about its tree.
  void enter(const Cell& root, const Polyline& path) {
    const std::vector<Cell>& cells = components_.cells[static_cast<std::size_t>(components_.of[fine_.at(root)])];
    grow_tree(root, cells);
    drive_line();
    path_.drive(path, cells.size() == 1);  // a single sub-cell is covered on arrival
    open_.push_back({{root}, 0, &path});
    Cell at = root;
    const auto drive = [&](Direction d) {
      at = neighbour(at, d);
      open_.back().cells.push_back(at);
      return true;
    };
    tree_.go_round(
        root, [](const Cell&, Direction) { return false; }, drive);
    line_.assign(1, fine_.centre(root));
    context_.progress(static_cast<double>(++entered_) / static_cast<double>(components_.cells.size()));
  }

  /// Leaves for a component that is linked to the sub-cell where the robot is, or goes on to the next sub-cell of the
  /// round; at its end back to where it left the round before.
  void step() {
    Round& here = open_.back();
    const Cell at = here.cells[here.driven];
    if (const std::uint32_t k = next_branch(at); k != kNone) return enter(fine_.cell(links_[k].to), links_[k].path);
    if (here.driven + 1 < here.cells.size()) return go_on(here);
    const Polyline* arrival = here.arrival;
    open_.pop_back();
    if (open_.empty()) return;
    drive_line();
    path_.drive(Polyline(arrival->rbegin(), arrival->rend()), false);
    line_.assign(1, path_.at());
  }
  void go_on(Round& round) {
    const Cell &at = round.cells[round.driven], &to = round.cells[++round.driven];
    const bool straight = line_.size() > 1 && round.driven >= 2 &&
                          to.i - at.i == at.i - round.cells[round.driven - 2].i &&
                          to.j - at.j == at.j - round.cells[round.driven - 2].j;
    if (straight) line_.pop_back();
    line_.push_back(fine_.centre(to));
  }
  std::uint32_t next_branch(const Cell& at) {
    if (first_link_.empty()) return kNone;
    std::uint32_t& first = first_link_[fine_.at(at)];
    return first == kNone ? kNone : std::exchange(first, next_link_[first]);
  }
  void drive_line() {
    if (line_.size() > 1) path_.drive(line_, true);
    line_.clear();
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
  DisjointSets joined_;                                // weighted: sub-cells in one tree
  std::vector<ComponentLinks::Link> links_;            // to the other components
  std::vector<std::uint32_t> first_link_, next_link_;  // from each sub-cell, as linked lists
  std::vector<Round> open_;                            // rounds begun
  Polyline line_;                                      // with the tool on, not yet in the path
  std::size_t entered_ = 0;                            // components
  PathBuilder path_;
};

}  // namespace

Path cover_partial_cells(const Problem& problem, const GridGraph& fine, const TreeOptions& options, Context& context) {
  return PartialStc(problem, fine, options, context).run();
}

}  // namespace oxturn

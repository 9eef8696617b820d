#include "metrics/arm_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "metrics/level_tree.hpp"

namespace oxturn {
namespace {

// In tool widths and their squares.
constexpr double kSide = 1.0 / 8;  // of cells
constexpr double kMostCells = 250'000;
constexpr double kInterface = 0.6;                         // lost where counts and area meet, estimated
constexpr std::array kLeastOwn{0.02, 0.1, 0.4, 1.5, 6.0};  // what a component must have of its own to count
constexpr int kMostEnds = 16;                              // that get a choice of their own
constexpr double kRounding = 1e-6;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class Arms {
 public:
  Arms(const LevelCells& cells, const LevelTree& tree, double uncovered, double first)
      : cells_(cells),
        tree_(tree),
        reach_(tool_reach(cells.side)),
        uncovered_(uncovered),
        first_(first),
        beyond_(tree.slabs.size()) {
    for (std::size_t s = 0; s < tree_.slabs.size(); ++s)
      if (const std::int32_t parent = tree_.slabs[s].parent; parent != LevelTree::kNone)
        beyond_[at(parent)] += beyond_[s] + tree_.slabs[s].only;
  }

  double bound() {
    double best = 0;
    for (const double own : kLeastOwn) best = std::max(best, bound_with(own));
    return best;
  }

 private:
  using Counts = std::vector<std::int8_t>;  // by slab: how often it is crossed
  using Choice = std::vector<bool>;         // the slabs of A

  /// The least over all ends of the path; components with less than `own` beyond them do not count.
  double bound_with(double own) {
    Counts counts(tree_.slabs.size());
    for (std::size_t s = 0; s < counts.size(); ++s) counts[s] = beyond_[s] > own ? 2 : 0;
    const Choice all = chosen(counts);
    const double base = value(all, counts);
    struct End {
      double bound;
      std::size_t slab;
    };
    std::vector<End> ends;
    for (const std::size_t slab : ends_of(counts)) {
      double once = 0;
      for_each_to_start(slab, [&](std::size_t s) { once += all[s] ? tree_.slabs[s].length() : 0; });
      ends.push_back({base - once, slab});
    }
    if (ends.empty()) return 0;
    std::ranges::stable_sort(ends, {}, &End::bound);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ends.size() && ends[k].bound < least; ++k) {
      double bound = ends[k].bound;
      if (k < kMostEnds) {
        Counts once = counts;
        for_each_to_start(ends[k].slab, [&](std::size_t s) { once[s] = 1; });
        bound = std::max(bound, value(chosen(once), once));
      }
      least = std::min(least, bound);
    }
    return least;
  }

  template <class F>
  void for_each_to_start(std::size_t slab, F f) const {
    for (auto s = static_cast<std::int32_t>(slab); s != LevelTree::kNone; s = tree_.slabs[at(s)].parent) f(at(s));
  }

  /// The last slabs that count. A path that ends elsewhere ends between one of them and the start, or beyond it.
  std::vector<std::size_t> ends_of(const Counts& counts) const {
    std::vector<bool> inner(counts.size(), false);
    for (std::size_t s = 0; s < counts.size(); ++s)
      if (counts[s] > 0 && tree_.slabs[s].parent != LevelTree::kNone) inner[at(tree_.slabs[s].parent)] = true;
    std::vector<std::size_t> ends;
    for (std::size_t s = 0; s < counts.size(); ++s)
      if (counts[s] > 0 && !inner[s]) ends.push_back(s);
    return ends;
  }

  /// The slabs where counts are worth more than area, by estimates.
  Choice chosen(const Counts& counts) const {
    const std::size_t n = counts.size();
    std::vector<double> in(n, 0), out(n, 0);  // gain of the slab and all beyond it, if it is in A or not
    const auto parent = [&](std::size_t s) { return tree_.slabs[s].parent; };
    for (std::size_t s = 0; s < n; ++s) {
      in[s] += counts[s] * tree_.slabs[s].length() - tree_.slabs[s].near;
      if (parent(s) == LevelTree::kNone) continue;
      in[at(parent(s))] += std::max(in[s], out[s] - kInterface);
      out[at(parent(s))] += std::max(out[s], in[s] - kInterface);
    }
    Choice choice(n, false);
    for (std::size_t s = n; s-- > 0;) {
      const bool joins = parent(s) != LevelTree::kNone && choice[at(parent(s))];
      const double change = parent(s) == LevelTree::kNone ? 0 : kInterface;
      choice[s] = in[s] - (joins ? 0 : change) > out[s] - (joins ? change : 0);
    }
    return choice;
  }

  /// The bound with these slabs in A, certified.
  double value(const Choice& choice, const Counts& counts) {
    mark(choice);
    std::vector<double> rest_beyond(tree_.slabs.size(), 0), only_rest(tree_.slabs.size(), 0);
    double rest = 0;
    for (std::size_t p = 0; p < cells_.parts.size(); ++p) {
      if (meets(cells_.parts[p])) continue;
      rest += cells_.parts[p].area;
      if (tree_.of_part[p] != LevelTree::kNone) only_rest[at(tree_.of_part[p])] += cells_.parts[p].area;
    }
    double counted = 0, price = 1;
    std::vector<double> saved(tree_.slabs.size(), 0);  // in the slab and all beyond it
    for (std::size_t s = 0; s < tree_.slabs.size(); ++s) {
      const LevelTree::Slab& slab = tree_.slabs[s];
      const double here = choice[s] ? counts[s] * slab.length() : 0;
      counted += here;
      saved[s] += here;
      if (counts[s] > 0 && beyond_[s] <= uncovered_) price = std::max(price, (saved[s] + rest_beyond[s]) / beyond_[s]);
      if (slab.parent == LevelTree::kNone) continue;
      saved[at(slab.parent)] += saved[s];
      rest_beyond[at(slab.parent)] += rest_beyond[s] + only_rest[s];
    }
    const double first = starts_in_a_ ? 0 : first_;
    return counted + std::max(0.0, rest - first) - price * uncovered_ - kRounding;
  }

  /// Counts the cells of A, row by row from the left.
  void mark(const Choice& choice) {
    const auto columns = static_cast<std::size_t>(cells_.columns) + 1;
    starts_in_a_ = false;
    before_.assign(columns * static_cast<std::size_t>(cells_.rows), 0);
    for (std::size_t c = 0; c < cells_.cells.size(); ++c) {
      const LevelCells::Cell& cell = cells_.cells[c];
      bool found = false;
      for (auto s = tree_.of_cell[c]; s != LevelTree::kNone && !found; s = tree_.slabs[at(s)].parent) {
        found = choice[at(s)];
        if (tree_.slabs[at(s)].low <= cell.low) break;
      }
      if (found && static_cast<std::int32_t>(c) == cells_.start) starts_in_a_ = true;
      if (found) before_[static_cast<std::size_t>(cell.row) * columns + static_cast<std::size_t>(cell.column) + 1] = 1;
    }
    for (std::size_t k = 0; k < before_.size(); ++k)
      if (k % columns > 0) before_[k] += before_[k - 1];
  }
  /// Can any of the part be covered from A?
  bool meets(const LevelCells::Part& part) const {
    const int rows = static_cast<int>(reach_.size()) - 1;
    for (int j = std::max(0, part.row - rows); j <= std::min(cells_.rows - 1, part.row + rows); ++j) {
      const int columns = reach_[static_cast<std::size_t>(std::abs(j - part.row))];
      const int from = std::max(0, part.column - columns), to = std::min(cells_.columns, part.column + columns + 1);
      const std::size_t row = static_cast<std::size_t>(j) * (static_cast<std::size_t>(cells_.columns) + 1);
      if (before_[row + static_cast<std::size_t>(to)] > before_[row + static_cast<std::size_t>(from)]) return true;
    }
    return false;
  }

  const LevelCells& cells_;
  const LevelTree& tree_;
  std::vector<int> reach_;
  double uncovered_, first_;
  std::vector<double> beyond_;  // area that can only be covered from beyond a slab
  bool starts_in_a_ = false;
  std::vector<std::int32_t> before_;  // cells of A left of a column, row by row
};

}  // namespace

std::optional<double> arm_bound(const Problem& problem, double uncovered_m2, double first_m2) {
  const double width = problem.robot().tool_width;
  const auto cells = level_cells(problem, kSide, kMostCells);
  if (!cells) return std::nullopt;
  const auto tree = level_tree(*cells);
  if (!tree) return std::nullopt;
  const double square = width * width;
  const double bound = Arms(*cells, *tree, std::max(0.0, uncovered_m2) / square, first_m2 / square).bound();
  if (!(bound > 0)) return std::nullopt;
  return bound * width;
}

}  // namespace oxturn

#include "metrics/level_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/disjoint_sets.hpp"

namespace oxturn {
namespace {

constexpr double kToolRadius = 0.5;
constexpr std::int32_t kNone = LevelTree::kNone;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// The branches: nodes between the distances at which they begin, end and meet.
struct Branches {
  struct Branch {
    std::int32_t parent = kNone;  // has a higher index
    double low = 0, high = 0;
    std::int32_t first_slab = kNone, slabs = 0;
  };
  std::vector<Branch> all;
  std::vector<std::int32_t> of_cell;
};

/// Adds the cells by decreasing distance, and notes where components begin and meet.
Branches branches_of(const LevelCells& cells) {
  const std::size_t n = cells.cells.size();
  Branches result;
  result.of_cell.assign(n, kNone);
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    const double ha = cells.cells[a].high, hb = cells.cells[b].high;
    return ha != hb ? ha > hb : a < b;
  });
  DisjointSets sets(n);
  std::vector<std::int32_t> branch_of_set(n, kNone);
  for (const std::size_t c : order) {
    const LevelCells::Cell& cell = cells.cells[c];
    std::vector<std::int32_t> met;
    std::vector<std::size_t> joined;
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) {
        const std::int32_t o = cells.cell(cell.column + di, cell.row + dj);
        if (o == LevelCells::kNone || result.of_cell[at(o)] == kNone) continue;
        met.push_back(branch_of_set[sets.find(at(o))]);
        joined.push_back(at(o));
      }
    for (const std::size_t o : joined) sets.unite(c, o);
    std::ranges::sort(met);
    met.erase(std::unique(met.begin(), met.end()), met.end());
    std::int32_t branch = met.size() == 1 ? met.front() : kNone;
    if (branch == kNone) {
      branch = static_cast<std::int32_t>(result.all.size());
      for (const std::int32_t m : met) {
        result.all[at(m)].parent = branch;
        result.all[at(m)].low = std::max(0.0, cell.high);
      }
      result.all.push_back({});
      result.all.back().high = std::max(0.0, cell.high);
    }
    result.of_cell[c] = branch;
    branch_of_set[sets.find(c)] = branch;
  }
  return result;
}

void add_slabs(Branches& branches, double thickness, LevelTree& tree) {
  for (Branches::Branch& b : branches.all) {
    b.first_slab = static_cast<std::int32_t>(tree.slabs.size());
    b.slabs = std::max(1, static_cast<std::int32_t>(std::ceil((b.high - b.low) / thickness)));
    for (std::int32_t k = 0; k < b.slabs; ++k) {
      LevelTree::Slab slab;
      const auto level = [&](std::int32_t i) { return b.high + (b.low - b.high) * i / b.slabs; };
      slab.high = level(k), slab.low = level(k + 1);
      if (k > 0) tree.slabs.back().parent = b.first_slab + k;
      tree.slabs.push_back(slab);
    }
  }
  for (const Branches::Branch& b : branches.all)
    if (b.parent != kNone) tree.slabs[at(b.first_slab + b.slabs - 1)].parent = branches.all[at(b.parent)].first_slab;
}

/// The slab of a branch that holds a distance.
std::int32_t slab_at(const Branches::Branch& branch, double distance) {
  const double share = (branch.high - distance) / std::max(branch.high - branch.low, 1e-300);
  return branch.first_slab +
         std::clamp(static_cast<std::int32_t>(share * branch.slabs), std::int32_t{0}, branch.slabs - 1);
}

/// Finds the slab of each part of the target.
class Parts {
 public:
  Parts(const LevelCells& cells, const Branches& branches, LevelTree& tree)
      : cells_(cells), branches_(branches), tree_(tree), reach_(tool_reach(cells.side)) {}

  void assign() {
    tree_.of_part.reserve(cells_.parts.size());
    for (const LevelCells::Part& part : cells_.parts) {
      look_at(part);
      const std::int32_t slab = exclusive();
      tree_.of_part.push_back(slab);
      if (slab != kNone) tree_.slabs[at(slab)].only += part.area;
      if (nearest_ != kNone) tree_.slabs[at(tree_.of_cell[at(nearest_)])].near += part.area;
    }
  }

 private:
  /// At the cells from which the part can be covered.
  void look_at(const LevelCells::Part& part) {
    least_ = std::numeric_limits<double>::infinity();
    meet_ = nearest_ = kNone;
    int nearest = std::numeric_limits<int>::max();
    const int rows = static_cast<int>(reach_.size()) - 1;
    for (int dj = -rows; dj <= rows; ++dj) {
      const int columns = reach_[static_cast<std::size_t>(std::abs(dj))];
      for (int di = -columns; di <= columns; ++di) {
        const std::int32_t c = cells_.cell(part.column + di, part.row + dj);
        if (c == LevelCells::kNone) continue;
        least_ = std::min(least_, cells_.cells[at(c)].low);
        meet_ = meet_ == kNone ? branches_.of_cell[at(c)] : meeting(meet_, branches_.of_cell[at(c)]);
        if (di * di + dj * dj < nearest) nearest = di * di + dj * dj, nearest_ = c;
      }
    }
  }
  std::int32_t meeting(std::int32_t a, std::int32_t b) const {
    while (a != b) {
      std::int32_t& lower = a < b ? a : b;
      lower = branches_.all[at(lower)].parent;
      if (lower == kNone) return kNone;
    }
    return a;
  }
  /// The slab with the greatest distance beyond which, in one branch, all these cells lie.
  std::int32_t exclusive() const {
    if (meet_ == kNone || !(least_ > 0)) return kNone;
    std::int32_t branch = meet_;
    while (branches_.all[at(branch)].low >= least_) {
      branch = branches_.all[at(branch)].parent;
      if (branch == kNone) return kNone;
    }
    return slab_at(branches_.all[at(branch)], std::min(least_, branches_.all[at(branch)].high));
  }

  const LevelCells& cells_;
  const Branches& branches_;
  LevelTree& tree_;
  std::vector<int> reach_;
  double least_ = 0;
  std::int32_t meet_ = kNone, nearest_ = kNone;
};

}  // namespace

std::vector<int> tool_reach(double side) {
  const double radius = kToolRadius / side * (1 - 1e-9);
  std::vector<int> reach;
  for (int dj = 0; dj - 1 < radius; ++dj) {
    const double rows = std::max(0, dj - 1), rest = radius * radius - rows * rows;
    reach.push_back(static_cast<int>(std::ceil(std::sqrt(std::max(0.0, rest)))));
  }
  return reach;
}

std::optional<LevelTree> level_tree(const LevelCells& cells) {
  Branches branches = branches_of(cells);
  if (std::ranges::count(branches.all, kNone, &Branches::Branch::parent) != 1) return std::nullopt;
  LevelTree tree;
  add_slabs(branches, cells.side, tree);
  tree.of_cell.reserve(cells.cells.size());
  for (std::size_t c = 0; c < cells.cells.size(); ++c)
    tree.of_cell.push_back(slab_at(branches.all[at(branches.of_cell[c])], cells.cells[c].high));
  Parts(cells, branches, tree).assign();
  return tree;
}

}  // namespace oxturn

#include "algorithms/grid/component_order.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {

PartOrder::PartOrder(const Problem& problem, const GridGraph& fine, const CoarseCells& cells, const CoarseParts& parts,
                     LatticePaths& ways)
    : problem_(problem),
      fine_(fine),
      cells_(cells),
      parts_(parts),
      ways_(ways),
      done_(static_cast<std::size_t>(parts.count), false) {
  // A part hangs together over the lattice: one of its cells tells where.
  std::vector<bool> counted(done_.size(), false);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (parts.of[c] < 0 || counted[static_cast<std::size_t>(parts.of[c])]) continue;
    counted[static_cast<std::size_t>(parts.of[c])] = true;
    const auto whole = static_cast<std::size_t>(ways_.part(sub_cell(c)));
    if (left_.size() <= whole) left_.resize(whole + 1, 0);
    ++left_[whole];
  }
}

PartOrder::Entry PartOrder::entry_at(std::size_t node, Polyline way, std::size_t from) const {
  return {column(node), row(node), coarse(node), std::move(way), from};
}

std::optional<PartOrder::Entry> PartOrder::come_to(std::optional<Entry> entry) {
  if (!entry) return std::nullopt;
  at_ = fine_.at(entry->i, entry->j);
  done_[static_cast<std::size_t>(parts_.of[entry->coarse])] = true;
  --left_[static_cast<std::size_t>(ways_.part(at_))];
  if (walls_) walls_->remove(parts_.of[entry->coarse]);
  return entry;
}

std::optional<PartOrder::Entry> PartOrder::first() {
  const Point& start = problem_.start();
  std::optional<Entry> entry = under(start);
  if (!entry) entry = over_lattice(start);
  if (!entry) entry = among_walls(start);
  return come_to(std::move(entry));
}

std::optional<PartOrder::Entry> PartOrder::next(const Point& from) { return come_to(among_walls(from)); }

std::optional<PartOrder::Entry> PartOrder::under(const Point& p) const {
  const Point at = fine_.coordinates(p);
  const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
  if (!fine_.inside(i, j) || !left(fine_.at(i, j))) return std::nullopt;
  const Point to = fine_.centre(i, j);
  if (!problem_.walls().contains(p, to)) return std::nullopt;
  return entry_at(fine_.at(i, j), {p, to});
}

std::optional<PartOrder::Entry> PartOrder::over_lattice(const Point& p) {
  auto found = ways_.nearest(p, [this](std::size_t node) { return left(node); });
  if (!found) return std::nullopt;
  return entry_at(found->node, std::move(found->way));
}

std::optional<PartOrder::Entry> PartOrder::among_walls(const Point& p) {
  if (std::all_of(done_.begin(), done_.end(), [](bool done) { return done; })) return std::nullopt;
  if (!walls_) {
    walls_.emplace(problem_);
    // Only cells at the edge of their part can be where a way from another part first comes in.
    const auto on_boundary = [&](std::size_t c) {
      return std::any_of(kAllDirections.begin(), kAllDirections.end(),
                         [&](Direction d) { return !cells_.adjacent(c, d); });
    };
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (!left(sub_cell(c)) || !on_boundary(c)) continue;
      for (int k = 0; k < 4; ++k) walls_->add(ways_.place(sub_cell(c, k)), parts_.of[c], sub_cell(c, k));
    }
  }
  auto found = walls_->from(p);
  if (!found) return std::nullopt;
  return entry_at(found->id, std::move(found->path));
}

// Prim's algorithm with a bucket for each number of steps. Sub-cells of parts in the tree are where ways begin; when the
// wave meets another part, that part's sub-cells are beginnings too, and the wave goes on from there.
std::vector<PartOrder::Entry> PartOrder::branches() {
  constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> steps(fine_.size(), kFar);
  std::vector<std::uint8_t> came(fine_.size(), LatticePaths::kRoot);
  std::vector<std::vector<std::uint32_t>> buckets(1);
  std::vector<std::size_t> part;
  const auto begin_at = [&](std::size_t c) {  // a part's cells
    part.assign(1, c);
    const auto take = [&](std::size_t cell) {
      for (int k = 0; k < 4; ++k) {
        const std::size_t node = sub_cell(cell, k);
        steps[node] = 0;
        came[node] = LatticePaths::kRoot;
        buckets[0].push_back(static_cast<std::uint32_t>(node));
      }
    };
    take(c);
    for (std::size_t k = 0; k < part.size(); ++k)
      for (const Direction d : kAllDirections) {
        if (!cells_.adjacent(part[k], d)) continue;
        const std::size_t cell = cells_.neighbour(part[k], d);
        if (steps[sub_cell(cell)] == 0) continue;
        part.push_back(cell);
        take(cell);
      }
  };
  const auto whole = static_cast<std::size_t>(ways_.part(at_));
  std::vector<Entry> found;
  if (left_[whole] == 0) return found;
  begin_at(coarse(at_));
  for (std::size_t b = 0; b < buckets.size() && left_[whole] > 0;) {
    if (buckets[b].empty()) {
      ++b;
      continue;
    }
    const std::size_t at = buckets[b].back();
    buckets[b].pop_back();
    if (steps[at] < b) continue;
    bool met = false;
    for (const Direction d : kAllDirections) {
      if (!ways_.open(at, d)) continue;
      const std::size_t to = ways_.neighbour(at, d);
      if (left(to)) {
        std::vector<std::size_t> nodes = ways_.nodes_to(at, [&](std::size_t node) { return came[node]; });
        nodes.push_back(to);
        found.push_back(*come_to(entry_at(to, ways_.along(nodes), nodes.front())));
        begin_at(coarse(to));
        met = true;
      } else if (steps[to] > b + 1) {
        steps[to] = static_cast<std::uint32_t>(b + 1);
        came[to] = static_cast<std::uint8_t>(d);
        if (buckets.size() < b + 2) buckets.emplace_back();
        buckets[b + 1].push_back(static_cast<std::uint32_t>(to));
      }
    }
    if (met) b = 0;
  }
  return found;
}

}  // namespace oxturn

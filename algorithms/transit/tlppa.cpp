#include "algorithms/transit/tlppa.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr int kBlock = 8;  // fine cells a side of a coarse one
constexpr int kReach = 4;  // fine cells around a point in which its cell is searched
constexpr double kMostCells = 1 << 22;
constexpr int kSteps[8][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

}  // namespace

/// A* over the eight neighbours of the set cells in a window; allowed(from, to) tells which steps exist. Empty if there
/// is no path.
template <class Allowed>
Tlppa::Cells Tlppa::search(const BitGrid& grid, const Window& w, const Cell& from, const Cell& to,
                           SearchTree<double>& tree, Allowed allowed) {
  const auto columns = static_cast<std::size_t>(w.right - w.left + 1);
  const auto rows = static_cast<std::size_t>(w.top - w.bottom + 1);
  const auto node = [&](const Cell& c) {
    return static_cast<std::size_t>(c.j - w.bottom) * columns + static_cast<std::size_t>(c.i - w.left);
  };
  const auto cell = [&](std::size_t n) {
    return Cell{static_cast<int>(n % columns) + w.left, static_cast<int>(n / columns) + w.bottom};
  };
  const auto neighbours = [&](std::size_t at, const auto& reach) {
    const Cell c = cell(at);
    for (int k = 0; k < 8; ++k) {
      const Cell next{c.i + kSteps[k][0], c.j + kSteps[k][1]};
      if (next.i < w.left || next.i > w.right || next.j < w.bottom || next.j > w.top) continue;
      if (grid.get(next.i, next.j) && allowed(c, next)) reach(node(next), k < 4 ? 1 : std::sqrt(2.0));
    }
  };
  const auto octile_distance = [&](std::size_t at) {
    const Cell c = cell(at);
    const int dx = std::abs(c.i - to.i), dy = std::abs(c.j - to.j);
    return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
  };
  const std::size_t end = node(to);
  Cells path;
  if (a_star(
          tree, columns * rows, node(from), neighbours, [&](std::size_t at) { return at == end; }, octile_distance))
    for (const std::size_t at : tree.path_to(end)) path.push_back(cell(at));
  return path;
}

Tlppa::Tlppa(const Problem& problem, double cell) : problem_(problem) {
  const Region& space = problem.configuration_space();
  const Box box = bounding_box(space);
  const Point size = box.size();
  cell = std::max(cell, std::sqrt(size.x() * size.y() / kMostCells));
  const auto cells = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / cell))); };
  fine_ = rasterise(space, box.low, cell, cells(size.x()), cells(size.y()), CellRule::inside);
  coarse_ = BitGrid(box.low, cell * kBlock, (fine_.columns - 1) / kBlock + 1, (fine_.rows - 1) / kBlock + 1);
  for (int j = 0; j < fine_.rows; ++j)
    for (int i = 0; i < fine_.columns; ++i)
      if (fine_.get(i, j)) coarse_.set(i / kBlock, j / kBlock, true);
  corridor_of_.assign(coarse_.bits.size(), 0);
  const auto columns = static_cast<std::size_t>(fine_.columns);
  components_ = connected_components(
      fine_.bits.size(), [&](std::size_t c) { return fine_.bits[c] != 0; },
      [&](std::size_t c, const auto& reach) {
        const int i = static_cast<int>(c % columns), j = static_cast<int>(c / columns);
        for (const auto& [di, dj] : kSteps)
          if (fine_.inside(i + di, j + dj)) reach(fine_.at(i + di, j + dj));
      });
}

/// Decision 4.
std::optional<Tlppa::Cell> Tlppa::connect(const Point& p) const {
  const int i = static_cast<int>(std::floor((p.x() - fine_.origin.x()) / fine_.cell));
  const int j = static_cast<int>(std::floor((p.y() - fine_.origin.y()) / fine_.cell));
  struct Candidate {
    double distance;
    Cell cell;
  };
  std::vector<Candidate> candidates;  // row by row
  for (int y = j - kReach; y <= j + kReach; ++y)
    for (int x = i - kReach; x <= i + kReach; ++x)
      if (fine_.get(x, y)) candidates.push_back({distance(p, fine_.centre(x, y)), {x, y}});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  for (const auto& [distance, c] : candidates)
    if (problem_.walls().contains(p, fine_.centre(c.i, c.j))) return c;
  return std::nullopt;
}

/// Some free fine cell of one block has a free neighbour in the other.
bool Tlppa::step_between_blocks(const Cell& from, const Cell& to) const {
  // Fine cells of `from` on the side, or at the corner, that faces `to`.
  const auto facing = [](int block, int d) {
    return std::pair(block * kBlock + (d > 0 ? kBlock - 1 : 0), block * kBlock + (d < 0 ? 0 : kBlock - 1));
  };
  const auto [left, right] = facing(from.i, to.i - from.i);
  const auto [bottom, top] = facing(from.j, to.j - from.j);
  for (int v = bottom; v <= top; ++v)
    for (int u = left; u <= right; ++u) {
      if (!fine_.get(u, v)) continue;
      for (const auto& [di, dj] : kSteps) {
        const int a = u + di, b = v + dj;
        if (a / kBlock == to.i && b / kBlock == to.j && fine_.get(a, b)) return true;
      }
    }
  return false;
}

/// Blocks.
Tlppa::Cells Tlppa::coarse_path(const Cell& from, const Cell& to) {
  return search(coarse_, {0, 0, coarse_.columns - 1, coarse_.rows - 1}, {from.i / kBlock, from.j / kBlock},
                {to.i / kBlock, to.j / kBlock}, coarse_search_,
                [this](const Cell& a, const Cell& b) { return step_between_blocks(a, b); });
}

/// Marks the blocks of a coarse path and their neighbours for the current query; returns the window of their cells.
Tlppa::Window Tlppa::mark_corridor(const Cells& blocks) {
  ++queries_;
  Window window{fine_.columns, fine_.rows, 0, 0};
  for (const Cell& block : blocks)
    for (int y = std::max(0, block.j - 1); y <= std::min(coarse_.rows - 1, block.j + 1); ++y)
      for (int x = std::max(0, block.i - 1); x <= std::min(coarse_.columns - 1, block.i + 1); ++x) {
        corridor_of_[coarse_.at(x, y)] = queries_;
        window = {std::min(window.left, x * kBlock), std::min(window.bottom, y * kBlock),
                  std::max(window.right, x * kBlock + kBlock - 1), std::max(window.top, y * kBlock + kBlock - 1)};
      }
  window.right = std::min(window.right, fine_.columns - 1);
  window.top = std::min(window.top, fine_.rows - 1);
  return window;
}

/// Decision 3.
Tlppa::Cells Tlppa::fine_path(const Cell& from, const Cell& to) {
  if (const Cells blocks = coarse_path(from, to); !blocks.empty()) {
    const Window window = mark_corridor(blocks);
    const auto in_corridor = [this](const Cell&, const Cell& c) {
      return corridor_of_[coarse_.at(c.i / kBlock, c.j / kBlock)] == queries_;
    };
    if (Cells path = search(fine_, window, from, to, fine_search_, in_corridor); !path.empty()) return path;
  }
  return search(fine_, {0, 0, fine_.columns - 1, fine_.rows - 1}, from, to, fine_search_,
                [](const Cell&, const Cell&) { return true; });
}

std::optional<Polyline> Tlppa::path(const Point& a, const Point& b) {
  const auto from = connect(a), to = connect(b);
  if (!from || !to || component(*from) != component(*to)) return std::nullopt;
  const Cells cells = fine_path(*from, *to);
  if (cells.empty()) return std::nullopt;
  Polyline line{a};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const bool inner = k > 0 && k + 1 < cells.size();
    if (inner && cells[k + 1].i - cells[k].i == cells[k].i - cells[k - 1].i &&
        cells[k + 1].j - cells[k].j == cells[k].j - cells[k - 1].j)
      continue;
    line.push_back(fine_.centre(cells[k].i, cells[k].j));
  }
  line.push_back(b);
  return line;
}

}  // namespace oxturn

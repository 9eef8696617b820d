#include "algorithms/transit/tlppa.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr int kBlock = 8;  // fine cells a side of a coarse one
constexpr int kReach = 4;  // fine cells around a point in which its cell is searched
constexpr double kMostCells = 1 << 22;
constexpr int kSteps[8][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

double octile_distance(int dx, int dy) {
  dx = std::abs(dx), dy = std::abs(dy);
  return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
}

}  // namespace

Tlppa::Tlppa(const Problem& problem, double cell) : problem_(problem) {
  const Region& space = problem.configuration_space();
  const Box box = bounding_box(space);
  const Point size = box.size();
  cell = std::max(cell, std::sqrt(size.x() * size.y() / kMostCells));
  const auto cells = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / cell))); };
  fine_ = rasterise(space, box.low, cell, cells(size.x()), cells(size.y()), CellRule::inside);
  block_columns_ = (fine_.columns - 1) / kBlock + 1;
  block_rows_ = (fine_.rows - 1) / kBlock + 1;
  corridor_of_.assign(static_cast<std::size_t>(block_columns_) * static_cast<std::size_t>(block_rows_), 0);
  find_coarse_cells();
  components_ = connected_components(coarse_.size(), [this](std::size_t c, const auto& reach) {
    for_each_step(c, [&](std::size_t next, const Cell&) { reach(next); });
  });
}

/// Decision 2.
void Tlppa::find_coarse_cells() {
  coarse_of_.assign(fine_.bits.size(), kNone);
  Cells part;
  for (int y = 0; y < block_rows_; ++y)
    for (int x = 0; x < block_columns_; ++x)
      for (int j = y * kBlock; j < std::min(fine_.rows, (y + 1) * kBlock); ++j)
        for (int i = x * kBlock; i < std::min(fine_.columns, (x + 1) * kBlock); ++i) {
          const auto mark = [&](int u, int v) {
            if (!fine_.get(u, v) || u / kBlock != x || v / kBlock != y || coarse_of_[fine_.at(u, v)] != kNone)
              return false;
            coarse_of_[fine_.at(u, v)] = static_cast<std::uint32_t>(coarse_.size());
            return true;
          };
          if (!mark(i, j)) continue;
          part.assign(1, {i, j});
          breadth_first(part, [&](const Cell& c, const auto& reach) {
            for (const auto& [di, dj] : kSteps)
              if (mark(c.i + di, c.j + dj)) reach({c.i + di, c.j + dj});
          });
          coarse_.push_back({x, y});
        }
}

/// Calls f(coarse cell, its block) for those that a step leads to; for one several times if several steps do.
template <class F>
void Tlppa::for_each_step(std::size_t coarse, F f) const {
  const Cell block = coarse_[coarse];
  const int left = block.i * kBlock, bottom = block.j * kBlock, last = kBlock - 1;
  const auto look_around = [&](int i, int j) {
    if (i >= fine_.columns || j >= fine_.rows || coarse_of_[fine_.at(i, j)] != coarse) return;
    for (const auto& [di, dj] : kSteps)
      if (fine_.inside(i + di, j + dj))
        if (const std::uint32_t next = coarse_of_[fine_.at(i + di, j + dj)]; next != kNone && next != coarse)
          f(static_cast<std::size_t>(next), coarse_[next]);
  };
  for (int k = 0; k <= last; ++k) {
    look_around(left + k, bottom);
    look_around(left + k, bottom + last);
    if (k == 0 || k == last) continue;
    look_around(left, bottom + k);
    look_around(left + last, bottom + k);
  }
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

/// The blocks of the coarse cells on the way.
Tlppa::Cells Tlppa::coarse_path(const Cell& from, const Cell& to) {
  const std::size_t end = coarse_of_[fine_.at(to.i, to.j)];
  const auto neighbours = [this](std::size_t at, const auto& reach) {
    for_each_step(at, [&](std::size_t next, const Cell& block) {
      reach(next, block.i != coarse_[at].i && block.j != coarse_[at].j ? std::sqrt(2.0) : 1);
    });
  };
  const auto estimate = [&](std::size_t at) {
    return octile_distance(coarse_[at].i - coarse_[end].i, coarse_[at].j - coarse_[end].j);
  };
  a_star(
      coarse_search_, coarse_.size(), coarse_of_[fine_.at(from.i, from.j)], neighbours,
      [&](std::size_t at) { return at == end; }, estimate);
  Cells blocks;
  for (const std::size_t at : coarse_search_.path_to(end)) blocks.push_back(coarse_[at]);
  return blocks;
}

/// Marks the blocks of a coarse path and their neighbours for the current query; returns the window of their cells.
Tlppa::Window Tlppa::mark_corridor(const Cells& blocks) {
  ++queries_;
  Window window{fine_.columns, fine_.rows, 0, 0};
  for (const Cell& block : blocks)
    for (int y = std::max(0, block.j - 1); y <= std::min(block_rows_ - 1, block.j + 1); ++y)
      for (int x = std::max(0, block.i - 1); x <= std::min(block_columns_ - 1, block.i + 1); ++x) {
        corridor_of_[block_at({x, y})] = queries_;
        window = {std::min(window.left, x * kBlock), std::min(window.bottom, y * kBlock),
                  std::max(window.right, x * kBlock + kBlock - 1), std::max(window.top, y * kBlock + kBlock - 1)};
      }
  window.right = std::min(window.right, fine_.columns - 1);
  window.top = std::min(window.top, fine_.rows - 1);
  return window;
}

/// Decision 3: A* over the eight neighbours of the free cells in the corridor.
Tlppa::Cells Tlppa::fine_path(const Cell& from, const Cell& to) {
  const Window w = mark_corridor(coarse_path(from, to));
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
      if (fine_.get(next.i, next.j) && corridor_of_[block_at({next.i / kBlock, next.j / kBlock})] == queries_)
        reach(node(next), k < 4 ? 1 : std::sqrt(2.0));
    }
  };
  const auto estimate = [&](std::size_t at) { return octile_distance(cell(at).i - to.i, cell(at).j - to.j); };
  const std::size_t end = node(to);
  a_star(
      fine_search_, columns * rows, node(from), neighbours, [&](std::size_t at) { return at == end; }, estimate);
  Cells path;
  for (const std::size_t at : fine_search_.path_to(end)) path.push_back(cell(at));
  return path;
}

std::optional<Polyline> Tlppa::path(const Point& a, const Point& b) {
  const auto from = connect(a), to = connect(b);
  if (!from || !to || component(*from) != component(*to)) return std::nullopt;
  const Cells cells = fine_path(*from, *to);
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

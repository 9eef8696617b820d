#include "algorithms/transit/tlppa.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace oxturn {
namespace {

constexpr int kBlock = 8;
constexpr int kReach = 4;
constexpr double kMostCells = 1 << 22;
constexpr int kSteps[8][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

}  // namespace

/// A* over the eight neighbours of the set cells in a window; `may(from i, j, to i, j)` tells which steps there are. Equal
/// costs: the lower cell first. Empty if there is no way.
template <class May>
std::vector<std::size_t> Tlppa::search(const BitGrid& grid, const Window& w, std::size_t from, std::size_t to,
                                       Notes& notes, May may) {
  const auto columns = static_cast<std::size_t>(w.right - w.left + 1);
  const auto local = [&](int i, int j) {
    return static_cast<std::size_t>(j - w.bottom) * columns + static_cast<std::size_t>(i - w.left);
  };
  const auto column = [&](std::size_t c) { return static_cast<int>(c % columns) + w.left; };
  const auto row = [&](std::size_t c) { return static_cast<int>(c / columns) + w.bottom; };
  const auto all = columns * static_cast<std::size_t>(w.top - w.bottom + 1);
  const auto wide = static_cast<std::size_t>(grid.columns);
  const std::size_t begin = local(static_cast<int>(from % wide), static_cast<int>(from / wide));
  const std::size_t end = local(static_cast<int>(to % wide), static_cast<int>(to / wide));

  if (notes.of.size() < all) notes.of.resize(all, {0, 0, -1, false});
  const std::uint32_t now = ++notes.search;
  std::vector<Notes::Note>& of = notes.of;
  const auto closed = [&](std::size_t c) { return of[c].search == now && of[c].closed; };
  const auto ahead = [&](int i, int j) {  // the least that eight directions allow
    const int dx = std::abs(i - column(end)), dy = std::abs(j - row(end));
    return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
  };
  using Item = std::pair<double, std::size_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  of[begin] = {0, now, -1, false};
  open.push({ahead(column(begin), row(begin)), begin});
  while (!open.empty() && !closed(end)) {
    const std::size_t at = open.top().second;
    open.pop();
    if (of[at].closed) continue;
    of[at].closed = true;
    const int i = column(at), j = row(at);
    for (int k = 0; k < 8; ++k) {
      const int x = i + kSteps[k][0], y = j + kSteps[k][1];
      if (x < w.left || x > w.right || y < w.bottom || y > w.top || !grid.get(x, y) || !may(i, j, x, y)) continue;
      const double longer = of[at].cost + (k < 4 ? 1 : std::sqrt(2.0));
      const std::size_t next = local(x, y);
      if (of[next].search == now && (of[next].closed || longer >= of[next].cost)) continue;
      of[next] = {longer, now, static_cast<std::int8_t>(k), false};
      open.push({longer + ahead(x, y), next});
    }
  }
  std::vector<std::size_t> way;
  if (!closed(end)) return way;
  for (std::size_t at = end;; at = local(column(at) - kSteps[of[at].came][0], row(at) - kSteps[of[at].came][1])) {
    way.push_back(grid.at(column(at), row(at)));
    if (at == begin) break;
  }
  std::reverse(way.begin(), way.end());
  return way;
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
  may_.assign(coarse_.bits.size(), 0);
  number_parts();
}

void Tlppa::number_parts() {
  part_.assign(fine_.bits.size(), -1);
  std::int32_t parts = 0;
  std::vector<std::uint32_t> queue;
  for (std::size_t c = 0; c < part_.size(); ++c) {
    if (part_[c] >= 0 || fine_.bits[c] == 0) continue;
    part_[c] = parts;
    queue.assign(1, static_cast<std::uint32_t>(c));
    while (!queue.empty()) {
      const int i = static_cast<int>(queue.back() % static_cast<std::uint32_t>(fine_.columns));
      const int j = static_cast<int>(queue.back() / static_cast<std::uint32_t>(fine_.columns));
      queue.pop_back();
      for (const auto& step : kSteps) {
        if (!fine_.get(i + step[0], j + step[1])) continue;
        const std::size_t next = fine_.at(i + step[0], j + step[1]);
        if (part_[next] >= 0) continue;
        part_[next] = parts;
        queue.push_back(static_cast<std::uint32_t>(next));
      }
    }
    ++parts;
  }
}

std::optional<std::size_t> Tlppa::join(const Point& p) const {
  const int i = static_cast<int>(std::floor((p.x() - fine_.origin.x()) / fine_.cell));
  const int j = static_cast<int>(std::floor((p.y() - fine_.origin.y()) / fine_.cell));
  std::vector<std::pair<double, std::size_t>> near;
  for (int y = j - kReach; y <= j + kReach; ++y)
    for (int x = i - kReach; x <= i + kReach; ++x)
      if (fine_.get(x, y)) near.emplace_back(distance(p, fine_.centre(x, y)), fine_.at(x, y));
  std::sort(near.begin(), near.end());
  for (const auto& [away, c] : near) {
    const int x = static_cast<int>(c % static_cast<std::size_t>(fine_.columns));
    const int y = static_cast<int>(c / static_cast<std::size_t>(fine_.columns));
    if (problem_.walls().contains(p, fine_.centre(x, y))) return c;
  }
  return std::nullopt;
}

/// The blocks of the coarse way; none if there is none.
std::vector<std::size_t> Tlppa::corridor(std::size_t from, std::size_t to) {
  const auto block = [&](std::size_t c) {
    const int i = static_cast<int>(c % static_cast<std::size_t>(fine_.columns));
    const int j = static_cast<int>(c / static_cast<std::size_t>(fine_.columns));
    return coarse_.at(i / kBlock, j / kBlock);
  };
  const auto across = [&](int i, int j, int x, int y) {
    // Fine cells of block (i, j) on the side, or at the corner, that faces (x, y).
    const auto range = [](int b, int d) {
      return std::pair(b * kBlock + (d > 0 ? kBlock - 1 : 0), b * kBlock + (d < 0 ? 0 : kBlock - 1));
    };
    const auto [left, right] = range(i, x - i);
    const auto [bottom, top] = range(j, y - j);
    for (int v = bottom; v <= top; ++v)
      for (int u = left; u <= right; ++u) {
        if (!fine_.get(u, v)) continue;
        for (const auto& step : kSteps) {
          const int a = u + step[0], b = v + step[1];
          if (a / kBlock == x && b / kBlock == y && fine_.get(a, b)) return true;
        }
      }
    return false;
  };
  return search(coarse_, {0, 0, coarse_.columns - 1, coarse_.rows - 1}, block(from), block(to), on_coarse_, across);
}

std::optional<Polyline> Tlppa::path(const Point& a, const Point& b) {
  const auto from = join(a), to = join(b);
  if (!from || !to || part_[*from] != part_[*to]) return std::nullopt;
  std::vector<std::size_t> way;
  if (const std::vector<std::size_t> blocks = corridor(*from, *to); !blocks.empty()) {
    Window window{fine_.columns, fine_.rows, 0, 0};
    ++ways_;
    for (const std::size_t block : blocks) {
      const int i = static_cast<int>(block % static_cast<std::size_t>(coarse_.columns));
      const int j = static_cast<int>(block / static_cast<std::size_t>(coarse_.columns));
      for (int y = std::max(0, j - 1); y <= std::min(coarse_.rows - 1, j + 1); ++y)
        for (int x = std::max(0, i - 1); x <= std::min(coarse_.columns - 1, i + 1); ++x) {
          may_[coarse_.at(x, y)] = ways_;
          window = {std::min(window.left, x * kBlock), std::min(window.bottom, y * kBlock),
                    std::max(window.right, x * kBlock + kBlock - 1), std::max(window.top, y * kBlock + kBlock - 1)};
        }
    }
    window.right = std::min(window.right, fine_.columns - 1);
    window.top = std::min(window.top, fine_.rows - 1);
    way = search(fine_, window, *from, *to, on_fine_,
                 [&](int, int, int x, int y) { return may_[coarse_.at(x / kBlock, y / kBlock)] == ways_; });
  }
  if (way.empty())
    way = search(fine_, {0, 0, fine_.columns - 1, fine_.rows - 1}, *from, *to, on_fine_,
                 [](int, int, int, int) { return true; });
  if (way.empty()) return std::nullopt;
  Polyline line{a};
  for (std::size_t k = 0; k < way.size(); ++k) {
    // Cell numbers step by a constant along a straight run.
    if (k > 0 && k + 1 < way.size() && way[k + 1] - way[k] == way[k] - way[k - 1]) continue;
    const int i = static_cast<int>(way[k] % static_cast<std::size_t>(fine_.columns));
    const int j = static_cast<int>(way[k] / static_cast<std::size_t>(fine_.columns));
    line.push_back(fine_.centre(i, j));
  }
  line.push_back(b);
  return line;
}

}  // namespace oxturn

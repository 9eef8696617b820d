#include "algorithms/drawing/weighted_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kCell = 0.25;          // tool widths
constexpr double kMostAcross = 500;     // cells
constexpr double kHalfDiagonal = 0.75;  // cells, rounded up: thin pieces leave no gap between diagonal cells

}  // namespace

WeightedSearch::WeightedSearch(const Problem& problem, const FinishedWork& work, double weight)
    : problem_(problem), work_(work), weight_(weight) {
  const Box box = bounding_box(problem.configuration_space());
  const double cell = std::max(kCell * problem.robot().tool_width, box.size().maxCoeff() / kMostAcross);
  const auto across = [&](double size) { return static_cast<int>(size / cell) + 1; };
  free_ = rasterise(problem.configuration_space(), box.low, cell, across(box.size().x()), across(box.size().y()),
                    CellRule::centre);
  for (const DrawnPiece& piece : work.pieces()) cells_.push_back(cells_of(piece));
}

Point WeightedSearch::centre(std::size_t cell) const {
  const auto columns = static_cast<std::size_t>(free_.columns);
  return free_.centre(static_cast<int>(cell % columns), static_cast<int>(cell / columns));
}

std::vector<std::uint32_t> WeightedSearch::cells_of(const DrawnPiece& piece) const {
  std::vector<std::uint32_t> cells;
  const double radius = std::max(piece.half_width, kHalfDiagonal * free_.cell);
  for (std::size_t k = 1; k < piece.points.size(); ++k) {
    Box box;
    box.add(piece.points[k - 1]);
    box.add(piece.points[k]);
    box.grow(radius);
    const Point low = (box.low - free_.origin) / free_.cell, high = (box.high - free_.origin) / free_.cell;
    for (int j = std::max(0, static_cast<int>(low.y())); j <= std::min(free_.rows - 1, static_cast<int>(high.y())); ++j)
      for (int i = std::max(0, static_cast<int>(low.x())); i <= std::min(free_.columns - 1, static_cast<int>(high.x()));
           ++i)
        if (distance_to_segment(free_.centre(i, j), piece.points[k - 1], piece.points[k]) < radius)
          cells.push_back(static_cast<std::uint32_t>(free_.at(i, j)));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

void WeightedSearch::mark_finished() {
  if (marked_ == work_.fingerprint()) return;
  covered_.assign(free_.bits.size(), 0);
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (work_.finished(k))
      for (const std::uint32_t cell : cells_[k]) covered_[cell] = 1;
  marked_ = work_.fingerprint();
}

std::vector<std::pair<std::size_t, double>> WeightedSearch::cells_at(const Point& p) const {
  std::vector<std::pair<std::size_t, double>> cells;
  const Point at = (p - free_.origin) / free_.cell;
  const int i0 = static_cast<int>(std::floor(at.x())), j0 = static_cast<int>(std::floor(at.y()));
  for (int j = j0 - 1; j <= j0 + 1; ++j)
    for (int i = i0 - 1; i <= i0 + 1; ++i)
      if (free_.get(i, j) && problem_.walls().contains(p, free_.centre(i, j)))
        cells.push_back({free_.at(i, j), distance(p, free_.centre(i, j))});
  return cells;
}

template <class Reach>
void WeightedSearch::for_each_neighbour(std::size_t cell, const Point& from, const Point& to, Reach reach) const {
  const auto columns = static_cast<std::size_t>(free_.columns);
  const int i = static_cast<int>(cell % columns), j = static_cast<int>(cell / columns);
  const auto factor = [&](std::size_t c) {
    const Point p = centre(c);
    const bool counts = covered_[c] != 0 && std::min(distance(p, from), distance(p, to)) > work_.exempt();
    return counts ? 1 + weight_ : 1;
  };
  const double here = factor(cell);
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      if ((di == 0 && dj == 0) || !free_.get(i + di, j + dj)) continue;
      const std::size_t next = free_.at(i + di, j + dj);
      reach(next, free_.cell * math::hypot(di, dj) * (here + factor(next)) / 2);
    }
}

double WeightedSearch::cost(const Point& a, const Point& b, const Point& from, const Point& to) const {
  return distance(a, b) + weight_ * work_.crossing_m(a, b, from, to);
}

Polyline WeightedSearch::straightened(const Polyline& path) const {
  const Point &from = path.front(), &to = path.back();
  std::vector<double> so_far{0};
  for (std::size_t k = 1; k < path.size(); ++k) so_far.push_back(so_far.back() + cost(path[k - 1], path[k], from, to));
  Polyline out{from};
  for (std::size_t k = 0; k + 1 < path.size();) {
    std::size_t next = path.size() - 1;
    for (; next > k + 1; --next)
      if (problem_.walls().contains(path[k], path[next]) &&
          cost(path[k], path[next], from, to) <= so_far[next] - so_far[k])
        break;
    out.push_back(path[next]);
    k = next;
  }
  return out;
}

std::optional<Polyline> WeightedSearch::path(const Point& from, const Point& to) {
  mark_finished();
  reached_ = 0;
  const auto begin = cells_at(from), end = cells_at(to);
  const auto is_end = [&](std::size_t cell) {
    return std::any_of(end.begin(), end.end(), [&](const auto& e) { return e.first == cell; });
  };
  const auto reached = a_star(
      tree_, free_.bits.size(), SearchSources<double>(begin),
      [&](std::size_t cell, auto reach) { ++reached_, for_each_neighbour(cell, from, to, reach); }, is_end,
      [&](std::size_t cell) { return std::max(0.0, distance(centre(cell), to) - 2 * free_.cell); });
  if (!reached) return std::nullopt;
  Polyline path{from};
  const std::vector<std::size_t> cells = tree_.path_to(*reached);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Point p = centre(cells[k]);
    // A vertex of the path is where it turns.
    if (k > 0 && k + 1 < cells.size() && centre(cells[k + 1]) - p == p - centre(cells[k - 1])) continue;
    path.push_back(p);
  }
  path.push_back(to);
  return straightened(path);
}

}  // namespace oxturn

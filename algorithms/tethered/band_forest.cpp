#include "algorithms/tethered/band_forest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/graph_search.hpp"

namespace oxturn {
namespace {

constexpr double kSameDistance = 1e-6;  // cell sides

class BandForest {
 public:
  BandForest(const TetherCells& cells, double depth)
      : cells_(cells), piece_(cells.size(), kNone), owner_(cells.size(), kNone) {
    for (std::size_t c = 0; c < cells.size(); ++c)
      band_.push_back(static_cast<std::size_t>(cells[c].distance / depth + kSameDistance));
    const ConnectedComponents parts =
        connected_components(cells.size(), [this](std::size_t c, const auto& reach) { for_each_adjacent(c, reach); });
    std::vector<CellList> components(static_cast<std::size_t>(parts.count));  // each ascending
    for (std::size_t c = 0; c < cells.size(); ++c) components[static_cast<std::size_t>(parts.of[c])].push_back(c);
    std::stable_sort(components.begin(), components.end(),
                     [this](const CellList& a, const CellList& b) { return band_[a.front()] < band_[b.front()]; });
    for (CellList& component : components) divide(std::move(component));
  }

  CellList order(const std::function<void(CellList&)>& sort) const {
    std::vector<PieceList> children(pieces_.size());
    PieceList roots;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const std::optional<std::size_t>& parent = pieces_[p].parent;
      (parent ? children[*parent] : roots).push_back(p);
    }
    std::size_t next = piece_[cells_.root()];
    while (pieces_[next].parent) next = *pieces_[next].parent;
    CellList order;
    while (true) {
      std::erase(roots, next);
      append_tree(next, children, sort, order);
      if (roots.empty()) return order;
      next = nearest_first(roots, cells_[order.back()].at).front();
    }
  }

  std::vector<Polyline> edges() const {
    std::vector<Polyline> lines;
    const auto middle = [&](const Piece& piece) { return cells_[piece.cells[piece.cells.size() / 2]].at; };
    for (const Piece& piece : pieces_)
      if (piece.parent) lines.push_back({middle(pieces_[*piece.parent]), middle(piece)});
    return lines;
  }

 private:
  using PieceList = std::vector<std::size_t>;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Piece {
    std::optional<std::size_t> parent;
    CellList cells;
  };

  /// Pieces by their least distance from a point.
  PieceList nearest_first(const PieceList& some, const Point& at) const {
    std::vector<std::pair<double, std::size_t>> ranked;
    for (const std::size_t p : some) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t c : pieces_[p].cells) least = std::min(least, distance(at, cells_[c].at));
      ranked.push_back({least, p});
    }
    std::sort(ranked.begin(), ranked.end());
    PieceList sorted;
    for (const auto& [least, p] : ranked) sorted.push_back(p);
    return sorted;
  }

  /// Depth-first, the child nearest to the cell visited last first.
  void append_tree(std::size_t root, const std::vector<PieceList>& children, const std::function<void(CellList&)>& sort,
                   CellList& order) const {
    PieceList stack{root};
    while (!stack.empty()) {
      const std::size_t p = stack.back();
      stack.pop_back();
      CellList own = pieces_[p].cells;
      sort(own);
      order.insert(order.end(), own.begin(), own.end());
      const PieceList near = nearest_first(children[p], cells_[own.back()].at);
      stack.insert(stack.end(), near.rbegin(), near.rend());
    }
  }

  /// Calls f(cell) for the adjacent cells of the same band, over sides and over corners.
  template <class F>
  void for_each_adjacent(std::size_t c, F f) const {
    for (const Direction d : kAllDirections) {
      const auto n = cells_.neighbour(c, d);
      if (!n) continue;
      if (band_[*n] == band_[c]) f(*n);
      for (const Direction e : {left_of(d), right_of(d)})
        if (const auto corner = cells_.neighbour(*n, e); corner && band_[*corner] == band_[c]) f(*corner);
    }
  }

  /// Makes pieces of a component of a band: one for each piece of an earlier band that leads to it.
  void divide(CellList component) {
    std::vector<std::pair<std::size_t, std::size_t>> entries;  // (cell, piece that leads to it)
    for (const std::size_t c : component)
      for (const Direction d : kAllDirections)
        if (const auto n = cells_.neighbour(c, d); n && band_[*n] < band_[c]) entries.push_back({c, piece_[*n]});
    if (entries.empty()) return add(std::nullopt, std::move(component));
    // A wave from all entries at once.
    std::sort(entries.begin(), entries.end());
    CellList wave;
    for (const auto& [c, piece] : entries) {
      if (owner_[c] != kNone) continue;
      owner_[c] = piece;
      wave.push_back(c);
    }
    breadth_first(wave, [&](std::size_t at, auto reach) {
      for_each_adjacent(at, [&](std::size_t n) {
        if (owner_[n] != kNone) return;
        owner_[n] = owner_[at];
        reach(n);
      });
    });
    for (const std::size_t c : component)
      if (piece_[c] == kNone) add(owner_[c], piece_around(c));
  }

  /// Connected cells with the same owner.
  CellList piece_around(std::size_t seed) {
    CellList piece{seed};
    piece_[seed] = pieces_.size();
    breadth_first(piece, [&](std::size_t at, auto reach) {
      for_each_adjacent(at, [&](std::size_t n) {
        if (piece_[n] != kNone || owner_[n] != owner_[seed]) return;
        piece_[n] = pieces_.size();
        reach(n);
      });
    });
    return piece;
  }

  void add(std::optional<std::size_t> parent, CellList cells) {
    for (const std::size_t c : cells) piece_[c] = pieces_.size();
    pieces_.push_back({parent, std::move(cells)});
  }

  const TetherCells& cells_;
  std::vector<Piece> pieces_;
  // All by cell.
  std::vector<std::size_t> band_;
  std::vector<std::size_t> piece_;  // kNone: not decided yet
  std::vector<std::size_t> owner_;  // piece of an earlier band whose wave reached the cell first; kNone: not yet
};

}  // namespace

void sort_by_distance(CellList& list, const TetherCells& cells) {
  const auto rank = [&](std::size_t c) { return std::llround(cells[c].distance / (kSameDistance * cells.side())); };
  std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(rank(a), a) < std::make_pair(rank(b), b);  // cells are numbered row by row
  });
}

ForestOrder forest_order(const TetherCells& cells, double depth, const std::function<void(CellList&)>& sort) {
  const BandForest forest(cells, depth);
  return {forest.order(sort), forest.edges()};
}

}  // namespace oxturn

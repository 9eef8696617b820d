// Cell after cell, by distance along the tether.
//
// Source      after Shnaps & Rimon, "Online coverage by a tethered autonomous mobile robot in planar unknown
//             environments", IEEE T-RO 2014, as told by Berg 2021 (chapters 2 and 4.1)
// Model       grid, here offline, disc footprint of one cell
// Guarantee   visits every cell in which the robot can stand (`cells`); path, home included, at most 2 L n for n cells
//             and a leash of L metres; string within the leash
// Complexity  n cells: O(n log n) for their order, then n tethered shortest paths
// Decisions   1. Round k of the paper takes the new cells within k D, nearest first: over all rounds that is one order by
//                (distance, row, column). Distances that differ by rounding alone count as equal.
//             2. `order = distance` is literal and, as the thesis shows, makes an almost random path.
//             3. `order = split` keeps the split cells, of which the thesis says that one side of an obstacle is
//                finished before the other: cells fall into bands D deep, bands into connected pieces; a piece that
//                several pieces of bands before lead to is cut where the ways to them are equally long (in cells);
//                the tree of pieces is visited depth-first, the nearest child first, cells of a piece as in 1.
//             4. Within a band, cells hang together over a side, or over a corner if a cell beside it is free to both:
//                else the stairs of a grid would split every slanting band.
//             5. Pieces to which no piece of a band before leads (pockets, and cells nearer the anchor than the
//                start) are further roots, visited last, the nearest first.
//             6. The paper's cells are wholly free ones, joined by free edges (`cells = joined`). By default a cell at a
//                wall counts as well: its place is the free one nearest to its centre, if that lies in the cell. The
//                thesis has it that the robot gets close to walls and into corners.
//             7. Every way is driven with the tool on: cells that lie scattered are not covered otherwise.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/online/sensing.hpp"
#include "algorithms/transit/tether_space.hpp"
#include "algorithms/tethered/tether_cells.hpp"
#include "algorithms/tethered/visit_points.hpp"

namespace oxturn {
namespace {

struct Params {
  std::string order = "distance";
  std::string cells = "any";
  double cell_size = 0;
  std::string retraction = "automatic";
  int budget = 2000;
  bool return_home = true;
};

using Cells = std::vector<std::size_t>;

void sort_by_distance(Cells& order, const TetherCells& cells) {
  const auto rank = [&](std::size_t c) { return std::llround(cells[c].distance / (1e-6 * cells.side())); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(rank(a), a) < std::make_pair(rank(b), b);  // cells are listed row by row
  });
}

/// Bands of like distance in pieces that form a forest; see Decisions 3 to 5.
class Pieces {
 public:
  explicit Pieces(const TetherCells& cells) : cells_(cells), piece_(cells.size(), -1) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto band = static_cast<std::size_t>(cells[c].distance / cells.side() + 1e-6);
      if (bands_.size() <= band) bands_.resize(band + 1);
      bands_[band].push_back(c);
      band_.push_back(static_cast<int>(band));
    }
    for (const Cells& band : bands_)
      for (const std::size_t seed : band)
        if (piece_[seed] < 0) settle(gather(Cells{seed}, [&](std::size_t c) { return piece_[c] == -1; }));
  }

  /// All cells: depth-first over the pieces.
  Cells order() const {
    Cells order;
    std::vector<std::vector<int>> children(pieces_.size());
    std::vector<int> roots, stack;
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      (pieces_[p].parent < 0 ? roots : children[static_cast<std::size_t>(pieces_[p].parent)])
          .push_back(static_cast<int>(p));
    int next = piece_[cells_.root()];  // the tree that holds the start comes first
    while (pieces_[static_cast<std::size_t>(next)].parent >= 0) next = pieces_[static_cast<std::size_t>(next)].parent;
    while (true) {
      std::erase(roots, next);
      stack.push_back(next);
      while (!stack.empty()) {
        const auto p = static_cast<std::size_t>(stack.back());
        stack.pop_back();
        Cells own = pieces_[p].cells;
        sort_by_distance(own, cells_);
        order.insert(order.end(), own.begin(), own.end());
        const std::vector<int> near = nearest_first(children[p], cells_[own.back()].place);
        stack.insert(stack.end(), near.rbegin(), near.rend());
      }
      if (roots.empty()) return order;
      next = nearest_first(roots, cells_[order.back()].place).front();
    }
  }

  std::vector<Polyline> tree() const {
    std::vector<Polyline> lines;
    const auto middle = [&](const Cells& all) { return cells_[all[all.size() / 2]].place; };
    for (const Piece& piece : pieces_)
      if (piece.parent >= 0)
        lines.push_back({middle(pieces_[static_cast<std::size_t>(piece.parent)].cells), middle(piece.cells)});
    return lines;
  }

 private:
  struct Piece {
    int parent;
    Cells cells;
  };

  std::vector<int> nearest_first(const std::vector<int>& some, const Point& at) const {
    std::vector<std::pair<double, int>> ranked;
    for (const int p : some) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t c : pieces_[static_cast<std::size_t>(p)].cells)
        least = std::min(least, distance(at, cells_[c].place));
      ranked.push_back({least, p});
    }
    std::sort(ranked.begin(), ranked.end());
    std::vector<int> sorted;
    for (const auto& [least, p] : ranked) sorted.push_back(p);
    return sorted;
  }

  /// Calls f(cell) for the neighbours of c in its band, over sides and over corners.
  template <class F>
  void for_each_beside(std::size_t c, F f) const {
    for (const Direction d : kAllDirections) {
      const auto n = cells_.neighbour(c, d);
      if (!n) continue;
      if (band_[*n] == band_[c]) f(*n);
      for (const Direction e : {left_of(d), right_of(d)})
        if (const auto corner = cells_.neighbour(*n, e); corner && band_[*corner] == band_[c]) f(*corner);
    }
  }

  /// `queue` and what hangs together with it among cells that `wanted` holds for, breadth-first. Marks it -2.
  template <class F>
  Cells gather(Cells queue, F wanted) {
    for (const std::size_t c : queue) piece_[c] = -2;
    for (std::size_t k = 0; k < queue.size(); ++k)
      for_each_beside(queue[k], [&](std::size_t n) {
        if (!wanted(n)) return;
        piece_[n] = -2;
        queue.push_back(n);
      });
    return queue;
  }

  /// Makes pieces of a connected part of a band: one for each piece of the band before that leads to it.
  void settle(Cells part) {
    std::sort(part.begin(), part.end());
    std::vector<std::pair<std::size_t, int>> queue;  // (cell, parent), nearest the entries first
    for (const std::size_t c : part)
      for (const Direction d : kAllDirections)
        if (const auto n = cells_.neighbour(c, d); n && band_[*n] < band_[c]) queue.push_back({c, piece_[*n]});
    std::sort(queue.begin(), queue.end());
    if (queue.empty()) return add(-1, std::move(part));
    // A wave from all entries at once: `-3 - parent` is whose a cell is.
    std::erase_if(queue, [&](const auto& entry) {
      if (piece_[entry.first] != -2) return true;
      piece_[entry.first] = -3 - entry.second;
      return false;
    });
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const auto [c, parent] = queue[k];
      for_each_beside(c, [&](std::size_t n) {
        if (piece_[n] != -2) return;
        piece_[n] = -3 - parent;
        queue.push_back({n, parent});
      });
    }
    for (const std::size_t c : part)
      if (piece_[c] <= -3) {
        const int mark = piece_[c];
        add(-3 - mark, gather(Cells{c}, [&](std::size_t n) { return piece_[n] == mark; }));
      }
  }

  void add(int parent, Cells own) {
    for (const std::size_t c : own) piece_[c] = static_cast<int>(pieces_.size());
    pieces_.push_back({parent, std::move(own)});
  }

  const TetherCells& cells_;
  std::vector<Cells> bands_;
  std::vector<int> band_, piece_;  // by cell; piece -1: none yet
  std::vector<Piece> pieces_;
};

class ShnapsRimon final : public CoveragePlanner {
 public:
  explicit ShnapsRimon(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace leash(problem, "shnaps-rimon");
    const TetherCells cells(problem, problem.configuration_space(), cell_side(p_.cell_size, problem.robot()),
                            p_.cells == "any" ? CellKind::any : CellKind::joined);
    Cells order;
    if (p_.order == "split") {
      const Pieces pieces(cells);
      order = pieces.order();
      if (context.wants_traces()) context.trace("tree of pieces", pieces.tree());
    } else {
      for (std::size_t c = 0; c < cells.size(); ++c) order.push_back(c);
      sort_by_distance(order, cells);
    }
    std::vector<Point> places;
    for (const std::size_t c : order) places.push_back(cells[c].place);
    return visit_points(leash, places,
                        {p_.retraction == "untangle" ? Retraction::untangle : Retraction::automatic,
                         static_cast<std::size_t>(p_.budget), p_.return_home},
                        context);
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo shnaps_rimon() {
  return with_sensing(describe<ShnapsRimon, Params>(
      {.name = "shnaps-rimon",
       .family = "tethered",
       .title = "cell after cell by distance along the tether",
       .citation = "after Shnaps & Rimon 2014",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "visits every cell; length at most 2 L n, home included",
       .parameters = {
           {"order", &Params::order, Choices{"distance", "split"},
            "distance: literal; split: one side of an obstacle is finished before the other"},
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side D of a cell, metres; 0: tool width / sqrt 2"},
           {"cells", &Params::cells, Choices{"any", "joined"},
            "any: at walls, a cell's free place nearest to its centre counts for it; joined: wholly free cells only"},
           {"retraction", &Params::retraction, Choices{"automatic", "untangle"},
            "untangle: back along the way driven until the next cell is in straight reach"},
           {"budget", &Params::budget, Range{0, 1e9}, "expansions a way, of the search for another class"},
           {"return_home", &Params::return_home, "drive back to the start at the end, tether taken in"}}}));
}

}  // namespace oxturn

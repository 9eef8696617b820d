// A cave: noise smoothed by a cellular automaton, opened to the robot's width, its halls connected by tunnels.
//
// Source      cellular automaton caves: Johnson, Yannakakis, Togelius 2010
// Guarantee   Free space is a union of squares of k x k cells (k cells >= narrowest passage, k >= 2) whose positions
//             form one 4-connected set, so a disc of k cells passes everywhere. Cutting a corner by half a cell, and
//             the two new corners by an eighth to a quarter of a cell, does not touch that disc for k >= 2.
// Complexity  O(cells)
#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.hpp"
#include "base/graph_search.hpp"
#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  double rock = 0.45;
  double grain = 0;
  int rounds = 4;
  int smoothing = 2;
};

constexpr double kMostCells = 1e8;

/// Counts the bits that are set in a box, in O(1).
class Sums {
 public:
  explicit Sums(const BitGrid& g)
      : columns_(g.columns),
        rows_(g.rows),
        sum_(static_cast<std::size_t>(g.columns + 1) * static_cast<std::size_t>(g.rows + 1), 0) {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        sum_[at(i + 1, j + 1)] = sum_[at(i, j + 1)] + sum_[at(i + 1, j)] - sum_[at(i, j)] + (g.get(i, j) ? 1 : 0);
  }
  /// In columns i0 .. i1 - 1 and rows j0 .. j1 - 1; bits outside the grid count as 0.
  int count(int i0, int j0, int i1, int j1) const {
    i0 = std::max(i0, 0), j0 = std::max(j0, 0), i1 = std::min(i1, columns_), j1 = std::min(j1, rows_);
    return i0 < i1 && j0 < j1 ? sum_[at(i1, j1)] - sum_[at(i0, j1)] - sum_[at(i1, j0)] + sum_[at(i0, j0)] : 0;
  }

 private:
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_ + 1) + static_cast<std::size_t>(i);
  }
  int columns_, rows_;
  std::vector<int> sum_;
};

/// Free cells: noise, then in each round the majority of the nine cells of a neighbourhood (rock outside).
BitGrid settled(int columns, int rows, const Params& p, Rng& rng) {
  BitGrid free({0, 0}, 1, columns, rows);
  for (auto& bit : free.bits) bit = rng.chance(p.rock) ? 0 : 1;
  for (int round = 0; round < p.rounds; ++round) {
    const Sums sums(free);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) free.set(i, j, sums.count(i - 1, j - 1, i + 2, j + 2) >= 5);
  }
  return free;
}

/// The lower left cells of all k x k squares of free cells.
BitGrid square_positions(const BitGrid& free, int k) {
  const Sums sums(free);
  BitGrid result({0, 0}, 1, free.columns - k + 1, free.rows - k + 1);
  for (int j = 0; j < result.rows; ++j)
    for (int i = 0; i < result.columns; ++i) result.set(i, j, sums.count(i, j, i + k, j + k) == k * k);
  return result;
}

/// The union of the squares at these positions.
BitGrid union_of_squares(const BitGrid& positions, int k) {
  const Sums sums(positions);
  BitGrid result({0, 0}, 1, positions.columns + k - 1, positions.rows + k - 1);
  for (int j = 0; j < result.rows; ++j)
    for (int i = 0; i < result.columns; ++i) result.set(i, j, sums.count(i - k + 1, j - k + 1, i + 1, j + 1) > 0);
  return result;
}

/// Connects the halls (4-connected sets of positions) by tunnels: a breadth-first search from all halls at once, then
/// the shortest paths between neighbouring searches, by Kruskal's algorithm.
class Tunnels {
 public:
  explicit Tunnels(BitGrid& positions)
      : grid_(positions),
        hall_(grid_.bits.size(), kNone),
        from_(grid_.bits.size(), kNone),
        steps_(grid_.bits.size(), 0) {}

  /// Removes halls with fewer than `least` positions and connects the others.
  void dig(std::size_t least) {
    find_halls(least);
    spread();
    std::vector<Tunnel> tunnels = candidates();
    std::sort(tunnels.begin(), tunnels.end());
    DisjointSets connected(halls_);
    for (const Tunnel& t : tunnels)
      if (connected.unite(hall_[t.a], hall_[t.b]))
        for (std::size_t c : {t.a, t.b})
          for (; c != kNone; c = from_[c]) grid_.bits[c] = 1;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Tunnel {  // between the adjacent cells a and b
    std::size_t length, a, b;
    auto operator<=>(const Tunnel&) const = default;
  };

  /// Calls f(cell) for the up to four neighbours: east, north, west, south.
  template <class F>
  void for_each_neighbour(std::size_t cell, F f) const {
    const auto columns = static_cast<std::size_t>(grid_.columns);
    const std::size_t i = cell % columns, j = cell / columns;
    if (i + 1 < columns) f(cell + 1);
    if (j + 1 < static_cast<std::size_t>(grid_.rows)) f(cell + columns);
    if (i > 0) f(cell - 1);
    if (j > 0) f(cell - columns);
  }

  void find_halls(std::size_t least) {
    std::vector<std::size_t> hall;
    for (std::size_t seed = 0; seed < hall_.size(); ++seed) {
      if (grid_.bits[seed] == 0 || hall_[seed] != kNone) continue;
      hall.assign(1, seed);
      hall_[seed] = halls_;
      breadth_first(hall, [&](std::size_t at, auto reach) {
        for_each_neighbour(at, [&](std::size_t c) {
          if (grid_.bits[c] == 0 || hall_[c] != kNone) return;
          hall_[c] = halls_;
          reach(c);
        });
      });
      if (hall.size() < least) {
        for (const std::size_t c : hall) grid_.bits[c] = 0, hall_[c] = kNone;
      } else {
        cells_.insert(cells_.end(), hall.begin(), hall.end());
        ++halls_;
      }
    }
  }

  /// Assigns every cell to the nearest hall.
  void spread() {
    breadth_first(cells_, [&](std::size_t at, auto reach) {
      for_each_neighbour(at, [&](std::size_t c) {
        if (hall_[c] != kNone) return;
        hall_[c] = hall_[at];
        from_[c] = at;
        steps_[c] = steps_[at] + 1;
        reach(c);
      });
    });
  }

  std::vector<Tunnel> candidates() const {
    std::vector<Tunnel> tunnels;
    for (const std::size_t a : cells_)
      for_each_neighbour(a, [&](std::size_t b) {
        if (a < b && hall_[a] != hall_[b]) tunnels.push_back({steps_[a] + steps_[b], a, b});
      });
    return tunnels;
  }

  BitGrid& grid_;
  // All by cell.
  std::vector<std::size_t> hall_;   // number of the (nearest) hall
  std::vector<std::size_t> from_;   // the cell before on the path from the nearest hall; kNone in a hall
  std::vector<std::size_t> steps_;  // from the nearest hall
  std::vector<std::size_t> cells_;  // of the halls, one after the other; then all cells by distance
  std::size_t halls_ = 0;
};

Region make(const Params& p, Rng& rng) {
  // By default halls are about four robots wide. The cells are square; what remains of the size is divided equally.
  const double grain = p.grain > 0 ? p.grain : std::max(2 * p.robot, narrowest_passage(p) / 2);
  const double across = std::floor(p.width / grain), up = std::floor(p.height / grain);
  if (across * up > kMostCells)
    throw_invalid("grain is {:.4g} m in {:.4g} x {:.4g} m, expected no more than 10^8 cells; raise it", grain, p.width,
                  p.height);
  const double needed = std::max(2.0, std::ceil(narrowest_passage(p) / grain));
  if (across < 2 * needed || up < 2 * needed)
    throw_invalid("grain is {:.4g} m in {:.4g} x {:.4g} m, expected at least {:.4g} cells each way; lower it", grain,
                  p.width, p.height, 2 * needed);
  const int k = static_cast<int>(needed), columns = static_cast<int>(across), rows = static_cast<int>(up);
  BitGrid positions = square_positions(settled(columns, rows, p, rng), k);
  Tunnels(positions).dig(static_cast<std::size_t>(k) * static_cast<std::size_t>(k));
  if (positions.count() == 0)
    throw_invalid("rock {:.4g} leaves no hall {:.4g} m wide; lower rock or grain, or take a larger size", p.rock,
                  k * grain);
  Region region = trace(union_of_squares(positions, k));
  const Point shift((p.width - columns * grain) / 2, (p.height - rows * grain) / 2);
  for_each_ring(region, [&](Ring& ring) {
    ring = without_straight_vertices(ring);
    if (p.smoothing >= 1) ring = cut_vertices(ring, 0.5, 0.5);
    if (p.smoothing >= 2) ring = cut_vertices(ring, 0.25, 0.25);
    for (Point& q : ring) q = shift + grain * q;
  });
  return region;
}

}  // namespace

GeneratorInfo cave() {
  return describe_site<Params>(
      "cave", "a natural cave with pillars",
      "all halls connected; a disc `passage` robot diameters wide reaches all of it",
      {{"rock", &Params::rock, Range{0, 0.9}, "share of rock in the noise; near 0.5 the cave is most complex"},
       {"grain", &Params::grain, Range{0, 1000}, "metres; side of the automaton's cells; 0: one robot diameter"},
       {"rounds", &Params::rounds, Range{0, 50}, "rounds of the automaton; few: rugged walls"},
       {"smoothing", &Params::smoothing, Range{0, 2}, "0: square cells; 1: cut corners; 2: cut twice"}},
      make, 2);
}

}  // namespace oxturn::generator

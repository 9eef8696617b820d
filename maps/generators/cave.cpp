// maps/generators/cave.cpp
// A cave: noise settled by a cellular automaton, opened to the robot's width, its halls joined by tunnels.
//
// Source      cellular automaton caves: Johnson, Yannakakis, Togelius 2010
// Guarantee   Free space is a union of squares of k x k cells (k cells >= narrowest passage, k >= 2) whose
//             positions form one 4-connected set, so a disc of k cells drives everywhere. Cutting a corner by half
//             a cell, and the two new corners by an eighth to a quarter, spares that disc for k >= 2.
// Complexity  O(cells)
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/raster.hpp"
#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  double rock = 0.45;
  double grain = 0;
  int rounds = 4;
  int smoothing = 2;
};

/// How many bits are set in a box, in O(1).
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
  /// Columns i0 .. i1 - 1, rows j0 .. j1 - 1; what lies outside the grid counts nothing.
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

/// Free cells: noise, then by majority of the nine (rock outside).
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

/// Where a k x k square of free cells has its lower left cell.
BitGrid places(const BitGrid& free, int k) {
  const Sums sums(free);
  BitGrid result({0, 0}, 1, free.columns - k + 1, free.rows - k + 1);
  for (int j = 0; j < result.rows; ++j)
    for (int i = 0; i < result.columns; ++i) result.set(i, j, sums.count(i, j, i + k, j + k) == k * k);
  return result;
}

/// The squares themselves.
BitGrid squares(const BitGrid& at, int k) {
  const Sums sums(at);
  BitGrid result({0, 0}, 1, at.columns + k - 1, at.rows + k - 1);
  for (int j = 0; j < result.rows; ++j)
    for (int i = 0; i < result.columns; ++i) result.set(i, j, sums.count(i - k + 1, j - k + 1, i + 1, j + 1) > 0);
  return result;
}

/// Drops halls of fewer than `least` places and digs tunnels between the others: a flood from all halls at once,
/// then the shortest ways between neighbouring floods, by Kruskal.
void join_halls(BitGrid& at, int least) {
  const int n = static_cast<int>(at.bits.size());
  std::vector<int> hall(at.bits.size(), 0), from(at.bits.size(), -1), steps(at.bits.size(), 0), queue;
  const auto index = [](int cell) { return static_cast<std::size_t>(cell); };
  // Calls f for the up to four neighbours: east, north, west, south.
  const auto around = [&](int cell, auto f) {
    const int i = cell % at.columns, j = cell / at.columns;
    if (i + 1 < at.columns) f(cell + 1);
    if (j + 1 < at.rows) f(cell + at.columns);
    if (i > 0) f(cell - 1);
    if (j > 0) f(cell - at.columns);
  };
  int halls = 0;
  std::vector<int> all;
  for (int seed = 0; seed < n; ++seed) {
    if (at.bits[index(seed)] == 0 || hall[index(seed)] != 0) continue;
    ++halls;
    queue.assign(1, seed);
    hall[index(seed)] = halls;
    for (std::size_t head = 0; head < queue.size(); ++head)
      around(queue[head], [&](int c) {
        if (at.bits[index(c)] == 0 || hall[index(c)] != 0) return;
        hall[index(c)] = halls;
        queue.push_back(c);
      });
    if (static_cast<int>(queue.size()) < least) {
      for (const int c : queue) at.bits[index(c)] = 0, hall[index(c)] = 0;
      --halls;
    } else {
      all.insert(all.end(), queue.begin(), queue.end());
    }
  }
  for (std::size_t head = 0; head < all.size(); ++head)
    around(all[head], [&](int c) {
      if (hall[index(c)] != 0) return;
      hall[index(c)] = hall[index(all[head])];
      from[index(c)] = all[head];
      steps[index(c)] = steps[index(all[head])] + 1;
      all.push_back(c);
    });
  struct Tunnel {
    int length, a, b;
  };
  std::vector<Tunnel> tunnels;
  for (const int a : all)
    around(a, [&](int b) {
      if (a < b && hall[index(a)] != hall[index(b)]) tunnels.push_back({steps[index(a)] + steps[index(b)], a, b});
    });
  std::sort(tunnels.begin(), tunnels.end(), [](const Tunnel& x, const Tunnel& y) {
    return std::tie(x.length, x.a, x.b) < std::tie(y.length, y.a, y.b);
  });
  std::vector<int> group(static_cast<std::size_t>(halls) + 1);
  std::iota(group.begin(), group.end(), 0);
  const auto find = [&](int g) {
    while (group[index(g)] != g) g = group[index(g)] = group[index(group[index(g)])];
    return g;
  };
  for (const Tunnel& t : tunnels) {
    const int a = find(hall[index(t.a)]), b = find(hall[index(t.b)]);
    if (a == b) continue;
    group[index(std::max(a, b))] = std::min(a, b);
    for (int c : {t.a, t.b})
      for (; c >= 0; c = from[index(c)]) at.bits[index(c)] = 1;
  }
}

Region make(const Params& p, Rng& rng) {
  check_site("cave", p, 2);
  // Default: halls about four robots wide. The cells are square and fill the size but for part of one.
  const double grain = p.grain > 0 ? p.grain : std::max(2 * p.robot, narrowest(p) / 2);
  const double across = std::floor(p.width / grain), up = std::floor(p.height / grain);
  if (across * up > 1e8)
    refuse("cave", "grain is " + number(grain) + " m in " + number(p.width) + " x " + number(p.height) +
                       " m, expected no more than 10^8 cells; raise it");
  const double needed = std::max(2.0, std::ceil(narrowest(p) / grain));
  if (across < 2 * needed || up < 2 * needed)
    refuse("cave", "grain is " + number(grain) + " m in " + number(p.width) + " x " + number(p.height) +
                       " m, expected at least " + number(2 * needed) + " cells each way; lower it");
  const int k = static_cast<int>(needed), columns = static_cast<int>(across), rows = static_cast<int>(up);
  BitGrid at = places(settled(columns, rows, p, rng), k);
  join_halls(at, k * k);
  if (at.count() == 0)
    refuse("cave", "rock " + number(p.rock) + " leaves no hall " + number(k * grain) +
                       " m wide; lower rock or grain, or take a larger size");
  Region region = trace(squares(at, k));
  const Point shift((p.width - columns * grain) / 2, (p.height - rows * grain) / 2);
  const auto carve = [&](Ring& ring) {
    ring = without_straight_vertices(ring);
    if (p.smoothing >= 1) ring = cut_vertices(ring, 0.5, 0.5);
    if (p.smoothing >= 2) ring = cut_vertices(ring, 0.25, 0.25);
    for (Point& q : ring) q = shift + grain * q;
  };
  for (Polygon& polygon : region.polygons) {
    carve(polygon.outer);
    for (Ring& hole : polygon.holes) carve(hole);
  }
  return finished(std::move(region), p);
}

}  // namespace

GeneratorInfo cave() {
  return describe_generator<Params>(
      "cave", "a natural cave with pillars",
      "all halls joined; a disc `passage` robot diameters wide drives through the whole",
      with_site<Params>(
          {{"rock", &Params::rock, Range{0, 0.9}, "share of rock in the noise; near 0.5 the cave is most tangled"},
           {"grain", &Params::grain, Range{0, 1000}, "metres; side of the automaton's cells; 0: one robot diameter"},
           {"rounds", &Params::rounds, Range{0, 50}, "of the automaton; few: rugged"},
           {"smoothing", &Params::smoothing, Range{0, 2}, "0: square cells; 1: cut corners; 2: cut twice"}}),
      make);
}

}  // namespace oxturn::generator

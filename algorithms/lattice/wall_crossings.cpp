#include "algorithms/lattice/wall_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace oxturn {
namespace {

/// Calls f(line, t, along) for each of the lines x = all whole numbers that the segment ab meets.
template <class F>
void for_each_line(double ax, double ay, double bx, double by, F f) {
  const auto first = static_cast<int>(std::ceil(std::min(ax, bx)));
  const auto last = static_cast<int>(std::floor(std::max(ax, bx)));
  for (int k = first; k <= last; ++k) {
    if (ax == bx) {
      f(k, 0.0, ay);
      f(k, 1.0, by);
    } else {
      const double t = (k - ax) / (bx - ax);
      f(k, t, ay + t * (by - ay));
    }
  }
}

bool earlier(const WallCrossing& a, const WallCrossing& b) { return std::tie(a.edge, a.t) < std::tie(b.edge, b.t); }

}  // namespace

std::vector<WallCrossing> wall_crossings(const GridGraph& graph, const Ring& ring, LatticeLines lines) {
  const double shift = lines == LatticeLines::through_centres ? 0 : 0.5;
  const Point offset(shift, shift);
  std::vector<WallCrossing> found;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &from = ring[k], &to = ring[(k + 1) % ring.size()];
    const Point a = graph.coordinates(from) + offset, b = graph.coordinates(to) + offset;
    const auto add = [&](bool vertical) {
      return [&, vertical](int line, double t, double along) {
        found.push_back({k, t, t == 0 ? from : t == 1 ? to : lerp(from, to, t), vertical, line, along});
      };
    };
    for_each_line(a.x(), a.y(), b.x(), b.y(), add(true));
    for_each_line(a.y(), a.x(), b.y(), b.x(), add(false));
  }
  std::stable_sort(found.begin(), found.end(), earlier);
  return found;
}

Polyline wall_between(const Ring& ring, const WallCrossing& from, const WallCrossing& to) {
  Polyline line{from.at};
  const auto append = [&](const Point& p) {
    if (line.back() != p) line.push_back(p);
  };
  std::size_t k = from.edge;
  if (k != to.edge || !earlier(from, to)) do {
      k = (k + 1) % ring.size();
      append(ring[k]);
    } while (k != to.edge);
  append(to.at);
  return line;
}

std::vector<std::vector<Polyline>> walls_in_cells(const GridGraph& graph, const Region& space) {
  std::vector<std::vector<Polyline>> pieces(graph.size());
  // By the middle of the piece's first segment: its ends lie on sides of the cell.
  const auto add = [&](Polyline piece) {
    if (piece.size() < 2) return;
    const Cell c = graph.cell_of(lerp(piece[0], piece[1], 0.5));
    if (graph.inside(c.i, c.j)) pieces[graph.at(c)].push_back(std::move(piece));
  };
  for_each_ring(space, [&](const Ring& ring) {
    std::vector<WallCrossing> crossings = wall_crossings(graph, ring, LatticeLines::beside_cells);
    const auto same = [](const WallCrossing& a, const WallCrossing& b) { return a.edge == b.edge && a.t == b.t; };
    crossings.erase(std::unique(crossings.begin(), crossings.end(), same), crossings.end());
    if (crossings.empty()) {
      Polyline whole(ring.begin(), ring.end());
      whole.push_back(ring.front());
      return add(std::move(whole));
    }
    for (std::size_t k = 0; k < crossings.size(); ++k)
      add(wall_between(ring, crossings[k], crossings[(k + 1) % crossings.size()]));
  });
  return pieces;
}

}  // namespace oxturn

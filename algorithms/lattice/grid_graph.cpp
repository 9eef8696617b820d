#include "algorithms/lattice/grid_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kSlack = 1e-9;  // cells; a wall as close as that to a square counts as meeting it
constexpr double kMostCells = 1e8;

/// Calls f(k, low, high) for each of the lattice lines x = 0, 1, .. lines - 1 that the segment ab meets; [low, high] is
/// where it does, a single point unless the segment runs along the line.
template <class F>
void for_each_crossing(double ax, double ay, double bx, double by, int lines, F f) {
  const double low = std::min(ax, bx), high = std::max(ax, bx);
  if (const int before = static_cast<int>(low); low > before && high < before + 1 && low > 0) return;  // most segments
  const int first = std::max(0, static_cast<int>(std::ceil(low)));
  const int last = std::min(lines - 1, static_cast<int>(std::floor(high)));
  for (int k = first; k <= last; ++k) {
    if (high == low) {
      f(k, std::min(ay, by), std::max(ay, by));
    } else {
      const double t = (k - ax) / (bx - ax);
      const double y = ay + t * (by - ay);
      f(k, y, y);
    }
  }
}
template <class F>
void for_each_vertical_line(const Point& a, const Point& b, int lines, F f) {
  for_each_crossing(a.x(), a.y(), b.x(), b.y(), lines, f);
}
template <class F>
void for_each_horizontal_line(const Point& a, const Point& b, int lines, F f) {
  for_each_crossing(a.y(), a.x(), b.y(), b.x(), lines, f);
}

void check_size(double cells, double side, const std::string& map_name) {
  if (cells > kMostCells)
    throw std::invalid_argument(fmt::format(
        "a grid of cells {} m wide over '{}' would have {:.3g} cells, more than 1e8; give a larger cell_size", side,
        map_name, cells));
}

}  // namespace

/// Calls f(edge) for each edge of the region's boundary, in cell coordinates. They are computed anew for each pass: a
/// map with many small obstacles has more vertices than the lattice has nodes.
template <class F>
void GridGraph::for_each_wall(const Region& space, F f) const {
  for_each_ring(space, [&](const Ring& ring) {
    Point from = coordinates(ring.back());
    for (const Point& vertex : ring) {
      const Point to = coordinates(vertex);
      f(Edge{from, to});
      from = to;
    }
  });
}

GridGraph::GridGraph(const Region& space, double side, double angle, const Point& origin, int columns, int rows)
    : CellNumbers(columns, rows),
      side_(side),
      origin_(origin),
      across_(math::cos(angle), math::sin(angle)),
      up_(perpendicular(across_)),
      cells_(size(), 0) {
  mark_free_nodes(space);
  open_edges_between_free_nodes();
  close_edges_at_walls(space);
}

// By parity of the walls below a node, one column of nodes at a time. A wall contains its left end only.
void GridGraph::mark_free_nodes(const Region& space) {
  std::vector<std::vector<double>> walls(static_cast<std::size_t>(columns_));
  for_each_wall(space, [&](const Edge& e) {
    const double low = std::min(e.a.x(), e.b.x()), high = std::max(e.a.x(), e.b.x());
    if (low == high) return;
    for_each_vertical_line(e.a, e.b, columns_, [&](int i, double y, double) {
      if (i != high) walls[static_cast<std::size_t>(i)].push_back(y);
    });
  });
  for (int i = 0; i < columns_; ++i) {
    std::vector<double>& heights = walls[static_cast<std::size_t>(i)];
    std::sort(heights.begin(), heights.end());
    for (std::size_t k = 0; k + 1 < heights.size(); k += 2) {
      const int from = std::max(0, static_cast<int>(std::ceil(heights[k])));
      const int to = std::min(rows_ - 1, static_cast<int>(std::floor(heights[k + 1])));
      for (int j = from; j <= to; ++j) cells_[at(i, j)] |= kFree;
    }
  }
}

void GridGraph::open_edges_between_free_nodes() {
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      if (!free(i, j)) continue;
      if (free(i + 1, j)) cells_[at(i, j)] |= kEastOpen;
      if (free(i, j + 1)) cells_[at(i, j)] |= kNorthOpen;
    }
}

// A wall that only touches an edge, or runs along it, closes it as well: rounding cannot tell the cases apart, and only
// edges that run along the wall itself are lost.
void GridGraph::close_edges_at_walls(const Region& space) {
  const auto range = [](double low, double high, int n) {
    return std::pair(std::max(0, static_cast<int>(std::floor(low))),
                     static_cast<int>(std::min<double>(n - 1, std::floor(high))));
  };
  for_each_wall(space, [&](const Edge& e) {
    for_each_vertical_line(e.a, e.b, columns_, [&](int i, double low, double high) {
      const auto [from, to] = range(low, high, rows_);
      for (int j = from; j <= to; ++j) cells_[at(i, j)] &= static_cast<std::uint8_t>(~kNorthOpen);
    });
    for_each_horizontal_line(e.a, e.b, rows_, [&](int j, double low, double high) {
      const auto [from, to] = range(low, high, columns_);
      for (int i = from; i <= to; ++i) cells_[at(i, j)] &= static_cast<std::uint8_t>(~kEastOpen);
    });
  });
}

void GridGraph::remove(const Cell& c) {
  close(c.i, c.j, kFree | kEastOpen | kNorthOpen);
  close(c.i - 1, c.j, kEastOpen);
  close(c.i, c.j - 1, kNorthOpen);
}

void GridGraph::add_diagonals(const Region& space) {
  open_squares();
  for_each_wall(space, [&](const Edge& e) {
    close_diagonals_at(e);
    close_squares_at(e);
  });
}

void GridGraph::open_squares() {
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      std::uint8_t& square = cells_[at(i, j)];
      square &= kFree | kEastOpen | kNorthOpen;
      if (free(i, j) && free(i + 1, j + 1)) square |= kRisingOpen;
      if (free(i + 1, j) && free(i, j + 1)) square |= kFallingOpen;
      if (passable(i, j, kEast) && passable(i, j, kNorth) && passable(i + 1, j, kNorth) && passable(i, j + 1, kEast))
        square |= kClear;
    }
}

// In the coordinates u = x + y, v = x - y + rows (from 0 on) the diagonals lie on lines of constant u or v.
void GridGraph::close_diagonals_at(const Edge& wall) {
  const auto turned = [this](const Point& p) { return Point(p.x() + p.y(), p.x() - p.y() + rows_); };
  const Point a = turned(wall.a), b = turned(wall.b);
  const int lines = columns_ + rows_;
  for_each_horizontal_line(a, b, lines, [&](int v, double low, double high) {  // x - y = v - rows: rising diagonals
    const int k = v - rows_;
    const int from = static_cast<int>(std::floor((low + k) / 2)), to = static_cast<int>(std::floor((high + k) / 2));
    for (int i = std::max(0, from); i <= std::min(columns_ - 1, to); ++i) close(i, i - k, kRisingOpen);
  });
  for_each_vertical_line(a, b, lines, [&](int u, double low, double high) {  // x + y = u: falling diagonals
    const int from = static_cast<int>(std::floor((low - rows_ + u) / 2));
    const int to = static_cast<int>(std::floor((high - rows_ + u) / 2));
    for (int i = std::max(0, from); i <= std::min(columns_ - 1, to); ++i) close(i, u - i - 1, kFallingOpen);
  });
}

// The squares that the wall meets, a column at a time.
void GridGraph::close_squares_at(const Edge& wall) {
  const Point& left = wall.a.x() < wall.b.x() ? wall.a : wall.b;
  const Point& right = wall.a.x() < wall.b.x() ? wall.b : wall.a;
  const double slope = right.x() > left.x() ? (right.y() - left.y()) / (right.x() - left.x()) : 0;
  const int last = std::min(columns_ - 1, static_cast<int>(std::floor(right.x())));
  for (int i = std::max(0, static_cast<int>(std::floor(left.x()))); i <= last; ++i) {
    const double y1 = i > left.x() ? left.y() + (i - left.x()) * slope : left.y();
    const double y2 = i + 1 < right.x() ? left.y() + (i + 1 - left.x()) * slope : right.y();
    const int bottom = std::max(0, static_cast<int>(std::floor(std::min(y1, y2) - kSlack)));
    const int top = std::min(rows_ - 1, static_cast<int>(std::floor(std::max(y1, y2) + kSlack)));
    for (int j = bottom; j <= top; ++j) close(i, j, kClear);
  }
}

bool GridGraph::straight(const Cell& from, const Cell& to) const {
  if (to.i < from.i) return straight(to, from);
  const auto [i, j] = from;
  const auto [i2, j2] = to;
  if (i == i2) {
    for (int y = std::min(j, j2); y < std::max(j, j2); ++y)
      if (!passable(i, y, kNorth)) return false;
    return free(i, j);
  }
  if (j == j2) {
    for (int x = i; x < i2; ++x)
      if (!passable(x, j, kEast)) return false;
    return free(i, j);
  }
  // The height at column x is (width j + (x - i) rise) / width, in whole numbers.
  const std::int64_t width = i2 - i, rise = j2 - j;
  const auto floor_of = [&](std::int64_t a) { return a >= 0 ? a / width : -((-a + width - 1) / width); };
  for (int x = i; x < i2; ++x) {
    const std::int64_t a = width * j + (x - i) * rise, b = a + rise;
    const std::int64_t bottom = floor_of(std::min(a, b)), top = -floor_of(-std::max(a, b));
    for (std::int64_t y = bottom; y < top; ++y)
      if (!clear(x, static_cast<int>(y))) return false;
  }
  return true;
}

Cell GridGraph::cell_of(const Point& p) const {
  const Point at = coordinates(p);
  return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
}

ConnectedComponents components_of(const GridGraph& graph) {
  return connected_components(
      graph.size(), [&](std::size_t node) { return graph.free(graph.cell(node)); },
      [&](std::size_t node, const auto& reach) {
        const Cell c = graph.cell(node);
        for (const Direction d : kAllDirections)
          if (graph.passable(c, d)) reach(graph.at(neighbour(c, d)));
      });
}

std::vector<Cell> take_component(BitGrid& grid, const Cell& cell, int reach) {
  std::vector<Cell> component{cell};
  grid.set(cell.i, cell.j, false);
  breadth_first(component, [&](const Cell& at, const auto& take) {
    for (int j = at.j - reach; j <= at.j + reach; ++j)
      for (int i = at.i - reach; i <= at.i + reach; ++i) {
        if (!grid.get(i, j)) continue;
        grid.set(i, j, false);
        take({i, j});
      }
  });
  return component;
}

BitGrid rasterise(const Region& region, const GridGraph& lattice, int parts, int margin, CellRule rule) {
  const double first = -0.5 - margin;  // lower left of the first cell
  const Point low = lattice.centre(first, first), across = lattice.centre(first + 1, first) - low;
  const double angle = math::atan2(across.y(), across.x());
  return rasterise(transformed(region, -angle, Point(0, 0)), rotated(low, -angle), lattice.side() / parts,
                   parts * (lattice.columns() + 2 * margin), parts * (lattice.rows() + 2 * margin), rule);
}

double dominant_direction(const Region& region) {
  // The mean of the edges' directions, weighted by length, on the circle of quarter turns.
  Point sum{0, 0};
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point d = ring[(k + 1) % ring.size()] - ring[k];
      const double four = 4 * math::atan2(d.y(), d.x());
      sum += d.norm() * Point(math::cos(four), math::sin(four));
    }
  });
  double angle = math::atan2(sum.y(), sum.x()) / 4;
  if (angle < 0) angle += kPi / 2;
  if (angle < 1e-9 || angle > kPi / 2 - 1e-9) angle = 0;  // on the axes but for rounding
  return angle;
}

GridGraph make_grid_graph(const Problem& problem, const LatticePlacement& placement) {
  constexpr double kMostShrinking = 1e-3;  // of a cell, where a box is a whole number of cells wide but for rounding
  Box box;
  for (const Point& p : problem.configuration_space().polygons.front().outer) box.add(rotated(p, -placement.angle));
  double side = placement.side;
  const double inset = 1e-6 * side;  // by which the first cell centres lie inside configuration space
  for (const double extent : {box.size().x(), box.size().y()}) {
    const double steps = (extent - 2 * inset) / side, whole = std::round(steps);
    if (whole >= 1 && steps < whole && whole - steps < kMostShrinking) side = (extent - 2 * inset) / whole;
  }
  box.grow(side / 2 - inset + placement.margin * side);
  const double block = side * placement.block;
  Point low = box.low + side * placement.shift;
  const double slack = 1e-9 * block;
  // A shifted grid begins a whole number of blocks earlier, so that it still spans the map.
  for (int k = 0; k < 2; ++k) low[k] -= block * std::ceil((low[k] - box.low[k] - slack) / block);
  const Point blocks = (box.high - low) / block;
  const double columns = std::ceil(blocks.x() - 1e-9) * placement.block;
  const double rows = std::ceil(blocks.y() - 1e-9) * placement.block;
  check_size(columns * rows, side, problem.map().name);
  return GridGraph(problem.configuration_space(), side, placement.angle, rotated(low, placement.angle),
                   std::max(placement.block, static_cast<int>(columns)),
                   std::max(placement.block, static_cast<int>(rows)));
}

GridGraph make_grid_graph_at(const Region& space, const std::string& map_name, const Point& node, double side,
                             double angle) {
  Box box;
  for_each_ring(space, [&](const Ring& ring) {
    for (const Point& p : ring) box.add(rotated(p, -angle));
  });
  const Point position = rotated(node, -angle);
  // Whole pairs of cells on each side, and one more because of rounding.
  const auto pairs = [&](double extent) { return std::ceil(std::max(0.0, extent) / (2 * side)) + 1; };
  const Point before(2 * pairs(position.x() - box.low.x()), 2 * pairs(position.y() - box.low.y()));
  const Point cells = before + 2 * Point(pairs(box.high.x() - position.x()), pairs(box.high.y() - position.y()));
  check_size(cells.x() * cells.y(), side, map_name);
  const Point origin = rotated(position - side * (before + Point(0.5, 0.5)), angle);
  return GridGraph(space, side, angle, origin, static_cast<int>(cells.x()), static_cast<int>(cells.y()));
}

}  // namespace oxturn

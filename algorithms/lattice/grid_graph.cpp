#include "algorithms/lattice/grid_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace oxturn {
namespace {

constexpr double kHair = 1e-9;  // of a cell: walls that near to a square count as meeting it

// A wall edge in cell coordinates, where node (i, j) is the point (i, j).
struct Edge {
  Point a, b;
};

// Calls f(k, y) for each vertical lattice line x = k that the edge meets, with the height y of the meeting.
// Vertical edges on a lattice line report both ends. `swap` exchanges the roles of x and y.
template <class F>
void for_each_line(const Edge& e, bool swap, int lines, F f) {
  const auto x = [&](const Point& p) { return swap ? p.y() : p.x(); };
  const auto y = [&](const Point& p) { return swap ? p.x() : p.y(); };
  const double low = std::min(x(e.a), x(e.b)), high = std::max(x(e.a), x(e.b));
  if (const int before = static_cast<int>(low); low > before && high < before + 1 && low > 0) return;  // most do
  const int first = std::max(0, static_cast<int>(std::ceil(low)));
  const int last = std::min(lines - 1, static_cast<int>(std::floor(high)));
  for (int k = first; k <= last; ++k) {
    if (high == low) {
      f(k, std::min(y(e.a), y(e.b)), std::max(y(e.a), y(e.b)));
    } else {
      const double t = (k - x(e.a)) / (x(e.b) - x(e.a));
      const double at = y(e.a) + t * (y(e.b) - y(e.a));
      f(k, at, at);
    }
  }
}

// Calls f(edge) for each wall edge. Made anew for each pass: walls have more corners than the lattice has nodes where
// obstacles are small.
template <class F>
void for_each_edge(const Region& space, const GridGraph& graph, F f) {
  for_each_ring(space, [&](const Ring& ring) {
    Point from = graph.coordinates(ring.back());
    for (const Point& corner : ring) {
      const Point to = graph.coordinates(corner);
      f(Edge{from, to});
      from = to;
    }
  });
}

}  // namespace

GridGraph::GridGraph(const Region& space, double side, double angle, const Point& origin, int columns, int rows)
    : side_(side),
      origin_(origin),
      across_(std::cos(angle), std::sin(angle)),
      up_(perpendicular(across_)),
      columns_(columns),
      rows_(rows),
      cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {
  // Free nodes: parity of the walls below, one vertical line at a time. An edge owns its left end only.
  std::vector<std::vector<double>> walls(static_cast<std::size_t>(columns));
  for_each_edge(space, *this, [&](const Edge& e) {
    const double low = std::min(e.a.x(), e.b.x()), high = std::max(e.a.x(), e.b.x());
    if (low == high) return;
    for_each_line(e, false, columns, [&](int i, double y, double) {
      if (i != high) walls[static_cast<std::size_t>(i)].push_back(y);
    });
  });
  for (int i = 0; i < columns; ++i) {
    std::vector<double>& w = walls[static_cast<std::size_t>(i)];
    std::sort(w.begin(), w.end());
    for (std::size_t k = 0; k + 1 < w.size(); k += 2) {
      const int from = std::max(0, static_cast<int>(std::ceil(w[k])));
      const int to = std::min(rows - 1, static_cast<int>(std::floor(w[k + 1])));
      for (int j = from; j <= to; ++j) cells_[at(i, j)] |= kFree;
    }
  }

  // Open edges: between free nodes, less those that a wall meets. A wall that only touches a lattice line
  // from outside (or runs along it) is taken as closing it: rounding cannot tell, and nothing but a way along
  // the very wall is lost.
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      if ((cells_[at(i, j)] & kFree) == 0) continue;
      if (i + 1 < columns && (cells_[at(i + 1, j)] & kFree) != 0) cells_[at(i, j)] |= kEastOpen;
      if (j + 1 < rows && (cells_[at(i, j + 1)] & kFree) != 0) cells_[at(i, j)] |= kNorthOpen;
    }
  for_each_edge(space, *this, [&](const Edge& e) {
    for_each_line(e, false, columns, [&](int i, double low, double high) {
      for (int j = std::max(0, static_cast<int>(std::floor(low))); j <= std::min<double>(rows - 1, std::floor(high));
           ++j)
        cells_[at(i, j)] &= static_cast<std::uint8_t>(~kNorthOpen);
    });
    for_each_line(e, true, rows, [&](int j, double low, double high) {
      for (int i = std::max(0, static_cast<int>(std::floor(low))); i <= std::min<double>(columns - 1, std::floor(high));
           ++i)
        cells_[at(i, j)] &= static_cast<std::uint8_t>(~kEastOpen);
    });
  });
}

// In coordinates u = x + y, v = x - y the diagonals are lines u = k or v = k, with a node at every second place.
void GridGraph::look_between(const Region& space) {
  const auto close = [&](int i, int j, std::uint8_t bits) {
    if (inside(i, j)) cells_[at(i, j)] &= static_cast<std::uint8_t>(~bits);
  };
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      std::uint8_t& square = cells_[at(i, j)];
      square &= kFree | kEastOpen | kNorthOpen;
      if (free(i, j) && free(i + 1, j + 1)) square |= kRisingOpen;
      if (free(i + 1, j) && free(i, j + 1)) square |= kFallingOpen;
      if (passable(i, j, kEast) && passable(i, j, kNorth) && passable(i + 1, j, kNorth) && passable(i, j + 1, kEast))
        square |= kClear;
    }
  const int both = columns_ + rows_;
  for_each_edge(space, *this, [&](const Edge& e) {
    // Shifted by the number of rows, so that v counts from 0.
    const Edge turned{{e.a.x() + e.a.y(), e.a.x() - e.a.y() + rows_}, {e.b.x() + e.b.y(), e.b.x() - e.b.y() + rows_}};
    for_each_line(turned, true, both, [&](int v, double low, double high) {  // x - y = v - rows: rising
      const int k = v - rows_;
      const int from = static_cast<int>(std::floor((low + k) / 2)), to = static_cast<int>(std::floor((high + k) / 2));
      for (int i = std::max(0, from); i <= std::min(columns_ - 1, to); ++i) close(i, i - k, kRisingOpen);
    });
    for_each_line(turned, false, both, [&](int u, double low, double high) {  // x + y = u: falling
      const int from = static_cast<int>(std::floor((low - rows_ + u) / 2)),
                to = static_cast<int>(std::floor((high - rows_ + u) / 2));
      for (int i = std::max(0, from); i <= std::min(columns_ - 1, to); ++i) close(i, u - i - 1, kFallingOpen);
    });
    // Squares that it meets, a column at a time.
    const Point& left = e.a.x() < e.b.x() ? e.a : e.b;
    const Point& right = e.a.x() < e.b.x() ? e.b : e.a;
    const double slope = right.x() > left.x() ? (right.y() - left.y()) / (right.x() - left.x()) : 0;
    const int last = std::min(columns_ - 1, static_cast<int>(std::floor(right.x())));
    for (int i = std::max(0, static_cast<int>(std::floor(left.x()))); i <= last; ++i) {
      const double y1 = i > left.x() ? left.y() + (i - left.x()) * slope : left.y();
      const double y2 = i + 1 < right.x() ? left.y() + (i + 1 - left.x()) * slope : right.y();
      const int top = std::min(rows_ - 1, static_cast<int>(std::floor(std::max(y1, y2) + kHair)));
      for (int j = std::max(0, static_cast<int>(std::floor(std::min(y1, y2) - kHair))); j <= top; ++j)
        close(i, j, kClear);
    }
  });
}

bool GridGraph::straight(int i, int j, int i2, int j2) const {
  if (i2 < i) return straight(i2, j2, i, j);
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
  // Between columns x and x + 1 the way runs from (i2 - i) j + (x - i) (j2 - j), in parts of i2 - i, to the next.
  const std::int64_t parts = i2 - i, rise = j2 - j;
  const auto floor_of = [&](std::int64_t a) { return a >= 0 ? a / parts : -((-a + parts - 1) / parts); };
  for (int x = i; x < i2; ++x) {
    const std::int64_t a = parts * j + (x - i) * rise, b = a + rise;
    const std::int64_t bottom = floor_of(std::min(a, b)), top = -floor_of(-std::max(a, b));
    for (std::int64_t y = bottom; y < top; ++y)
      if (!clear(x, static_cast<int>(y))) return false;
  }
  return true;
}

BitGrid rasterise(const Region& region, const GridGraph& lattice, int parts, int margin, CellRule rule) {
  const double first = -0.5 - margin;  // the corner of the first cell
  const Point corner = lattice.centre(first, first), across = lattice.centre(first + 1, first) - corner;
  const double angle = std::atan2(across.y(), across.x());
  return rasterise(transformed(region, -angle, Point(0, 0)), rotated(corner, -angle), lattice.side() / parts,
                   parts * (lattice.columns() + 2 * margin), parts * (lattice.rows() + 2 * margin), rule);
}

double dominant_direction(const Region& region) {
  // Length-weighted mean of the edges' directions on the circle of quarter turns.
  Point sum{0, 0};
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point d = ring[(k + 1) % ring.size()] - ring[k];
      const double four = 4 * std::atan2(d.y(), d.x());
      sum += d.norm() * Point(std::cos(four), std::sin(four));
    }
  });
  double angle = std::atan2(sum.y(), sum.x()) / 4;
  if (angle < 0) angle += kPi / 2;
  if (angle < 1e-9 || angle > kPi / 2 - 1e-9) angle = 0;  // on the axes but for rounding
  return angle;
}

namespace {
void check_size(double cells, double side, const std::string& map_name) {
  if (cells > 1e8)
    throw std::invalid_argument(fmt::format(
        "a grid of cells {} m wide over '{}' would have {:.3g} cells, more than 1e8; give a larger cell_size", side,
        map_name, cells));
}
}  // namespace

double cell_side(double given, const Robot& robot) { return given > 0 ? given : robot.tool_width / std::sqrt(2.0); }

GridGraph make_grid_graph(const Problem& problem, const GridSettings& settings, double side, int multiple, int margin) {
  const double angle =
      settings.align == "edges" ? dominant_direction(problem.map().free) + settings.turn : settings.turn;
  Box box;
  for (const Point& p : problem.configuration_space().polygons.front().outer) box.add(rotated(p, -angle));
  // Half a cell out, less a hair: the first cell centres stand just inside configuration space. Where a room is a
  // whole number of cells wide but for rounding, cells give way, not the last row.
  const double hair = 1e-6 * side;
  for (const double extent : {box.size().x(), box.size().y()}) {
    const double steps = (extent - 2 * hair) / side, whole = std::round(steps);
    if (whole >= 1 && steps < whole && whole - steps < 1e-3) side = (extent - 2 * hair) / whole;
  }
  box.grow(side / 2 - hair + margin * side);
  const double block = side * multiple;
  Point low = box.low + side * Point(settings.shift_x, settings.shift_y);
  const double slack = 1e-9 * block;
  // A shifted grid begins a whole number of blocks earlier, so that it still spans the map.
  for (int k = 0; k < 2; ++k) low[k] -= block * std::ceil((low[k] - box.low[k] - slack) / block);
  const Point blocks = (box.high - low) / block;
  const double columns = std::ceil(blocks.x() - 1e-9) * multiple, rows = std::ceil(blocks.y() - 1e-9) * multiple;
  check_size(columns * rows, side, problem.map().name);
  return GridGraph(problem.configuration_space(), side, angle, rotated(low, angle),
                   std::max(multiple, static_cast<int>(columns)), std::max(multiple, static_cast<int>(rows)));
}

GridGraph make_grid_graph_at(const Region& space, const std::string& map_name, const Point& node, double side,
                             double angle) {
  Box box;
  for_each_ring(space, [&](const Ring& ring) {
    for (const Point& p : ring) box.add(rotated(p, -angle));
  });
  const Point place = rotated(node, -angle);
  // Whole pairs of cells on each side; one more, so that rounding leaves none out.
  const auto pairs = [&](double extent) { return std::ceil(std::max(0.0, extent) / (2 * side)) + 1; };
  const Point before(2 * pairs(place.x() - box.low.x()), 2 * pairs(place.y() - box.low.y()));
  const Point cells = before + 2 * Point(pairs(box.high.x() - place.x()), pairs(box.high.y() - place.y()));
  check_size(cells.x() * cells.y(), side, map_name);
  const Point origin = rotated(place - side * (before + Point(0.5, 0.5)), angle);
  return GridGraph(space, side, angle, origin, static_cast<int>(cells.x()), static_cast<int>(cells.y()));
}

}  // namespace oxturn

#include "metrics/level_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "base/graph_search.hpp"
#include "base/math.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/overlay/minkowski.hpp"
#include "geometry/raster.hpp"
#include "geometry/tether/geodesic_field.hpp"

namespace oxturn {
namespace {

constexpr double kLarger = 1e-3;      // tool widths by which configuration space is taken too large
constexpr double kLeastArea = 1e-13;  // of a piece, in cells: smaller ones are rounding
constexpr double kRounding = 1e-9;    // tool widths
constexpr double kNarrow = 1.05;      // tool widths: the side of the square that does not fit
constexpr double kLongEnough = 2.5;   // tool widths: a shorter part is worth no count

/// A convex polygon of a few vertices: a triangle clipped by a cell.
struct Piece {
  std::array<Point, 8> at;
  std::size_t size = 0;

  /// Keeps the part with sign * coordinate >= sign * bound.
  void clip(int axis, double bound, int sign) {
    std::array<Point, 8> kept;
    std::size_t n = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Point &p = at[i], &q = at[i + 1 < size ? i + 1 : 0];
      const double a = sign * (p[axis] - bound), b = sign * (q[axis] - bound);
      if (a >= 0 && n < kept.size()) kept[n++] = p;
      if (((a > 0 && b < 0) || (a < 0 && b > 0)) && n < kept.size()) {
        kept[n] = p + a / (a - b) * (q - p);
        kept[n++][axis] = bound;
      }
    }
    size = n;
    std::copy_n(kept.begin(), n, at.begin());
  }
  double area() const {
    double twice = 0;
    for (std::size_t i = 2; i < size; ++i) twice += cross(at[i - 1] - at[0], at[i] - at[0]);
    return twice / 2;
  }
  Point middle() const {
    Point sum(0, 0);
    for (std::size_t i = 0; i < size; ++i) sum += at[i];
    return sum / static_cast<double>(size);
  }
  double reach(const Point& from) const {
    double most = 0;
    for (std::size_t i = 0; i < size; ++i) most = std::max(most, distance(from, at[i]));
    return most;
  }
};

/// Calls f(column, row, piece) for the parts of each triangle, whose points are in cells.
template <class F>
void for_each_piece(const Mesh& mesh, F f) {
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    Piece triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle.at[triangle.size++] = mesh.vertex(static_cast<std::int32_t>(t), k);
    const auto range = [](const Piece& piece, int axis) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t i = 0; i < piece.size; ++i) {
        low = std::min(low, piece.at[i][axis]);
        high = std::max(high, piece.at[i][axis]);
      }
      return std::pair(static_cast<int>(std::floor(low)), static_cast<int>(std::floor(high)));
    };
    const auto [bottom, top] = range(triangle, 1);
    for (int j = bottom; j <= top; ++j) {
      Piece strip = triangle;
      strip.clip(1, j, 1);
      strip.clip(1, j + 1, -1);
      if (strip.size < 3) continue;
      const auto [left, right] = range(strip, 0);
      for (int i = left; i <= right; ++i) {
        Piece piece = strip;
        piece.clip(0, i, 1);
        piece.clip(0, i + 1, -1);
        if (piece.size >= 3 && piece.area() > kLeastArea) f(i, j, piece);
      }
    }
  }
}

double longest_edge_angle(const Region& region) {
  double longest = 0, angle = 0;
  for_each_edge(region, [&](const Point& a, const Point& b) {
    if (!(distance(a, b) > longest * (1 + kRounding))) return;
    longest = distance(a, b);
    angle = math::atan2(b.y() - a.y(), b.x() - a.x());
  });
  return angle;
}

/// From metres to cells.
class Frame {
 public:
  Frame(const Region& target, double cell) : angle_(-longest_edge_angle(target)), scale_(1 / cell) {}
  Point operator()(const Point& p) const { return rotated(scale_ * p, angle_) - low_; }
  Region operator()(Region region) const {
    for_each_ring(region, [&](Ring& ring) {
      for (Point& p : ring) p = (*this)(p);
    });
    return region;
  }
  /// Shifts what follows, so that `region` begins half a cell right of and above the origin.
  void begin_at(const Region& region) { low_ = bounding_box((*this)(region)).low - Point(0.5, 0.5); }

 private:
  double angle_, scale_;
  Point low_{0, 0};
};

/// The cells of which `sum` of the square of 2 k + 1 cells about them is `wanted`.
BitGrid filtered(const BitGrid& grid, int k, const std::function<bool(int)>& wanted) {
  const auto columns = static_cast<std::size_t>(grid.columns) + 1;
  std::vector<int> sums(columns * (static_cast<std::size_t>(grid.rows) + 1), 0);  // of the cells below and to the left
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      const std::size_t s = static_cast<std::size_t>(j + 1) * columns + static_cast<std::size_t>(i + 1);
      sums[s] = sums[s - 1] + sums[s - columns] - sums[s - columns - 1] + grid.bits[grid.at(i, j)];
    }
  const auto sum = [&](int i, int j) {
    return sums[static_cast<std::size_t>(std::clamp(j, 0, grid.rows)) * columns +
                static_cast<std::size_t>(std::clamp(i, 0, grid.columns))];
  };
  BitGrid result(grid.origin, grid.cell, grid.columns, grid.rows);
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      result.set(i, j,
                 wanted(sum(i + k + 1, j + k + 1) - sum(i - k, j + k + 1) - sum(i + k + 1, j - k) + sum(i - k, j - k)));
  return result;
}

/// Does the region, whose points are in cells, have a long part into which no square about as wide as the tool fits?
bool narrow_somewhere(const Region& space, double side, int columns, int rows) {
  const int k = static_cast<int>(0.5 * kNarrow / side);
  const BitGrid all = rasterise(space, {0, 0}, 1, columns, rows, CellRule::touches);
  const BitGrid middles = filtered(all, k, [&](int sum) { return sum == (2 * k + 1) * (2 * k + 1); });
  const BitGrid wide = filtered(middles, k, [](int sum) { return sum > 0; });
  const ConnectedComponents narrow = connected_components(
      all.bits.size(), [&](std::size_t c) { return all.bits[c] != 0 && wide.bits[c] == 0; },
      [&](std::size_t c, auto reach) {
        const int i = static_cast<int>(c) % columns, j = static_cast<int>(c) / columns;
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di)
            if (all.inside(i + di, j + dj)) reach(all.at(i + di, j + dj));
      });
  std::vector<Box> boxes(static_cast<std::size_t>(narrow.count));
  for (std::size_t c = 0; c < all.bits.size(); ++c)
    if (narrow.of[c] != ConnectedComponents::kNone)
      boxes[static_cast<std::size_t>(narrow.of[c])].add(
          all.centre(static_cast<int>(c) % columns, static_cast<int>(c) / columns));
  return std::ranges::any_of(boxes, [&](const Box& box) { return box.size().maxCoeff() * side > kLongEnough; });
}

}  // namespace

Region wide_space(const Problem& problem) {
  const Robot& robot = problem.robot();
  const double radius = robot.radius - kLarger * robot.tool_width - problem.tolerance();
  if (!robot.footprint.empty() || !(radius > 0)) return {};
  const Region all = erode(problem.map().free, radius, kLarger * robot.tool_width, Bound::outside);
  for (const Polygon& polygon : all.polygons)
    if (Region one{{polygon}}; contains(one, problem.start())) return one;
  return {};
}

std::optional<LevelCells> level_cells(const Problem& problem, double side, double most) {
  const double cell = side * problem.robot().tool_width;
  Frame frame(problem.target(), cell);
  const Box rough = bounding_box(frame(problem.target()));
  if (rough.size().x() * rough.size().y() > most) return std::nullopt;
  Region space = wide_space(problem);
  if (space.empty()) return std::nullopt;
  Region both = space;
  both.polygons.insert(both.polygons.end(), problem.target().polygons.begin(), problem.target().polygons.end());
  frame.begin_at(both);
  const Point high = bounding_box(frame(both)).high;
  if (high.x() * high.y() > most) return std::nullopt;
  LevelCells result;
  result.side = side;
  result.columns = static_cast<int>(high.x()) + 1, result.rows = static_cast<int>(high.y()) + 1;
  const auto size = static_cast<std::size_t>(result.columns) * static_cast<std::size_t>(result.rows);
  const auto index = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(result.columns) + static_cast<std::size_t>(i);
  };

  space = frame(std::move(space));
  if (!narrow_somewhere(space, side, result.columns, result.rows)) return std::nullopt;
  const GeodesicField field(space, frame(problem.start()), {}, kRounding / side);
  result.at.assign(size, LevelCells::kNone);
  bool reached = true;
  for_each_piece(Mesh(space), [&](int i, int j, const Piece& piece) {
    const Point middle = piece.middle();
    const double away = side * field.distance(middle), reach = side * piece.reach(middle) + kRounding;
    reached = reached && std::isfinite(away);
    std::int32_t& at = result.at[index(i, j)];
    if (at == LevelCells::kNone) {
      at = static_cast<std::int32_t>(result.cells.size());
      result.cells.push_back({i, j, away - reach, away + reach});
    }
    LevelCells::Cell& c = result.cells[static_cast<std::size_t>(at)];
    c.low = std::min(c.low, away - reach);
    c.high = std::max(c.high, away + reach);
  });
  const Point start = frame(problem.start());
  result.start = result.cell(static_cast<int>(std::floor(start.x())), static_cast<int>(std::floor(start.y())));
  if (!reached || result.start == LevelCells::kNone) return std::nullopt;

  std::vector<double> covered(size, 0);
  for_each_piece(Mesh(frame(problem.target())),
                 [&](int i, int j, const Piece& piece) { covered[index(i, j)] += piece.area() * side * side; });
  for (int j = 0; j < result.rows; ++j)
    for (int i = 0; i < result.columns; ++i)
      if (covered[index(i, j)] > 0) result.parts.push_back({i, j, covered[index(i, j)]});
  return result;
}

}  // namespace oxturn

#include "algorithms/smoothing/uncovered_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/sorting.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

constexpr double kSpacing = 1.0 / 8;  // tool widths
constexpr double kGolden = 0.618;     // of all points, from one to the next

/// first .. first + n - 1, those one after the other far apart.
std::vector<std::size_t> spread(std::size_t first, std::size_t n) {
  auto step = std::max<std::size_t>(1, static_cast<std::size_t>(kGolden * static_cast<double>(n)));
  while (std::gcd(step, n) != 1) ++step;
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < n; ++k) order.push_back(first + k * step % n);
  return order;
}

}  // namespace

UncoveredPoints::UncoveredPoints(const Region& uncovered, double width, double least) : width_(width) {
  std::vector<std::pair<double, const Polygon*>> order;
  for (const Polygon& piece : uncovered.polygons) {
    const double size = oxturn::area(piece);
    area_ += size;
    if (size >= least) order.push_back({size, &piece});
  }
  std::ranges::stable_sort(order, [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [size, piece] : order) add(*piece);
  covered_.assign(points_.size(), false);
  grid_ = UniformGrid(points_.size(), [&](std::size_t k) { return std::array{points_[k]}; });
}

void UncoveredPoints::add(const Polygon& piece) {
  const double spacing = kSpacing * width_;
  const std::size_t first = points_.size();
  const auto add_ring = [&](const Ring& ring) {
    for_each_edge(ring, [&](const Point& a, const Point& b) {
      const double parts = std::max(1.0, std::ceil(distance(a, b) / spacing));
      for (double k = 0; k < parts; ++k) points_.push_back(lerp(a, b, k / parts));
    });
  };
  add_ring(piece.outer);
  for (const Ring& hole : piece.holes) add_ring(hole);
  const Box box = bounding_box(piece.outer);
  const EdgeIndex inside(Region{{piece}});
  const double columns = std::floor(box.size().x() / spacing), rows = std::floor(box.size().y() / spacing);
  for (double j = 1; j <= rows; ++j)
    for (double i = 1; i <= columns; ++i)
      if (const Point p = box.low + spacing * Point(i - 0.5, j - 0.5); inside.contains(p)) points_.push_back(p);
  const double each = oxturn::area(piece) / static_cast<double>(points_.size() - first);
  pieces_.push_back(spread(first, points_.size() - first));
  share_.resize(points_.size(), each);
}

/// Calls f(k) for the uncovered points that the line covers, until it is true.
template <class F>
bool UncoveredPoints::visit(const Polyline& line, F f) const {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto look = [&](std::size_t cell) {
      for (const std::uint32_t k : grid_.items(cell))
        if (!covered_[k] && distance_to_segment(points_[k], line[i - 1], line[i]) <= kCoveredReach * width_ && f(k))
          return true;
      return false;
    };
    if (grid_.visit(std::array{line[i - 1], line[i]}, kCoveredReach * width_, look)) return true;
  }
  return false;
}

double UncoveredPoints::cover(const Polyline& line) {
  double gained = 0;
  visit(line, [&](std::uint32_t k) {
    covered_[k] = true;
    gained += share_[k];
    return false;
  });
  area_ -= gained;
  return gained;
}

double UncoveredPoints::gain(const std::vector<Polyline>& lines) const {
  std::vector<std::uint32_t> found;
  for (const Polyline& line : lines)
    visit(line, [&](std::uint32_t k) {
      found.push_back(k);
      return false;
    });
  sort_unique(found);
  double sum = 0;
  for (const std::uint32_t k : found) sum += share_[k];
  return sum;
}

bool UncoveredPoints::covers_any(const Polyline& line) const {
  return visit(line, [](std::uint32_t) { return true; });
}

}  // namespace oxturn

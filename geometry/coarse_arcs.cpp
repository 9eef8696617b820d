// Method      Ring by ring, greedily: from an edge that is kept, the farthest edge whose line may follow. Two new
//             stretches cannot meet: each lies within the tolerance of the boundary that it replaces, and there no
//             other boundary is nearer than that.
#include "geometry/coarse_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/predicates.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

constexpr double kSeam = 3e-5;    // of the reach: above what rounded vertices turn short edges by
constexpr double kInside = 1e-6;  // of the tolerance: new vertices move into free space, so that rounding costs nothing

class ArcCoarsener {
 public:
  ArcCoarsener(const Region& region, double tolerance, double reach, const std::optional<Point>& kept)
      : tolerance_(tolerance), reach_(reach) {
    for_each_edge(region, [&](const Point& a, const Point& b) { edges_.push_back({a, b}); });
    if (kept) edges_.push_back({*kept, *kept});  // as if it were an obstacle
    grid_ = UniformGrid(edges_.size(), [&](std::size_t e) { return edges_[e]; });
  }

  /// Rings in the order of the region's.
  Ring next(const Ring& ring) {
    size_ = ring.size();
    edge_.clear();
    const std::size_t start = first_kept(ring);
    for (std::size_t k = 0; k <= size_; ++k) edge_.push_back(first_ + (start + k) % size_);
    Ring out;
    for (std::size_t i = 0; i < size_;) {
      std::size_t next = i + 1;
      Point corner = to(i);
      for (std::size_t j = i + 2; j <= size_ && reflex_[edge_[j - 1] - first_]; ++j) {
        const std::optional<Point> wider = corner_of(i, j);
        if (!wider) break;
        next = j;
        corner = *wider;
      }
      if (next > i + 1 && crowded(i, next, corner)) {
        for (std::size_t k = i; k < next; ++k) out.push_back(to(k));
      } else {
        out.push_back(corner);
      }
      i = next;
    }
    first_ += size_;
    return out.size() < 3 || out.size() == size_ ? ring : out;
  }

 private:
  using Edge = std::array<Point, 2>;

  /// Marks the edges with two reflex ends. The start is one without, or the longest.
  std::size_t first_kept(const Ring& ring) {
    reflex_.assign(size_, true);
    for (std::size_t k = 0; k < size_; ++k) {
      const std::size_t before = (k + size_ - 1) % size_;
      if (orientation(ring[before], ring[k], ring[(k + 1) % size_]) >= 0) reflex_[before] = reflex_[k] = false;
    }
    const auto found = std::find(reflex_.begin(), reflex_.end(), false);
    if (found != reflex_.end()) return static_cast<std::size_t>(found - reflex_.begin());
    const auto shorter = [](const Edge& e, const Edge& f) {
      return (e[1] - e[0]).squaredNorm() < (f[1] - f[0]).squaredNorm();
    };
    const auto begin = edges_.begin() + static_cast<std::ptrdiff_t>(first_);
    return static_cast<std::size_t>(std::max_element(begin, begin + static_cast<std::ptrdiff_t>(size_), shorter) -
                                    begin);
  }

  const Point& from(std::size_t k) const { return edges_[edge_[k]][0]; }
  const Point& to(std::size_t k) const { return edges_[edge_[k]][1]; }
  Point normal(std::size_t k) const { return perpendicular(to(k) - from(k)).normalized(); }  // into free space

  /// Where edges i and j meet when all between them are dropped; nullopt: they may not be.
  std::optional<Point> corner_of(std::size_t i, std::size_t j) const {
    const Point u = to(i) - from(i), v = to(j) - from(j);
    const double turn = cross(u, v);
    if (!(turn < 0) || u.dot(v) <= 0) return std::nullopt;
    const Point corner = to(i) + cross(from(j) - to(i), v) / turn * u;
    double away = std::numeric_limits<double>::infinity();
    for (std::size_t k = i + 1; k < j; ++k) away = std::min(away, distance_to_segment(corner, from(k), to(k)));
    if (away > tolerance_) return std::nullopt;
    if (std::isfinite(reach_) && !covered(i, j, corner)) return std::nullopt;
    return corner + kInside * tolerance_ * (normal(i) + normal(j));
  }
  /// Along the two edges the disc covers what lies in front of their lines moved back by its radius. Nothing in front
  /// of a dropped edge's line lies behind both, if the point where these two meet does not.
  bool covered(std::size_t i, std::size_t j, const Point& corner) const {
    const Point m = normal(i), n = normal(j), deepest = corner - reach_ * (m + n) / (1 + m.dot(n));
    for (std::size_t k = i + 1; k < j; ++k)
      if (normal(k).dot(deepest - from(k)) + reach_ > kSeam * reach_) return false;
    return true;
  }

  /// Does another boundary come within the tolerance of what is cut off? Edges of the ring next to the dropped ones
  /// bend away.
  bool crowded(std::size_t i, std::size_t j, const Point& corner) const {
    const std::array cut_off{to(i), corner, from(j)};
    std::size_t low = i, high = j;
    while (low > 0 && reflex_[edge_[low] - first_]) --low;
    while (high < size_ && reflex_[edge_[high] - first_]) ++high;
    const auto own = [&](std::size_t e) {
      if (e < first_ || e >= first_ + size_) return false;
      const std::size_t k = (e + size_ - edge_[0]) % size_;
      return (k >= low && k <= high) || (high == size_ && k == 0);
    };
    return grid_.visit_items(cut_off, tolerance_, [&](std::size_t e) { return !own(e) && near(edges_[e], cut_off); });
  }
  bool near(const Edge& e, const std::array<Point, 3>& triangle) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = triangle[k], &b = triangle[(k + 1) % 3];
      if (distance_to_segment(a, e[0], e[1]) <= tolerance_ || distance_to_segment(e[0], a, b) <= tolerance_ ||
          distance_to_segment(e[1], a, b) <= tolerance_ ||
          (orientation(a, b, e[0]) != orientation(a, b, e[1]) &&
           orientation(e[0], e[1], a) != orientation(e[0], e[1], b)))
        return true;
    }
    return false;
  }

  double tolerance_, reach_;
  std::vector<Edge> edges_;
  UniformGrid grid_;
  // Of the present ring: its first edge, its size, its edges from one that is kept to the same again, and by edge
  // whether both ends are reflex.
  std::size_t first_ = 0, size_ = 0;
  std::vector<std::size_t> edge_;
  std::vector<bool> reflex_;
};

}  // namespace

Region with_coarser_arcs(const Region& region, double tolerance, double reach, const std::optional<Point>& kept) {
  ArcCoarsener coarsener(region, tolerance, reach, kept);
  Region out = region;
  for_each_ring(out, [&](Ring& ring) { ring = coarsener.next(ring); });
  return out;
}

}  // namespace oxturn

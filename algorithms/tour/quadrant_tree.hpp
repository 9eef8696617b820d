/// Nearest points in each of the four quadrants round a position.
///
///   const QuadrantTree tree(points);
///   for (std::size_t i : tree.nearest(p, [&](std::size_t i) { return i != own; })) ...      // up to two a quadrant
///
/// A k-d tree (Bentley 1975). Build O(n log n); a query O(log n) on average, O(sqrt n) where a quadrant is empty.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

class QuadrantTree {
 public:
  explicit QuadrantTree(std::vector<Point> points) : points_(std::move(points)), order_(points_.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    build(0, order_.size(), 0);
  }

  /// The two nearest points in each quadrant for which accept(index) is true.
  template <class Accept>
  std::vector<std::size_t> nearest(const Point& p, Accept accept) const {
    std::vector<std::size_t> all;
    for (const bool right : {false, true})
      for (const bool above : {false, true}) {
        Search search{p, {right, above}, {kNone, kNone}, {0, 0}};
        visit(search, accept, 0, order_.size(), 0);
        for (std::size_t k = 0; k < 2; ++k)
          if (search.square[k] < kNone) all.push_back(search.found[k]);
      }
    return all;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  struct Search {
    Point p;
    std::array<bool, 2> positive;  // the quadrant: at or above p's coordinate, or below it
    std::array<double, 2> square;  // of the distances of the two nearest so far
    std::array<std::size_t, 2> found;
    bool holds(const Point& q) const { return (q.x() >= p.x()) == positive[0] && (q.y() >= p.y()) == positive[1]; }
    void offer(std::size_t i, double d) {
      if (d >= square[1]) return;
      square[1] = d;
      found[1] = i;
      if (d >= square[0]) return;
      std::swap(square[0], square[1]);
      std::swap(found[0], found[1]);
    }
  };

  void build(std::size_t low, std::size_t high, int axis) {
    if (high - low < 2) return;
    const std::size_t middle = (low + high) / 2;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(low), at(middle), at(high), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
    });
    build(low, middle, 1 - axis);
    build(middle + 1, high, 1 - axis);
  }

  template <class Accept>
  void visit(Search& search, Accept& accept, std::size_t low, std::size_t high, int axis) const {
    if (low >= high) return;
    const std::size_t middle = (low + high) / 2, i = order_[middle];
    const Point& q = points_[i];
    if (search.holds(q) && accept(i)) search.offer(i, (q - search.p).squaredNorm());
    const double ahead = search.p[axis] - q[axis];  // of the splitting line
    const bool positive = search.positive[static_cast<std::size_t>(axis)];
    const auto lower = [&] {
      if ((ahead <= 0 || !positive) && (ahead <= 0 || ahead * ahead < search.square[1]))
        visit(search, accept, low, middle, 1 - axis);
    };
    const auto upper = [&] {
      if ((ahead >= 0 || positive) && (ahead >= 0 || ahead * ahead < search.square[1]))
        visit(search, accept, middle + 1, high, 1 - axis);
    };
    if (ahead <= 0) {
      lower();
      upper();
    } else {
      upper();
      lower();
    }
  }

  std::vector<Point> points_;
  std::vector<std::uint32_t> order_;  // a balanced tree: the root in the middle, its subtrees on either side
};

}  // namespace oxturn

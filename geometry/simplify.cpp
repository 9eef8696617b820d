// Method      Corners that are convex seen from free space are dropped in order of the error that makes, which cuts a
//             triangle off free space; reflex corners only when they have become exactly collinear. A corner stays
//             if its triangle holds any other corner, so rings never touch or cross.
// Complexity  O(n log n) plus the dropped corners that each new edge stands for.
#include <algorithm>
#include <cmath>
#include <queue>

#include "geometry/predicates.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

class Simplifier {
 public:
  Simplifier(const Region& region, double tolerance) : tolerance_(tolerance) {
    for_each_ring(region, [&](const Ring& ring) {
      const auto first = static_cast<std::uint32_t>(at_.size()), n = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t k = 0; k < n; ++k) {
        at_.push_back(ring[k]);
        previous_.push_back(first + (k + n - 1) % n);
        next_.push_back(first + (k + 1) % n);
        ring_.push_back(static_cast<std::uint32_t>(size_.size()));
      }
      size_.push_back(n);
      first_.push_back(first);
    });
    live_.assign(at_.size(), true);
    version_.assign(at_.size(), 0);
    dropped_.resize(at_.size());
    index_corners();
  }

  void run() {
    for (std::uint32_t v = 0; v < at_.size(); ++v) consider(v);
    while (!queue_.empty()) {
      const Candidate c = queue_.top();
      queue_.pop();
      if (!live_[c.corner] || version_[c.corner] != c.version) continue;
      if (size_[ring_[c.corner]] <= 3 || !empty_triangle(c.corner)) continue;
      drop(c.corner);
    }
  }

  Region result(const Region& region) const {
    Region out;
    std::size_t ring = 0;
    const auto rebuilt = [&]() {
      Ring points;
      std::uint32_t v = first_[ring];
      const std::uint32_t end = v + count_of(ring);
      while (v < end && !live_[v]) ++v;
      const std::uint32_t start = v;
      do {
        points.push_back(at_[v]);
        v = next_[v];
      } while (v != start);
      ++ring;
      return points;
    };
    for (const Polygon& p : region.polygons) {
      Polygon q;
      q.outer = rebuilt();
      for (std::size_t k = 0; k < p.holes.size(); ++k) q.holes.push_back(rebuilt());
      out.polygons.push_back(std::move(q));
    }
    return out;
  }

 private:
  struct Candidate {
    double error;
    std::uint32_t corner, version;
    bool operator<(const Candidate& o) const {  // the queue's top is the least error, then the lowest number
      return error != o.error ? error > o.error : corner > o.corner;
    }
  };

  std::uint32_t count_of(std::size_t ring) const {
    return (ring + 1 < first_.size() ? first_[ring + 1] : static_cast<std::uint32_t>(at_.size())) - first_[ring];
  }

  void index_corners() {
    for (const Point& p : at_) box_.add(p);
    if (at_.empty()) return;
    const Point size = box_.size();
    cell_ =
        std::max({std::sqrt(size.x() * size.y() / static_cast<double>(at_.size())), size.maxCoeff() / 4096, 1e-300});
    columns_ = static_cast<int>(size.x() / cell_) + 1;
    rows_ = static_cast<int>(size.y() / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::uint32_t v = 0; v < at_.size(); ++v) cells_[cell_of(column(at_[v].x()), row(at_[v].y()))].push_back(v);
  }
  int column(double x) const { return std::clamp(static_cast<int>((x - box_.low.x()) / cell_), 0, columns_ - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - box_.low.y()) / cell_), 0, rows_ - 1); }
  std::size_t cell_of(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }

  void consider(std::uint32_t v) {
    ++version_[v];
    const Point &u = at_[previous_[v]], &w = at_[next_[v]];
    const int turn = orientation(u, at_[v], w);
    if (turn < 0) return;
    double error = distance_to_segment(at_[v], u, w);
    for (const std::uint32_t edge : {previous_[v], v})  // dropped_[a]: what the edge from a on stands for
      for (const std::uint32_t p : dropped_[edge]) error = std::max(error, distance_to_segment(at_[p], u, w));
    if (turn == 0 || error <= tolerance_) queue_.push({turn == 0 ? 0 : error, v, version_[v]});
  }

  // No other corner in the closed triangle. Collinear corners have none, but then nothing may lie on the edge: two
  // rings that touch there touch as before.
  bool empty_triangle(std::uint32_t v) const {
    const std::uint32_t a = previous_[v], b = next_[v];
    if (orientation(at_[a], at_[v], at_[b]) == 0) return true;
    Box box;
    for (const std::uint32_t p : {a, v, b}) box.add(at_[p]);
    for (int j = row(box.low.y()); j <= row(box.high.y()); ++j)
      for (int i = column(box.low.x()); i <= column(box.high.x()); ++i)
        for (const std::uint32_t p : cells_[cell_of(i, j)])
          if (live_[p] && p != a && p != v && p != b && box.contains(at_[p]) &&
              orientation(at_[a], at_[v], at_[p]) >= 0 && orientation(at_[v], at_[b], at_[p]) >= 0 &&
              orientation(at_[b], at_[a], at_[p]) >= 0)
            return false;
    return true;
  }

  void drop(std::uint32_t v) {
    const std::uint32_t a = previous_[v], b = next_[v];
    std::vector<std::uint32_t>& stands_for = dropped_[a];
    stands_for.push_back(v);
    stands_for.insert(stands_for.end(), dropped_[v].begin(), dropped_[v].end());
    dropped_[v] = {};
    live_[v] = false;
    std::erase(cells_[cell_of(column(at_[v].x()), row(at_[v].y()))], v);
    next_[a] = b;
    previous_[b] = a;
    --size_[ring_[v]];
    consider(a);
    consider(b);
  }

  double tolerance_;
  std::vector<Point> at_;
  std::vector<std::uint32_t> previous_, next_, ring_, size_, first_, version_;
  std::vector<bool> live_;
  std::vector<std::vector<std::uint32_t>> dropped_;
  std::priority_queue<Candidate> queue_;
  Box box_;
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

Region simplify_inward(const Region& region, double tolerance) {
  Simplifier simplifier(region, tolerance);
  simplifier.run();
  return simplifier.result(region);
}

}  // namespace oxturn

// The edges of a region in a uniform grid: distances, crossings, point location.
//
// Build O(n + cells), memory O(n). Queries look at the cells they touch. Immutable after construction.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/uniform_grid.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class EdgeIndex {
 public:
  explicit EdgeIndex(const Region& region);

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Point point{0, 0};     // on the boundary
    Point from{0, 0};      // on the query segment (the query point itself for points)
    std::size_t edge = 0;  // index into edges()
  };
  /// Nearest boundary point to p if nearer than `within`, else nullopt.
  std::optional<Nearest> nearest(const Point& p, double within = std::numeric_limits<double>::infinity()) const;
  /// Nearest approach of segment ab to the boundary if nearer than `within` (0 where it crosses).
  std::optional<Nearest> nearest(const Point& a, const Point& b,
                                 double within = std::numeric_limits<double>::infinity()) const;
  /// Closed region: boundary counts as inside. Exact predicates.
  bool contains(const Point& p) const;
  /// The closed segment stays in the closed region (it may run along walls and through corners). Exact.
  bool contains(const Point& a, const Point& b) const;

  struct Edge {
    Point a, b;
  };  // free space to the left of a -> b
  const std::vector<Edge>& edges() const { return edges_; }
  /// Calls f(edge index) once for every edge that may meet the box (supersets allowed, no repeats, ascending).
  template <class F>
  void for_each_near(const Box& box, F f) const {
    std::vector<std::uint32_t> hits;
    collect(box, hits);
    for (const std::uint32_t e : hits) f(static_cast<std::size_t>(e));
  }

 private:
  void collect(const Box& box, std::vector<std::uint32_t>& out) const;  // sorted, unique
  Point look_out(std::size_t cell) const;
  bool crossed(const Point& from, const Point& to, std::uint32_t edge) const;
  void look_about();
  std::vector<Edge> edges_;
  UniformGrid grid_;
  std::vector<std::uint8_t> look_out_;  // of each cell: which place, and whether it is inside
};

}  // namespace oxturn

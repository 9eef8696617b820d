/// The edges of a region in a uniform grid: point location, distance to the boundary, segments inside the region.
///
///   const EdgeIndex walls(free_space);
///   walls.contains(p);                          // exact; the boundary belongs to the region
///   walls.contains(a, b);                       // exact: does the segment stay inside?
///   if (const auto hit = walls.nearest(p)) std::cout << hit->distance;
///
/// Build O(n + cells) for n edges, memory O(n). A query costs the edges in the cells it visits: O(1) for a point on
/// maps whose edges are spread evenly. Immutable after construction, so any number of threads may share one.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "geometry/region.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

class EdgeIndex {
 public:
  /// Throws std::invalid_argument if edges lie too close together to tell inside from outside.
  explicit EdgeIndex(const Region& region);

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Point point{0, 0};     // on the boundary
    Point from{0, 0};      // on the query segment; for a query point, that point
    std::size_t edge = 0;  // index into edges()
  };
  /// The boundary point nearest to p, if it is nearer than `within`. Equal distances: the lowest edge.
  std::optional<Nearest> nearest(const Point& p, double within = std::numeric_limits<double>::infinity()) const;
  /// Where the segment ab comes nearest to the boundary, if nearer than `within`; distance 0 where they meet.
  std::optional<Nearest> nearest(const Point& a, const Point& b,
                                 double within = std::numeric_limits<double>::infinity()) const;
  /// Is p in the closed region? Exact.
  bool contains(const Point& p) const;
  /// Is p on an edge? Exact.
  bool on_boundary(const Point& p) const;
  /// Does the closed segment stay in the closed region? It may run along edges and through vertices. Exact.
  bool contains(const Point& a, const Point& b) const;

  struct Edge {
    Point a, b;
  };  // free space to the left of a -> b
  const std::vector<Edge>& edges() const { return edges_; }
  /// Calls f(edge index), in ascending order and once each, for every edge that meets the box and some that only come
  /// near it.
  template <class F>
  void for_each_near(const Box& box, F f) const {
    std::vector<std::uint32_t> found;
    collect(box, found);
    for (const std::uint32_t e : found) f(static_cast<std::size_t>(e));
  }

 private:
  /// A point of a cell that is on no edge, and whether it is inside: point location counts the edges of the cell
  /// between this point and the query.
  struct Reference {
    std::uint8_t candidate : 7 = 0;  // which of kCandidates positions in the cell
    std::uint8_t inside : 1 = 0;
  };
  static constexpr int kCandidates = 128;
  /// An edge and a point of it that lies on the query segment.
  struct Touch {
    Point point;
    std::uint32_t edge;
    bool operator<(const Touch& o) const { return point != o.point ? before(point, o.point) : edge < o.edge; }
    bool operator==(const Touch& o) const { return point == o.point && edge == o.edge; }
  };
  /// The edges that a segment touches without crossing them.
  struct Contacts {
    std::vector<Touch> touches;
    std::vector<std::uint32_t> along;  // edges collinear with the segment
  };

  void collect(const Box& box, std::vector<std::uint32_t>& out) const;  // sorted, unique
  Point reference_point(std::size_t cell) const;
  bool separates(const Point& p, const Point& q, std::uint32_t edge) const;
  void choose_references();
  template <class TryEdge>
  void try_rings(const Point& p, const Nearest& best, TryEdge try_edge) const;
  std::optional<Contacts> contacts(const Point& a, const Point& b) const;
  const Point* vertex_on(const Edge& edge, const Point& a, const Point& b) const;
  void add_vertices_passed(Contacts& contacts) const;
  bool free_at_touches(const std::vector<Touch>& touches, const Point& a, const Point& b) const;

  std::vector<Edge> edges_;
  UniformGrid grid_;
  std::vector<Reference> references_;  // by cell
};

}  // namespace oxturn

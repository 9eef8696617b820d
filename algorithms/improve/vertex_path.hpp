/// A path as a sequence of vertices that can be changed anywhere, with the vertices near a point.
///
///   VertexPath path(points, {0}, tool_width);                  // the first vertex is fixed
///   path.replace(7, 1, std::array{Point(2, 3)});               // vertex 7 moves
///   path.reverse(3, 9);                                        // vertices 3 to 9
///   if (const auto i = path.near(Point(2, 3), rng)) ...        // a vertex in the same bucket
///
/// Fixed vertices stay, and so do edges between two of them. Changes cost the vertices between the
/// positions that they move, a few nanoseconds each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "geometry/point.hpp"

namespace oxturn {

class VertexPath {
 public:
  /// `fixed`: positions of vertices. `bucket`: side of the buckets, metres.
  VertexPath(const Polyline& points, const std::vector<std::size_t>& fixed, double bucket);

  std::size_t size() const { return order_.size(); }
  const Point& operator[](std::size_t i) const { return at_[order_[i]]; }
  bool fixed(std::size_t i) const { return fixed_[order_[i]] != 0; }
  /// Of the edge from vertex i - 1 to vertex i.
  bool edge_fixed(std::size_t i) const { return fixed(i - 1) && fixed(i); }
  /// The first position of a fixed vertex, or any number for another vertex.
  std::size_t origin(std::size_t i) const { return order_[i]; }
  Polyline points() const;
  double length() const;

  /// `count` vertices from position `first` on become `points`.
  void replace(std::size_t first, std::size_t count, std::span<const Point> points);
  /// Vertices first to last in the opposite order.
  void reverse(std::size_t first, std::size_t last);
  /// Vertices first to last move behind vertex `after`, which is none of them; in the opposite order if `turned`.
  void relocate(std::size_t first, std::size_t last, std::size_t after, bool turned);
  /// The position of a vertex of the bucket that holds p.
  std::optional<std::size_t> near(const Point& p, Rng& rng) const;

 private:
  using Id = std::uint32_t;
  std::size_t bucket(const Point& p) const;
  void enter(Id id, const Point& p);
  void leave(Id id);
  void renumber(std::size_t first, std::size_t end);

  double cell_;
  Point origin_{0, 0};
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<Point> at_;                // by id
  std::vector<std::uint32_t> position_;  // by id
  std::vector<std::uint8_t> fixed_;      // by id
  std::vector<Id> order_, unused_;
  std::vector<std::vector<Id>> buckets_;
};

}  // namespace oxturn

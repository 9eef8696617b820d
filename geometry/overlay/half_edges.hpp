/// The half-edges of a planar graph on the lattice, in angular order about each vertex. Private to geometry, not
/// installed.
///
///   const VertexFans fans(edges.size(), [&](std::uint32_t e) { return std::pair(edges[e].a, edges[e].b); });
///   for (const HalfEdge h : fans.at(v)) { /* counter-clockwise about vertex v */ }
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "base/sorting.hpp"
#include "geometry/overlay/lattice.hpp"

namespace oxturn {

/// One direction of an edge. Forward half-edges leave the edge's first end, backward ones its second.
class HalfEdge {
 public:
  HalfEdge() = default;
  static HalfEdge forward(std::uint32_t edge) { return HalfEdge(2 * edge); }
  static HalfEdge backward(std::uint32_t edge) { return HalfEdge(2 * edge + 1); }
  std::uint32_t edge() const { return index_ / 2; }
  bool is_forward() const { return index_ % 2 == 0; }
  HalfEdge twin() const { return HalfEdge(index_ ^ 1u); }
  std::uint32_t index() const { return index_; }
  friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;

 private:
  explicit HalfEdge(std::uint32_t index) : index_(index) {}
  std::uint32_t index_ = 0;  // 2 * edge, or 2 * edge + 1 for the backward one
};

/// Vertices are numbered in the order of their lattice points. At each, the half-edges that leave it are sorted
/// counter-clockwise, beginning just after straight down; where there are two, most of all, they begin with either.
class VertexFans {
 public:
  /// ends(e): the two ends of edge e, of n. Edges must be in the order of their lower ends (by x, then y). O(n) for
  /// points spread evenly, O(n log n) otherwise.
  template <class Ends>
  VertexFans(std::size_t n, Ends ends) : half_edges_(2 * n), tail_(2 * n) {
    sort_by_vertex(n, ends);
    const auto head_of = [&](HalfEdge h) {
      const auto [a, b] = ends(h.edge());
      return h.is_forward() ? std::pair(a, b) : std::pair(b, a);
    };
    const auto by_angle = [&](HalfEdge g, HalfEdge h) {
      const auto [v, p] = head_of(g);
      const auto [w, q] = head_of(h);
      const bool p_after = v < p, q_after = w < q;  // to the right, or straight up
      if (p_after != q_after) return p_after;
      return twice_area(v, p, q) > 0;
    };
    for (std::size_t v = 0; v < vertices(); ++v)
      if (first_[v + 1] - first_[v] > 2)
        std::sort(half_edges_.data() + first_[v], half_edges_.data() + first_[v + 1], by_angle);
  }

  std::size_t vertices() const { return first_.size() - 1; }
  std::span<const HalfEdge> at(std::uint32_t vertex) const {
    return {half_edges_.data() + first_[vertex], half_edges_.data() + first_[vertex + 1]};
  }
  /// The vertex that the half-edge leaves.
  std::uint32_t tail(HalfEdge h) const { return tail_[h.index()]; }
  std::uint32_t head(HalfEdge h) const { return tail_[h.twin().index()]; }
  /// The position of a half-edge in at(tail(h)). O(degree of the vertex).
  std::size_t position(HalfEdge h) const {
    const auto fan = at(tail(h));
    return static_cast<std::size_t>(std::find(fan.begin(), fan.end(), h) - fan.begin());
  }

 private:
  struct End {
    std::uint64_t key;
    HalfEdge half_edge;
  };

  /// Merges the lower ends, which come sorted, with the sorted upper ends; numbers the vertices.
  template <class Ends>
  void sort_by_vertex(std::size_t n, Ends ends) {
    const auto end_of = [&](std::uint32_t e, bool lower) {
      const auto [a, b] = ends(e);
      return (a < b) == lower ? End{sort_key(a), HalfEdge::forward(e)} : End{sort_key(b), HalfEdge::backward(e)};
    };
    std::vector<End> upper(n);
    for (std::uint32_t e = 0; e < n; ++e) upper[e] = end_of(e, false);
    spread_sort(
        upper, [](const End& e) { return e.key; },
        [](const End& e, const End& f) { return e.key != f.key ? e.key < f.key : e.half_edge < f.half_edge; });
    first_.reserve(n + 1);
    std::uint64_t key = 0;
    End lower = n > 0 ? end_of(0, true) : End{};
    for (std::uint32_t k = 0, l = 0, u = 0; k < 2 * n; ++k) {
      const bool is_lower = l < n && (u == n || lower.key <= upper[u].key);
      const End end = is_lower ? lower : upper[u++];
      if (is_lower && ++l < n) lower = end_of(l, true);
      if (k == 0 || end.key != key) first_.push_back(k);
      key = end.key;
      half_edges_[k] = end.half_edge;
      tail_[end.half_edge.index()] = static_cast<std::uint32_t>(first_.size()) - 1;
    }
    first_.push_back(static_cast<std::uint32_t>(2 * n));
  }

  std::vector<std::uint32_t> first_;  // fan of vertex v: half_edges_[first_[v] .. first_[v + 1])
  std::vector<HalfEdge> half_edges_;
  std::vector<std::uint32_t> tail_;  // vertex, by half-edge
};

}  // namespace oxturn

/// A wave over the triangles of the transit mesh: roughly, the lengths of shortest paths from one point to all near by.
///
///   MeshWave wave(problem);
///   wave.spread(p, *wave.triangle_of(p), [&](std::size_t triangle) { return wave.metres(triangle) > 10; });
///
/// Dijkstra over the midpoints of triangle sides: O(t log t) for t triangles reached.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/graph_search.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class MeshWave {
 public:
  explicit MeshWave(const Problem& problem)
      : mesh_(problem.transit().mesh()), tolerance_(problem.tolerance()), entered_at_(mesh_.triangles().size()) {}

  std::size_t triangle_count() const { return entered_at_.size(); }
  /// nullopt: p is outside configuration space.
  std::optional<std::size_t> triangle_of(const Point& p) const {
    const std::int32_t triangle = mesh_.locate(p, tolerance_);
    return triangle == Mesh::kWall ? std::nullopt : std::optional(static_cast<std::size_t>(triangle));
  }
  /// From p in a triangle: asks stop(triangle) for each one in the order in which it is entered, until it is true.
  template <class Stop>
  void spread(const Point& p, std::size_t triangle, Stop stop) {
    spread_within(
        p, triangle, [](std::size_t) { return true; }, stop);
  }
  /// The same over no triangles but those for which allowed(triangle) is true.
  template <class Allowed, class Stop>
  void spread_within(const Point& p, std::size_t triangle, Allowed allowed, Stop stop) {
    const auto neighbours = [&](std::size_t t, const auto& reach) {
      const Mesh::Triangle& here = mesh_.triangles()[t];
      const auto vertex = [&](std::size_t k) { return mesh_.points()[static_cast<std::size_t>(here.vertex[k % 3])]; };
      for (std::size_t k = 0; k < 3; ++k) {
        if (here.neighbour[k] == Mesh::kWall) continue;
        const auto next = static_cast<std::size_t>(here.neighbour[k]);
        if (!allowed(next)) continue;
        const Point middle = (vertex(k + 1) + vertex(k + 2)) / 2;
        if (reach(next, distance(entered_at_[t], middle))) entered_at_[next] = middle;
      }
    };
    entered_at_[triangle] = p;
    dijkstra(wave_, entered_at_.size(), triangle, neighbours, stop);
  }
  /// Where the last wave entered a triangle, and after how many metres.
  const Point& entered_at(std::size_t triangle) const { return entered_at_[triangle]; }
  double metres(std::size_t triangle) const { return wave_.cost(triangle); }
  /// The triangles by which the last wave came to this one, both ends included.
  std::vector<std::int32_t> triangles_to(std::size_t triangle) const {
    std::vector<std::int32_t> all;
    for (const std::size_t t : wave_.path_to(triangle)) all.push_back(static_cast<std::int32_t>(t));
    return all;
  }

 private:
  const Mesh& mesh_;
  double tolerance_;
  SearchTree<double> wave_;
  std::vector<Point> entered_at_;  // by triangle
};

}  // namespace oxturn

/// Paths with as little driving over finished work as possible, where it cannot be avoided.
///
///   WeightedSearch search(problem, work, 100);               // a metre over finished work costs 100 more
///   if (const auto path = search.path(from, to)) drive(*path);
///
/// A* over square cells of a quarter of the tool's width (wider on canvases of more than 500 cells across), then
/// straightened: two of its vertices are joined by a straight line where that does not cost more.
/// Complexity  O(c log c) for c cells
#pragma once

#include <optional>

#include "algorithms/drawing/finished_work.hpp"
#include "base/graph_search.hpp"
#include "geometry/raster.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class WeightedSearch {
 public:
  /// References must outlive it.
  WeightedSearch(const Problem& problem, const FinishedWork& work, double weight);
  /// nullopt: configuration space is too narrow there for the cells.
  std::optional<Polyline> path(const Point& from, const Point& to);
  /// By the last search.
  std::size_t cells_reached() const { return reached_; }

 private:
  void mark_finished();
  std::vector<std::uint32_t> cells_of(const DrawnPiece& piece) const;
  /// Free cells about p that it sees, each with the distance.
  std::vector<std::pair<std::size_t, double>> cells_at(const Point& p) const;
  template <class Reach>
  void for_each_neighbour(std::size_t cell, const Point& from, const Point& to, Reach reach) const;
  double cost(const Point& a, const Point& b, const Point& from, const Point& to) const;
  Polyline straightened(const Polyline& path) const;
  Point centre(std::size_t cell) const;

  const Problem& problem_;
  const FinishedWork& work_;
  double weight_;
  BitGrid free_;                                   // cells whose centre is in configuration space
  std::vector<std::vector<std::uint32_t>> cells_;  // by piece
  std::vector<std::uint8_t> covered_;              // cells of finished pieces
  std::optional<std::uint64_t> marked_;            // the fingerprint of what is covered
  SearchTree<double> tree_;
  std::size_t reached_ = 0;
};

}  // namespace oxturn

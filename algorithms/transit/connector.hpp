/// Paths between two points of configuration space: straight if possible, else the shortest path.
///
///   const Connector connector(problem);
///   path.drive(connector.path(path.at(), next), false);
///
/// Planners that connect points go through this class, so none of them drives straight through a wall.
/// A straight connection costs one exact segment test, others a shortest-path query.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "maps/problem.hpp"

namespace oxturn {

class Connector {
 public:
  /// `problem` must outlive it. Builds the problem's edge index if it does not exist yet, and its triangulation for the
  /// first path that is not straight.
  explicit Connector(const Problem& problem);

  /// From a to b, both included. Throws std::runtime_error with both points if they are not connected, which happens
  /// only if one of them is outside configuration space by more than the problem's tolerance.
  Polyline path(const Point& a, const Point& b) const;
  /// The same; nullopt if it is longer than `longest`, or they are not connected.
  std::optional<Polyline> path_within(const Point& a, const Point& b, double longest) const;
  /// The length of that path; infinity if it is longer than `longest`.
  double length(const Point& a, const Point& b, double longest = std::numeric_limits<double>::infinity()) const;
  /// The closed segment lies in configuration space, exactly.
  bool straight(const Point& a, const Point& b) const;

 private:
  const Problem& problem_;
  const EdgeIndex& walls_;
};

/// The candidate that is nearest by path, of pairs (straight distance, candidate); of equally near ones that with the
/// lower straight distance. `length(candidate, longest)` is the length of the path there, infinity if it is longer than
/// `longest`; it is called only where the straight distance leaves hope. nullopt if no path is found.
template <class Candidate, class Length>
std::optional<Candidate> nearest_by_path(std::vector<std::pair<double, Candidate>> candidates, Length length) {
  // A heap, because few are looked at. Of equal distances the first comes first.
  std::vector<std::size_t> waiting(candidates.size());
  std::iota(waiting.begin(), waiting.end(), std::size_t{0});
  const auto later = [&](std::size_t a, std::size_t b) {
    return candidates[a].first != candidates[b].first ? candidates[a].first > candidates[b].first : a > b;
  };
  std::make_heap(waiting.begin(), waiting.end(), later);
  std::optional<Candidate> best;
  double least = std::numeric_limits<double>::infinity();
  for (; !waiting.empty(); waiting.pop_back()) {
    std::pop_heap(waiting.begin(), waiting.end(), later);
    const auto& [straight, candidate] = candidates[waiting.back()];
    if (straight >= least) break;
    const double path = length(candidate, least);
    if (path >= least) continue;
    least = path;
    best = candidate;
  }
  return best;
}

}  // namespace oxturn

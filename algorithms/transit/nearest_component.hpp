// The nearest of many parts by driven way.
//
// A wave runs from the robot over the triangles of the transit mesh (Dijkstra over the middles of their sides) until it
// has met entry points of a few parts; shortest paths to these decide. So a question costs what lies nearer than the
// answer, not all parts: behind a wall thousands may be near in the air.
//
// Complexity  add O(1); a question O(t log t) for t triangles nearer than the answer, and a handful of shortest paths
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "maps/problem.hpp"

namespace oxturn {

class NearestComponent {
 public:
  explicit NearestComponent(const Problem& problem);
  /// An entry point of a part, in configuration space; `id` is the caller's.
  void add(const Point& p, int part, std::size_t id);
  /// The part is done: its points no longer count.
  void remove(int part);

  struct Found {
    std::size_t id;
    Polyline path;  // from the asking point to the entry, both included
  };
  /// nullopt if nothing that is left can be reached. Not safe from several threads.
  std::optional<Found> from(const Point& p);

 private:
  struct Entry {
    Point at;
    int part;
    std::size_t id;
  };
  struct Reached {
    double distance = 0;
    std::uint32_t stamp = 0;
  };
  bool dropped(int part) const {
    return static_cast<std::size_t>(part) < dropped_.size() && dropped_[static_cast<std::size_t>(part)];
  }
  const Entry* nearest_in(std::size_t triangle, const Point& to);

  const Problem& problem_;
  const Mesh& mesh_;
  std::vector<std::vector<Entry>> entries_;  // by triangle
  std::vector<bool> dropped_;
  std::vector<Reached> reached_;  // by triangle
  std::uint32_t stamp_ = 0;
};

}  // namespace oxturn

/// The nearest of many connected components by driven path.
///
///   NearestComponent nearest(problem);
///   for (...) nearest.add(entry_point, component, id);
///   while (auto found = nearest.from(path.at())) { ...; nearest.remove(component); }
///
/// A wave spreads from the query point over the triangles of the transit mesh (Dijkstra over the midpoints of their
/// sides) until it has met entry points of a few components; shortest paths to these decide. So a query costs what lies
/// nearer than the answer, not all components: behind a wall thousands may be near by straight distance.
/// add O(1); a query O(t log t) for t triangles nearer than the answer, and a few shortest paths.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/transit/mesh_wave.hpp"

namespace oxturn {

class NearestComponent {
 public:
  explicit NearestComponent(const Problem& problem);
  /// An entry point of a component, in configuration space; `id` is the caller's.
  void add(const Point& p, int component, std::size_t id);
  /// The component's entry points do not count any more.
  void remove(int component);

  struct Found {
    std::size_t id;
    Polyline path;  // from the query point to the entry point, both included
  };
  /// nullopt if no entry point can be reached. Not safe from several threads.
  std::optional<Found> from(const Point& p);

 private:
  struct Entry {
    Point at;
    int component;
    std::size_t id;
  };
  bool removed(int component) const {
    return static_cast<std::size_t>(component) < removed_.size() && removed_[static_cast<std::size_t>(component)];
  }
  const Entry* nearest_in(std::size_t triangle, const Point& to);
  std::vector<Entry> candidates(const Point& p, std::size_t triangle);

  const Problem& problem_;
  MeshWave wave_;
  std::vector<std::vector<Entry>> entries_;  // by triangle
  std::vector<bool> removed_;
};

}  // namespace oxturn

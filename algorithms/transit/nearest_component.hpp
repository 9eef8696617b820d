/// The nearest of many connected components by driven path.
///
///   NearestComponent nearest(problem);
///   for (...) nearest.add(entry_point, component, id);
///   while (auto found = nearest.from(path.at())) { ...; nearest.remove(component); }
///
/// Where the entry point that is nearest by straight distance is in sight, or an almost straight path leads there that
/// is shorter than the straight distance to all others, that is it. Otherwise a wave spreads from the query point over
/// the triangles of the transit mesh (Dijkstra over the midpoints of their sides) until it has met entry points of a
/// few components; the shortest paths through the triangles by which it came decide. So a query costs what lies nearer
/// than the answer, not all components: behind a wall thousands may be near by straight distance. A wave that has met
/// none among thousands of triangles ends; another one, over groups of triangles, finds the few that it was about to
/// meet, and the first begins again, on the path there only. So what is done already is not crossed triangle by
/// triangle, again and again, by all queries that begin in the middle of it.
/// add O(1); a query one short shortest path, and O(t log t) for t triangles nearer than the answer if that is behind
/// walls and t below 4096, else for the triangles on the path there, and t / 256 groups; from() one more shortest path.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "algorithms/transit/mesh_wave.hpp"
#include "algorithms/transit/triangle_groups.hpp"
#include "geometry/point_grid.hpp"

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
  /// With the shortest path there. nullopt if no entry point can be reached. Not safe from several threads.
  std::optional<Found> from(const Point& p);
  /// Only its id, by sight and by the wave, which spreads half as far again as the path to the first one that it
  /// meets: for callers who have a path of their own. Of components that are about as near any may be found.
  std::optional<std::size_t> nearest(const Point& p);

 private:
  struct Entry {
    Point at;
    int component;
    std::size_t id;
    std::uint32_t triangle;
    std::uint32_t next;  // entry in the triangle
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Nearest {
    std::optional<Found> found = std::nullopt;
    double metres = std::numeric_limits<double>::infinity();
    std::uint32_t entry = 0;
  };
  bool removed(int component) const {
    return static_cast<std::size_t>(component) < removed_.size() && removed_[static_cast<std::size_t>(component)];
  }
  void keep_grid();
  void try_entry(const Point& p, const Entry& entry, double longest, Nearest& best) const;
  bool find_almost_straight(const Point& p, Nearest& best);
  std::optional<std::uint32_t> nearest_in(std::size_t triangle, const Point& to);
  void forget_removed(std::vector<std::uint32_t>& entries) const;
  void keep_groups();
  void allow_path_to_few(std::size_t home, double longest);
  Nearest nearest_in_sight(const Point& p);
  Nearest nearest_by_wave(const Point& p, std::size_t home, double longest, double far_enough);

  const Problem& problem_;
  MeshWave wave_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> in_triangle_;  // its last entry, by triangle; kNone: none
  std::optional<PointGrid> grid_;           // of the first entries
  std::size_t in_grid_ = 0;
  std::optional<TriangleGroups> groups_;              // made when a wave first meets nothing near by
  std::vector<std::vector<std::uint32_t>> in_group_;  // the first entries, by group
  std::size_t in_groups_ = 0;
  SearchTree<double> coarse_;
  std::vector<bool> allowed_;  // groups on the path to those of a few components, and beside it
  std::vector<bool> removed_;
};

}  // namespace oxturn

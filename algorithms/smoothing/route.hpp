/// How far a car-like robot has to go, at least roughly: along the shortest path of a robot that turns on the spot.
///
///   const Route route(space.shortest_path(from, to), walls, spacing);
///   route.rest(p);                              // from p to the route's nearest point in sight, and on along it
///
/// A guide for lattice_search (detour_search.hpp) around obstacles; the second heuristic of Dolgov et al. 2010 without
/// a grid, so that it leads through passages of any width.
/// Complexity  O(length / spacing) once, then some sight tests a point
#pragma once

#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/point_grid.hpp"

namespace oxturn {

class Route {
 public:
  /// `path`: at least two points, or none, then rest() is 0 everywhere. `spacing`: metres between the points of it that
  /// are looked at. `walls` must outlive it.
  Route(const Polyline& path, const EdgeIndex& walls, double spacing);
  Route(const Route&) = delete;
  Route& operator=(const Route&) = delete;
  /// Metres. Where no point of the route is in sight, the straight distance to its end.
  double rest(const Point& p) const;

 private:
  std::vector<Point> points_;
  std::vector<double> rest_;  // from each to the end
  const EdgeIndex& walls_;
  const PointGrid grid_;
};

}  // namespace oxturn

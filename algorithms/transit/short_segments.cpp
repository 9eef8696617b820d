#include "algorithms/transit/short_segments.hpp"

namespace oxturn {
namespace {

Polyline without_short_segments(const Polyline& points, double least, const EdgeIndex& walls) {
  Polyline kept;
  for (const Point& p : points) {
    const bool end = &p == &points.back();
    while (kept.size() > 1) {
      const Point &last = kept.back(), &before = kept[kept.size() - 2];
      const bool near = distance(before, last) < least || (end && distance(last, p) < least);
      if (!near || !walls.contains(before, p)) break;
      kept.pop_back();
    }
    kept.push_back(p);
  }
  return kept;
}

}  // namespace

Path without_short_segments(Path path, const Problem& problem) {
  const double least = shortest_segment(problem.robot());
  for (Leg& leg : path.legs) leg.points = without_short_segments(leg.points, least, problem.walls());
  return path;
}

}  // namespace oxturn

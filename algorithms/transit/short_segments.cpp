#include "algorithms/transit/short_segments.hpp"

namespace oxturn {
namespace {

Polyline without_short_segments(const Polyline& points, double least, const Connector& connector) {
  if (points.size() < 3) return points;
  Polyline kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    if (distance(kept.back(), points[i]) >= least || !connector.straight(kept.back(), points[i + 1]))
      kept.push_back(points[i]);
  // The last vertex stays, so before it the one before goes.
  const Point& end = points.back();
  if (kept.size() > 1 && distance(kept.back(), end) < least && connector.straight(kept[kept.size() - 2], end))
    kept.pop_back();
  kept.push_back(end);
  return kept;
}

}  // namespace

Path without_short_segments(Path path, double least, const Connector& connector) {
  for (Leg& leg : path.legs) leg.points = without_short_segments(leg.points, least, connector);
  return path;
}

}  // namespace oxturn

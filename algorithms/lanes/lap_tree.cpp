#include "algorithms/lanes/lap_tree.hpp"

#include <limits>
#include <utility>
#include <vector>

#include "algorithms/lanes/outline.hpp"

namespace oxturn {

Path drive_lap_tree(const Problem& problem, const Laps& laps, const Connector& connector, Context& context) {
  std::vector<Ring> rings;
  Point nearest = problem.start();
  double least = std::numeric_limits<double>::infinity();
  for (const Lap& lap : laps.all) {
    rings.push_back(lap.ring);
    for_each_edge(lap.ring, [&](const Point& a, const Point& b) {
      const Point p = nearest_on_segment(problem.start(), a, b);
      if (distance(p, problem.start()) < least) nearest = p, least = distance(p, problem.start());
    });
  }
  PathBuilder arrival(problem.start());
  arrival.drive(connector.path(problem.start(), nearest), false);
  return with_rings(problem, rings, arrival.take(), problem.robot().tool_width, connector, context);
}

}  // namespace oxturn

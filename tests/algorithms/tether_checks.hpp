// Checks of tethered paths: drives a path with an independent taut tether and measures what it does.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "geometry/predicates.hpp"
#include "geometry/tether/taut_tether.hpp"
#include "maps/generators.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {

struct TetherFigures {        // metres
  double longest = 0;         // greatest length of the tether
  double excess = 0;          // the most by which the tether is longer than the geodesic
  double excess_at_work = 0;  // the same while the tool is on
  int crossings = 0;          // how often the robot drives over its own tether
};

/// Drives the path, its segments divided into parts of at most `step` metres. Crossings by brute force over all
/// segments of the tether but the last.
inline TetherFigures drive_tethered(const Problem& problem, const Path& path, double step) {
  TetherFigures figures;
  TautTether tether(problem.tether()->taut_space(), problem.anchor());
  tether.drive(problem.tether()->geodesics().path(problem.start()));
  const auto look = [&](bool tool) {
    figures.longest = std::max(figures.longest, tether.length());
    const double excess = tether.length() - problem.tether()->geodesics().distance(tether.robot());
    figures.excess = std::max(figures.excess, excess);
    if (tool) figures.excess_at_work = std::max(figures.excess_at_work, excess);
  };
  look(true);
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      const int n = std::max(1, static_cast<int>(std::ceil(distance(a, b) / step)));
      for (int k = 1; k <= n; ++k) {
        const Polyline line = tether.polyline();
        const Point from = tether.robot(), to = k == n ? b : lerp(a, b, static_cast<double>(k) / n);
        for (std::size_t s = 1; s + 1 < line.size(); ++s)
          if (crossing(from, to, line[s - 1], line[s]) == Crossing::proper) ++figures.crossings;
        tether.drive(to, [&](const TautTether::Swing& swing) {
          figures.longest = std::max({figures.longest, swing.before + distance(swing.pivot, swing.from),
                                      swing.before + distance(swing.pivot, swing.to)});
        });
        look(leg.tool);
      }
    }
  return figures;
}

inline Robot tethered_robot(double reach, double radius = 0.2, double tool_width = 0.4) {
  Robot robot;
  robot.radius = radius;
  robot.tool_width = tool_width;
  robot.tether = Tether{0, reach};
  return robot;
}

/// Small maps, one of each family; most have obstacles to go round.
inline std::vector<Map> tether_maps(std::uint64_t seed) {
  std::vector<Map> all;
  for (const auto& [name, settings] : std::vector<std::pair<std::string, Settings>>{
           {"rooms", {{"width", 8.0}, {"height", 6.0}, {"rooms", std::int64_t{4}}}},
           {"cave", {{"width", 7.0}, {"height", 7.0}}},
           {"clutter", {{"width", 8.0}, {"height", 6.0}}},
           {"field", {{"width", 14.0}, {"height", 10.0}, {"ponds", std::int64_t{5}}}},
           {"polygon", {{"width", 8.0}, {"height", 8.0}}},
           {"maze", {{"width", 6.0}, {"height", 6.0}}},
           {"comb", {{"width", 8.0}, {"height", 6.0}, {"aisles", std::int64_t{5}}}},
           {"spiral", {{"width", 8.0}, {"height", 6.0}}}})
    all.push_back(generate(name, settings, seed));
  return all;
}

}  // namespace oxturn

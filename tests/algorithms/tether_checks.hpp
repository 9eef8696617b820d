// What a tethered path must keep, looked at with a string of its own along the way.
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

struct TetherReport {
  double longest = 0;         // metres of string, at most
  double excess = 0;          // most that the string is longer than the geodesic
  double excess_at_work = 0;  // the same while the tool is on
  int crossings = 0;          // drives over its own line
  double length = 0;          // of the path
};

/// Drives the path, its segments cut to at most `step`. Crossings by brute force over all of the string's segments but
/// the last.
inline TetherReport drive_tethered(const Problem& problem, const Path& path, double step) {
  TetherReport report;
  TautTether string(problem.tether()->taut_space(), problem.anchor());
  string.drive(problem.tether()->geodesics().path(problem.start()));
  const auto look = [&](bool tool) {
    report.longest = std::max(report.longest, string.length());
    const double excess = string.length() - problem.tether()->geodesics().distance(string.robot());
    report.excess = std::max(report.excess, excess);
    if (tool) report.excess_at_work = std::max(report.excess_at_work, excess);
  };
  look(true);
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      const int n = std::max(1, static_cast<int>(std::ceil(distance(a, b) / step)));
      for (int k = 1; k <= n; ++k) {
        const Polyline line = string.polyline();
        const Point from = string.robot(), to = k == n ? b : lerp(a, b, double(k) / n);
        for (std::size_t s = 1; s + 1 < line.size(); ++s)
          if (crossing(from, to, line[s - 1], line[s]) == Crossing::proper) ++report.crossings;
        string.drive(to, [&](const TautTether::Swing& swing) {
          report.longest = std::max({report.longest, swing.before + distance(swing.pivot, swing.from),
                                     swing.before + distance(swing.pivot, swing.to)});
        });
        look(leg.tool);
      }
      report.length += distance(a, b);
    }
  return report;
}

inline Robot tethered_robot(double reach, double radius = 0.2, double tool_width = 0.4) {
  Robot robot;
  robot.radius = radius;
  robot.tool_width = tool_width;
  robot.tether = Tether{0, reach};
  return robot;
}

/// Small maps with ways round obstacles, one of each family.
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

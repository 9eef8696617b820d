// Oracle for planners by brute force: distances of every segment and of sampled points. Shares nothing with planners,
// metrics or the edge index.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "base/random.hpp"
#include "maps/generators.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

namespace oxturn {

inline Path plan(const std::string& planner, const Problem& problem, const Settings& settings = {}) {
  Context context(1);
  return built_in_planner(planner, settings)->plan(problem, context);
}

inline Robot disc(double radius, double tool_width) {
  Robot robot;
  robot.radius = radius;
  robot.tool_width = tool_width;
  return robot;
}

/// All points in text: equal for equal paths only.
inline std::string bytes(const Path& path) {
  std::string all;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points) all += fmt::format("{} {} ", p.x(), p.y());
  return all;
}

inline bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double o1 = cross(b - a, c - a), o2 = cross(b - a, d - a), o3 = cross(d - c, a - c), o4 = cross(d - c, b - c);
  return o1 * o2 < 0 && o3 * o4 < 0;
}

inline double segment_distance(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (segments_cross(a, b, c, d)) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

/// The path begins at the start, does not jump, and keeps the robot's radius from every wall of the map.
inline void expect_valid(const Problem& problem, const Path& path) {
  ASSERT_FALSE(path.legs.empty());
  EXPECT_EQ(path.legs.front().points.front(), problem.start());
  const double least = problem.robot().radius - problem.tolerance();
  Point at = problem.start();
  for (const Leg& leg : path.legs) {
    ASSERT_GE(leg.points.size(), 2u);
    ASSERT_EQ(leg.points.front(), at);
    at = leg.points.back();
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      ASSERT_TRUE(finite(a) && finite(b));
      bool free = true;
      for_each_ring(problem.map().free, [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size() && free; ++k)
          free = segment_distance(a, b, ring[k], ring[(k + 1) % ring.size()]) >= least;
      });
      ASSERT_TRUE(free) << fmt::format("({}, {}) to ({}, {}) hits a wall", a.x(), a.y(), b.x(), b.y());
    }
  }
}

/// The share of `samples` random points of the target that are farther than half a tool width from all work.
inline double uncovered_share(const Problem& problem, const Path& path, int samples) {
  std::vector<std::pair<Point, Point>> work;
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; leg.tool && i < leg.points.size(); ++i) work.push_back({leg.points[i - 1], leg.points[i]});
  const Box box = bounding_box(problem.target());
  const double reach = problem.robot().tool_width / 2 * (1 + 1e-5) + problem.tolerance();
  Rng rng(7);
  int uncovered = 0;
  for (int n = 0; n < samples;) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    if (!contains(problem.target(), p)) continue;
    ++n;
    bool covered = false;
    for (std::size_t i = 0; i < work.size() && !covered; ++i)
      covered = distance_to_segment(p, work[i].first, work[i].second) <= reach;
    if (!covered) ++uncovered;
  }
  return static_cast<double>(uncovered) / samples;
}

/// One problem of every family, small enough for brute force.
inline std::vector<Problem> sample_problems(std::uint64_t seed) {
  std::vector<Problem> all;
  Robot robot;
  for (const auto& [name, settings] : std::vector<std::pair<std::string, Settings>>{
           {"rooms", {{"width", 8.0}, {"height", 6.0}, {"rooms", std::int64_t{4}}}},
           {"cave", {{"width", 7.0}, {"height", 7.0}}},
           {"clutter", {{"width", 8.0}, {"height", 6.0}}},
           {"field", {{"width", 14.0}, {"height", 10.0}, {"ponds", std::int64_t{5}}}},
           {"polygon", {{"width", 8.0}, {"height", 8.0}}},
           {"maze", {{"width", 6.0}, {"height", 6.0}}},
           {"comb", {}},
           {"rectangle", {}}})
    all.emplace_back(generate(name, settings, seed), robot);
  return all;
}

inline Region mirrored(const Region& region) {
  Region result = region;
  const auto flip = [](Ring& ring) {
    for (Point& p : ring) p.x() = -p.x();
    std::reverse(ring.begin(), ring.end());
  };
  for (Polygon& polygon : result.polygons) {
    flip(polygon.outer);
    for (Ring& hole : polygon.holes) flip(hole);
  }
  return result;
}

}  // namespace oxturn

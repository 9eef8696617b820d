// Visits of what a drivable path leaves uncovered: their parts one by one, and what they reach in the end.
#include "algorithms/smoothing/drivable_visits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/lanes/uncovered.hpp"
#include "algorithms/smoothing/covering_strokes.hpp"
#include "algorithms/smoothing/drivable.hpp"
#include "algorithms/smoothing/known_links.hpp"
#include "algorithms/smoothing/link_search.hpp"
#include "algorithms/smoothing/reinserted_strokes.hpp"
#include "algorithms/smoothing/strokes.hpp"
#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Problem on(const Region& free, double turn, bool reverse) {
  Robot robot;
  robot.radius = 1, robot.tool_width = 2, robot.min_turn_radius = turn, robot.reverse = reverse;
  return Problem(Map{"plain", free, "test", "test"}, robot);
}

/// A yard with two sheds.
Problem yard(double turn, bool reverse) {
  return on(subtract(box_region({0, 0}, {40, 30}), {box_region({12, 10}, {17, 18}), box_region({27, 4}, {30, 20})}),
            turn, reverse);
}

Path boustrophedon(const Problem& problem) {
  Context context;
  return brief_built_in().find("boustrophedon").make({}, brief_built_in())->plan(problem, context);
}

double uncovered_area(const Problem& problem, const Path& path) {
  return area(uncovered(problem.target(), path, problem.robot()));
}

// Oracle: every point, by distance.
TEST(UncoveredPoints, AreCoveredWithinHalfAToolWidth) {
  const Region left{{{box_region({0, 0}, {8, 6}).polygons[0].outer, {}}, box_region({20, 0}, {21, 1}).polygons[0]}};
  UncoveredPoints points(left, 2, 0.1);
  EXPECT_NEAR(points.area(), 49, 1e-9);
  ASSERT_EQ(points.pieces().size(), 2u);
  EXPECT_GT(points.pieces()[0].size(), points.pieces()[1].size()) << "the largest first";
  double shares = 0;
  for (std::size_t k = 0; k < points.size(); ++k) shares += points.share(k);
  EXPECT_NEAR(shares, 49, 1e-9);
  const Polyline line{{2, 3}, {6, 3}};
  EXPECT_TRUE(points.covers_any(line));
  const double gained = points.cover(line);
  EXPECT_NEAR(gained, 4 * 2 + kPi, 2) << "samples stand for equal shares, and are denser along outlines";
  EXPECT_NEAR(points.area(), 49 - gained, 1e-9);
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_EQ(points.covered(k), distance_to_segment(points.at(k), line[0], line[1]) <= 2 * kCoveredReach) << k;
  EXPECT_FALSE(points.covers_any(line));
  EXPECT_EQ(points.cover(line), 0);
}

// Oracle: cover() one line after the other.
TEST(UncoveredPoints, GainOfLinesCountsEachPointOnce) {
  UncoveredPoints points(box_region({0, 0}, {8, 6}), 2, 0.1);
  const std::vector<Polyline> lines{{{1, 1}, {6, 4}}, {{1, 4}, {6, 1}}, {{1, 1}, {6, 4}}};
  const double gain = points.gain(lines);
  double covered = 0;
  for (const Polyline& line : lines) covered += points.cover(line);
  EXPECT_NEAR(gain, covered, 1e-9);
  EXPECT_EQ(points.gain(lines), 0);
}

// Oracle: all curves one by one.
TEST(SimpleLink, IsTheCheapestFreeCurve) {
  for (const bool reverse : {false, true}) {
    const Problem problem = yard(2, reverse);
    const CarSpace space(problem);
    Rng rng(8);
    std::size_t found = 0;
    for (int i = 0; i < 150; ++i) {
      const Pose from{{rng.between(1.0, 39.0), rng.between(1.0, 29.0)}, rng.between(-kPi, kPi)};
      const Pose to{from.at + Point(rng.between(-8.0, 8.0), rng.between(-8.0, 8.0)), rng.between(-kPi, kPi)};
      std::optional<double> least;
      for (const Curve& curve : link_curves(from, to, 2, reverse))
        if (space.free(curve)) least = std::min(least.value_or(space.cost(curve)), space.cost(curve));
      const auto link = space.simple_link(from, to);
      ASSERT_EQ(link.has_value(), least.has_value()) << i;
      if (!link) continue;
      ++found;
      EXPECT_NEAR(space.cost(*link), *least, 1e-6) << i;
      EXPECT_TRUE(space.free(*link));
    }
    EXPECT_GT(found, 50u);
  }
}

// Both runs lead along the wall, a micrometre off it: the straight line past their ends would lead through the wall.
TEST(Strokes, AreNotJoinedThroughAWall) {
  const Problem problem = on(subtract(box_region({0, 0}, {20, 12}), box_region({8, 0}, {12, 4})), 2, true);
  const CarSpace space(problem);
  const double off = 1.6e-6;
  const Point end{5, 5 - off};
  const Path path{{{true, {{15, 5}, {10, 5}}}, {false, {{10, 5}, end}}, {true, {end, {10, 5}}}}};
  double metres = 0;
  for (const Stroke& stroke : strokes_of(path, problem, space)) {
    EXPECT_TRUE(space.free(stroke.points));
    metres += length(stroke.points);
  }
  EXPECT_NEAR(metres, 10, 1e-3);
}

TEST(UncoveredPoints, OfSmallPiecesOnlyTheAreaIsKnown) {
  const UncoveredPoints points(box_region({0, 0}, {0.1, 0.1}), 2, 0.1);
  EXPECT_NEAR(points.area(), 0.01, 1e-12);
  EXPECT_EQ(points.size(), 0u);
}

TEST(CoveringStrokes, CoverTheirPointAndStayInConfigurationSpace) {
  std::size_t found = 0;
  for (const bool reverse : {false, true}) {
    const Problem problem = yard(2, reverse);
    const CarSpace space(problem);
    const UncoveredPoints points(problem.target(), 2, 0);
    Rng rng(3);
    for (int i = 0; i < 100; ++i) {
      const std::size_t k = rng.below(points.size());
      for (const CoveringStroke& s : covering_strokes(points, k, space, 2)) {
        ++found;
        ASSERT_EQ(s.points.size(), 2u);
        EXPECT_TRUE(space.free(s.points));
        EXPECT_LE(distance_to_segment(points.at(k), s.points[0], s.points[1]), 2 * kCoveredReach + 1e-9);
        EXPECT_GT(s.gain, 0);
        EXPECT_LE(s.gain, 1.15 * (2 * length(s.points) + kPi) + 0.5) << "no more than its swath, but for sampling";
      }
    }
  }
  EXPECT_GT(found, 400u);
}

/// Lanes from left to right and back, 6 m apart, with free links.
std::vector<LinkedStroke> lanes(const CarSpace& space, const Point& start) {
  std::vector<LinkedStroke> driven;
  Pose at{start, 0};
  for (int k = 0; k < 3; ++k) {
    Polyline lane{{8, 6.0 + 6 * k}, {30, 6.0 + 6 * k}};
    if (k % 2 == 1) std::ranges::reverse(lane);
    driven.push_back({*space.simple_link(at, first_pose(lane)), lane, false});
    at = last_pose(lane);
  }
  return driven;
}

// Oracle: the search itself. Many more pairs than slots, asked for again with other limits.
TEST(KnownLinks, AreThoseThatTheSearchFinds) {
  for (const bool reverse : {false, true}) {
    const Problem problem = yard(2, reverse);
    const CarSpace space(problem);
    KnownLinks links(space, 1);
    Rng rng(reverse ? 11 : 12);
    std::vector<Pose> poses;
    for (int i = 0; i < 30; ++i)
      poses.push_back({{rng.between(0.0, 40.0), rng.between(0.0, 30.0)}, rng.between(-kPi, kPi)});
    std::size_t found = 0, limited = 0;
    for (int i = 0; i < 4000; ++i) {
      const Pose &from = poses[rng.below(poses.size())], &to = poses[rng.below(poses.size())];
      const double most = rng.chance(0.2) ? std::numeric_limits<double>::infinity() : rng.between(0.0, 80.0);
      const auto expected = space.simple_link(from, to, most), link = links.find(from, to, most);
      ASSERT_EQ(link.has_value(), expected.has_value()) << i;
      if (!link) {
        ++limited;
        continue;
      }
      ++found;
      ASSERT_EQ(points_of(*link, 0.01), points_of(*expected, 0.01)) << i;
      ASSERT_EQ(space.cost(*link), space.cost(*expected)) << i;
    }
    EXPECT_GT(found, 500u);
    EXPECT_GT(limited, 500u);
  }
}

TEST(InsertedStrokes, LeaveTheOthersWholeAndJoinExactly) {
  for (const bool reverse : {false, true})
    for (const auto seed : seeds(20)) {
      SCOPED_TRACE(fmt::format("reverse {}, seed {}", reverse, seed));
      const Problem problem = on(box_region({0, 0}, {40, 30}), 2, reverse);
      const CarSpace space(problem);
      Context context;
      DetourEffort effort;
      const std::vector<LinkedStroke> before = lanes(space, problem.start());
      KnownLinks links(space, before.size());
      InsertedStrokes inserted(before, links, 2, effort, context);
      Rng rng(seed);
      double more = 0, cost = 0;
      std::size_t n = 0;
      for (int i = 0; i < 8; ++i) {
        const Pose from{{rng.between(5.0, 35.0), rng.between(5.0, 25.0)}, rng.between(-kPi, kPi)};
        const Polyline line{from.at, ahead(from, 3).at};
        auto insertion = inserted.insertion_of(line, false);
        if (!insertion) continue;
        more += length(line), cost += insertion->cost, ++n;
        inserted.insert(std::move(*insertion));
      }
      EXPECT_GE(n, 4u);
      const std::vector<LinkedStroke> after = inserted.take();
      double strokes = 0;
      Pose at{problem.start(), 0};
      for (const LinkedStroke& s : after) {
        ASSERT_GE(s.stroke.size(), 2u);
        strokes += length(s.stroke);
        EXPECT_LT(distance(s.link.from.at, at.at), 1e-6);
        EXPECT_LT(distance(s.link.to.at, s.stroke.front()), 1e-6);
        EXPECT_LT(std::abs(std::remainder(s.link.from.heading - at.heading, 2 * kPi)), 1e-6);
        EXPECT_LT(std::abs(std::remainder(s.link.to.heading - first_pose(s.stroke).heading, 2 * kPi)), 1e-6);
        at = last_pose(s.stroke);
      }
      EXPECT_NEAR(strokes, 66 + more, 1e-6) << "all of the three lanes, and those inserted";
      const Path old = path_of(before, problem.start(), space.chord_error());
      const Path path = path_of(after, problem.start(), space.chord_error());
      const Score s = score(problem, path);
      EXPECT_EQ(s.flaw, "");
      EXPECT_EQ(s.value("curvature_violations"), 0);
      if (!reverse) { EXPECT_NEAR(path.length(), old.length() + cost, 0.01 * path.length()); }
      EXPECT_LT(area(subtract(uncovered(problem.target(), path, problem.robot()),
                              uncovered(problem.target(), old, problem.robot()))),
                0.02);
    }
}

// Lanes behind a door, given in any order: the robot drives through the door once each way, and from lane to lane.
TEST(ReinsertedStrokes, LanesOfARoomFollowEachOther) {
  const Problem problem =
      on(subtract(box_region({0, 0}, {80, 30}), {box_region({39, 0}, {40, 12}), box_region({39, 18}, {40, 30})}), 1.5,
         true);
  const CarSpace space(problem);
  const std::vector<LinkedStroke> before = lanes(space, problem.start());
  std::vector<Polyline> room;
  for (double y = 2; y < 29; y += 2) room.push_back({{50, y}, {76, y}});
  for (const auto seed : seeds(5)) {
    Rng rng(seed);
    for (std::size_t i = room.size(); i > 1; --i)
      std::swap(room[i - 1], room[static_cast<std::size_t>(rng.between(0, static_cast<int>(i) - 1))]);
    Context context;
    DetourEffort effort;
    KnownLinks links(space, before.size());
    const auto after = with_strokes(before, room, links, 2, effort, context);
    EXPECT_GE(after.size(), before.size() + room.size());
    const Path path = path_of(after, problem.start(), space.chord_error());
    EXPECT_EQ(score(problem, path).flaw, "");
    InsertedStrokes one_by_one(before, links, 2, effort, context);
    for (const Polyline& lane : room)
      if (auto insertion = one_by_one.insertion_of(lane, true)) one_by_one.insert(std::move(*insertion));
    const double each_from_the_door = path_of(one_by_one.take(), problem.start(), space.chord_error()).length();
    EXPECT_LT(path.length(), 0.75 * each_from_the_door) << seed;
  }
}

TEST(DrivableVisits, CoverMoreAndWhatWasCovered) {
  for (const bool reverse : {false, true}) {
    const Problem problem = on(box_region({0, 0}, {40, 30}), 2, reverse);
    const CarSpace space(problem);
    Context context;
    const std::vector<LinkedStroke> before = lanes(space, problem.start());
    const Path old = path_of(before, problem.start(), space.chord_error());
    const Polyline left_out{{5, 26}, {35, 26}};
    const std::vector<LinkedStroke> after =
        with_visits(problem, before, {left_out}, {.allowed = 0.1 * 1200}, space, context);
    const Path path = path_of(after, problem.start(), space.chord_error());
    EXPECT_EQ(score(problem, path).flaw, "");
    EXPECT_LE(uncovered_area(problem, path), 0.1 * 1200);
    EXPECT_GT(uncovered_area(problem, path), 0.07 * 1200) << "no more than it is asked for";
    EXPECT_LT(area(subtract(uncovered(problem.target(), path, problem.robot()),
                            uncovered(problem.target(), old, problem.robot()))),
              0.02);
    const Region under_it =
        subtract(problem.target(), uncovered(problem.target(), {{{true, left_out}}}, problem.robot()));
    EXPECT_LT(area(uncovered(under_it, path, problem.robot())), 0.02);
  }
}

// Pillars all over: visits cover what they must for each metre, and each piece takes few of them.
TEST(DrivableVisits, AreWorthTheirMetresAndFew) {
  for (const auto seed : seeds(1))
    for (const bool reverse : {false, true}) {
      SCOPED_TRACE(fmt::format("clutter {}, reverse {}", seed, reverse));
      Robot robot;
      robot.radius = 0.2, robot.tool_width = 0.4, robot.min_turn_radius = 0.3, robot.reverse = reverse;
      const Problem problem(generate("clutter", {{"width", 7.0}, {"height", 5.0}}, 800 + seed), robot);
      const CarSpace space(problem);
      std::vector<LinkedStroke> before;
      Pose at{problem.start(), 0};
      for (const Stroke& stroke : strokes_of(boustrophedon(problem.turning_on_the_spot()), problem, space))
        if (const auto link = space.simple_link(at, first_pose(stroke.points))) {
          before.push_back({*link, stroke.points, false});
          at = last_pose(stroke.points);
        }
      ASSERT_FALSE(before.empty());
      const Path old = path_of(before, problem.start(), space.chord_error());
      const Region left = uncovered(problem.target(), old, robot);
      Context context;
      const VisitLimits limits;
      const auto after = with_visits(problem, before, {}, limits, space, context);
      const Path path = path_of(after, problem.start(), space.chord_error());
      const Score s = score(problem, path);
      EXPECT_EQ(s.flaw, "");
      EXPECT_EQ(s.value("curvature_violations"), 0);
      const double gained = area(left) - uncovered_area(problem, path), added = path.length() - old.length();
      EXPECT_GE(gained, 0.8 * limits.least_gain * robot.tool_width * added) << "areas are sampled";
      EXPECT_GE(gained, 0);
      // A visit adds a stroke, and another one where it cuts a stroke in two. One covers a tool's length or more of a
      // large piece.
      EXPECT_LT(after.size() - before.size(),
                4 * left.polygons.size() + 4 * static_cast<std::size_t>(area(left) / 0.16));
    }
}

// Forwards, the nearest that a curve of radius R comes to a right-angled corner of configuration space is its own arc
// between the walls. With a tool as wide as the robot, of radius r, (1 - pi / 4) ((R + r)^2 - r^2) stay uncovered.
TEST(Drivable, ForwardsAllButTheCornersIsCovered) {
  for (const double turn : {1.0, 2.0, 3.0}) {
    SCOPED_TRACE(turn);
    const Problem problem = on(box_region({0, 0}, {30, 24}), turn, false);
    const Path path = boustrophedon(problem);
    const Score s = score(problem, path);
    EXPECT_EQ(s.flaw, "");
    EXPECT_EQ(s.value("curvature_violations"), 0);
    const double corners = 4 * (1 - kPi / 4) * (turn * turn + 2 * turn);
    EXPECT_GT(uncovered_area(problem, path), corners - 0.05);
    EXPECT_LT(uncovered_area(problem, path), corners + 1e-3 * area(problem.target()));
  }
}

// With a reverse gear it drives into a corner along the wall, and out again.
TEST(Drivable, InReverseCornersAreCoveredToo) {
  for (const double turn : {1.0, 3.0}) {
    const Problem problem = on(box_region({0, 0}, {30, 24}), turn, true);
    EXPECT_LT(uncovered_area(problem, boustrophedon(problem)), 1e-3 * area(problem.target())) << turn;
  }
}

TEST(Drivable, CoversUnseenMapsInReverse) {
  for (const std::string generator : {"rooms", "cave", "clutter", "field"})
    for (const auto seed : seeds(1)) {
      SCOPED_TRACE(fmt::format("{} {}", generator, seed));
      Robot robot;
      robot.radius = 0.2, robot.tool_width = 0.5, robot.min_turn_radius = 0.3, robot.reverse = true;
      const Problem problem(generate(generator, {{"width", 10.0}, {"height", 8.0}}, 400 + seed), robot);
      const Score s = score(problem, boustrophedon(problem));
      EXPECT_EQ(s.flaw, "");
      EXPECT_EQ(s.value("curvature_violations"), 0);
      EXPECT_GT(*s.value("coverage"), 0.99);
    }
}

}  // namespace
}  // namespace oxturn

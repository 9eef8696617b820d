#include "algorithms/lanes/laps.hpp"

#include <gtest/gtest.h>

#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/connector.hpp"
#include "coverage_oracle.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

// What repair leaves: seams thinner than a 250th of the tool's width, and specks.
constexpr double kSeams = 2e-3;
constexpr int kSamples = 700;

std::string text(const char* s) { return s; }

Path repaired(const Problem& problem, const Path& path) {
  Context context(1);
  const Connector connector(problem);
  return repaired(problem, path, connector, context);
}

Path tool_off(Path path) {
  for (Leg& leg : path.legs) leg.tool = false;
  return path;
}

// Whatever is missing: all of it, all but a walk at random, every other lane.
TEST(Repair, CoversTheTargetAfterAnyPath) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed)) {
      SCOPED_TRACE(p.map().source);
      const Path lanes = plan("zigzag", p, {{"fit", text("literal")}, {"outline", false}});
      for (const Path& path : {tool_off(lanes), plan("spiral-out", p, {{"length_limit", 15.0}}), lanes}) {
        const Path whole = repaired(p, path);
        expect_valid(p, whole);
        EXPECT_LE(uncovered_share(p, whole, kSamples), kSeams);
      }
    }
}

// The lemma on which repair rests, by brute force: a point of the target is within half a tool width of its foot on a
// lane's line; if the robot cannot be there, the boundary of configuration space is as near.
TEST(Repair, FeetOnLanesOrTheBoundaryCoverEveryPoint) {
  Rng rng(9);
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed)) {
      SCOPED_TRACE(p.map().source);
      const double w = p.robot().tool_width, angle = rng.between(0.0, kPi), first = rng.between(0.0, w);
      const Box box = bounding_box(p.target());
      for (int n = 0; n < 300;) {
        const Point q(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
        if (!contains(p.target(), q)) continue;
        ++n;
        const Point across = rotated({1, 0}, angle);
        const double off = std::remainder(q.dot(across) - first, w);
        ASSERT_LE(std::abs(off), w / 2);
        if (contains(p.configuration_space(), q - off * across)) continue;
        double wall = 1e300;
        for_each_edge(p.configuration_space(),
                      [&](const Point& a, const Point& b) { wall = std::min(wall, distance_to_segment(q, a, b)); });
        ASSERT_LE(wall, w / 2 + p.tolerance()) << to_text(q);
      }
    }
}

/// The path, and then once along the outer boundary of configuration space with the tool off.
Path along_walls_with_tool_off(const Problem& p, Path path) {
  Polyline walls = p.configuration_space().polygons[0].outer;
  walls.push_back(walls.front());
  path.legs.push_back({false, Connector(p).path(path.legs.back().points.back(), walls.front())});
  path.legs.push_back({false, walls});
  return path;
}

// Stops on walls are segments, even where the path passes them already and rounding puts them outside: from a point
// alone the tool would cover nothing.
TEST(Repair, StopsOnWallsThatThePathFollowsWithItsToolOff) {
  const Robot robot = disc(0.2, 0.85);
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    const Problem p(generate("polygon", {{"width", 12.0}, {"height", 6.0}, {"corners", 40}}, seed), robot);
    const Path path = along_walls_with_tool_off(p, plan("field-predictive", p, {{"repair", false}}));
    const Path whole = repaired(p, path);
    expect_valid(p, whole);
    for (const Polygon& piece : uncovered(p.target(), whole, robot).polygons)
      EXPECT_LT(2 * area(piece), 1.01 * covered_seam(robot) * perimeter({{piece}})) << to_text(piece.outer[0]);
  }
}

TEST(Repair, ACompletePathStaysAsItIs) {
  const Problem p(generate("clutter", {{"width", 8.0}, {"height", 6.0}}, 3), Robot{});
  const Path path = plan("boustrophedon", p);
  const Path same = repaired(p, path);
  ASSERT_EQ(same.legs.size(), path.legs.size());
  for (std::size_t k = 0; k < path.legs.size(); ++k) EXPECT_EQ(same.legs[k].points, path.legs[k].points);
}

// A tool narrower and wider than the robot, wherever the robot fits.
TEST(Repair, CoversWithNarrowAndWideTools) {
  for (const double tool : {0.1, 0.25, 0.8, 1.5}) {
    const Problem p(generate("clutter", {{"width", 8.0}, {"height", 6.0}}, 5), disc(0.2, tool));
    SCOPED_TRACE(tool);
    const Path whole = repaired(p, tool_off(plan("stc", p, {{"cell_size", 0.5}})));
    expect_valid(p, whole);
    EXPECT_LE(uncovered_share(p, whole, kSamples), kSeams);
  }
}

TEST(Contour, CoversEveryFamilyWholeWithEveryJoin) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed))
      for (const char* join : {"tree", "nearest", "alternating", "longest-edge"}) {
        SCOPED_TRACE(p.map().source + " " + join);
        const Path path = plan("contour", p, {{"join", text(join)}});
        expect_valid(p, path);
        EXPECT_LE(uncovered_share(p, path, kSamples), kSeams);
      }
}

TEST(Contour, OtherSpacingsAndToolsCover) {
  for (const double tool : {0.15, 0.4, 1.2})
    for (const double spacing : {0.7, 1.0, 1.6}) {
      const Problem p(generate("polygon", {{"width", 9.0}, {"height", 8.0}}, 4), disc(0.2, tool));
      const Path path = plan("contour", p, {{"spacing", spacing * tool}});
      expect_valid(p, path);
      EXPECT_LE(uncovered_share(p, path, kSamples), kSeams) << tool << " " << spacing;
    }
}

// By hand: laps of a square whose configuration space is 4 m wide, 0.4 m apart less 0.015 tool widths.
TEST(Contour, LapsOfASquare) {
  const Problem p(Map{"square", box_region({0, 0}, {4.4, 4.4}), "", ""}, disc(0.2, 0.4), Point(0.2, 0.2));
  const double step = 0.4 * (1 - 0.015);
  double laps = 0;
  for (double side = 4; side > 0; side -= 2 * step) laps += 4 * side;
  const Path closed = plan("contour", p, {{"repair", false}});
  EXPECT_NEAR(closed.length(true), laps + 2 * 5 * step, 0.01);  // five links, there and back
  const Path nearest = plan("contour", p, {{"variant", text("published")}});
  EXPECT_NEAR(nearest.length(true), laps + 5 * std::sqrt(2) * step, 0.01);  // from vertex to vertex
  const Path open = plan("contour", p, {{"join", text("alternating")}, {"repair", false}});
  EXPECT_LT(open.length(true), laps);
}

// On convex rooms nothing is driven twice but at corners.
TEST(Contour, IsNearTheAreaBound) {
  const Problem p(Map{"hall", box_region({0, 0}, {30, 20}), "", ""}, Robot{}, Point(15, 10));
  const double bound = area(p.target()) / p.robot().tool_width;
  EXPECT_LT(plan("contour", p).length(), 1.12 * bound);
}

TEST(Contour, TurnsWithTheMap) {
  const Region room = box_region({0, 0}, {7.3, 5.1});
  const auto length_at = [&](double angle) {
    const Problem p(Map{"room", transformed(room, angle, Point(1, 2)), "", ""}, Robot{},
                    rotated(Point(1, 1), angle) + Point(1, 2));
    return plan("contour", p).length();
  };
  EXPECT_NEAR(length_at(0.7), length_at(0), 0.02 * length_at(0));
}

// Laps around the field, lanes inside: as much is covered as with the outline.
TEST(Headland, CoversEveryFamilyWhole) {
  for (const Problem& p : sample_problems(3))
    for (const char* planner : {"boustrophedon", "zigzag", "oarp"})
      for (const std::int64_t laps : {1, 2, 40})
        for (const char* order : {"first", "last"}) {
          SCOPED_TRACE(fmt::format("{} {} {} {}", p.map().source, planner, laps, order));
          const Path path = plan(planner, p, {{"headland", laps}, {"headland_order", text(order)}});
          expect_valid(p, path);
          EXPECT_LE(uncovered_share(p, path, kSamples), kSeams);
        }
}

// The robot begins with the boundary, or ends with it.
TEST(Headland, LapsComeFirstOrLast) {
  const Problem p(Map{"square", box_region({0, 0}, {10.4, 10.4}), "", ""}, disc(0.2, 0.4), Point(0.2, 0.2));
  const auto boundary_share = [](const Polyline& line, bool at_end) {
    double on = 0, driven = 0;
    Polyline points = line;
    if (at_end) std::reverse(points.begin(), points.end());
    for (std::size_t i = 1; i < points.size() && driven < 40; ++i) {
      const Point middle = (points[i] + points[i - 1]) / 2;
      const double size = distance(points[i], points[i - 1]);
      const double off = std::min({middle.x() - 0.2, middle.y() - 0.2, 10.2 - middle.x(), 10.2 - middle.y()});
      driven += size;
      if (off < 1e-6) on += size;
    }
    return on / driven;
  };
  for (const char* planner : {"boustrophedon", "zigzag"})
    for (const bool last : {false, true}) {
      const Path path =
          plan(planner, p, {{"headland", std::int64_t{2}}, {"headland_order", text(last ? "last" : "first")}});
      Polyline all;
      for (const Leg& leg : path.legs) all.insert(all.end(), leg.points.begin(), leg.points.end());
      EXPECT_GT(boundary_share(all, last), 0.95) << planner << last;
      EXPECT_LT(boundary_share(all, !last), 0.5) << planner << last;
    }
}

// laps: covers as with the tool on, but lifts it between lanes. off: the headland stays unworked.
TEST(Headland, TheToolIsOnOrOffAsAsked) {
  const Problem p(Map{"square", box_region({0, 0}, {10.4, 10.4}), "", ""}, disc(0.2, 0.4), Point(0.2, 0.2));
  for (const char* planner : {"boustrophedon", "trapezoid", "zigzag", "field", "oarp"}) {
    SCOPED_TRACE(planner);
    const auto with = [&](const char* tool) {
      return plan(planner, p, {{"headland", std::int64_t{3}}, {"headland_tool", text(tool)}});
    };
    const auto work_legs = [](const Path& path) {
      return std::ranges::count_if(path.legs, [](const Leg& leg) { return leg.tool; });
    };
    const Path on = with("on"), laps = with("laps"), off = with("off");
    for (const Path* path : {&on, &laps, &off}) expect_valid(p, *path);
    EXPECT_EQ(uncovered_share(p, on, kSamples), 0);
    EXPECT_EQ(uncovered_share(p, laps, kSamples), 0);
    EXPECT_GT(work_legs(laps), work_legs(on) + 15) << "each of some 20 lanes by itself";
    EXPECT_GT(work_legs(off), 15);
    for (const Leg& leg : off.legs)
      for (const Point& q : leg.points) {
        if (!leg.tool) continue;
        EXPECT_GT(std::min({q.x(), q.y(), 10.4 - q.x(), 10.4 - q.y()}), 0.2 + 2 * 0.4);
      }
  }
}

// Laps that fill the field are `contour`'s, and no lane is left.
TEST(Headland, ManyLapsLeaveNoLanes) {
  const Problem p(Map{"square", box_region({0, 0}, {4.4, 4.4}), "", ""}, disc(0.2, 0.4), Point(0.2, 0.2));
  const double all_laps = plan("boustrophedon", p, {{"headland", std::int64_t{100}}}).length(true);
  EXPECT_NEAR(all_laps, plan("contour", p, {{"join", text("nearest")}}).length(true), 0.1 * all_laps);
}

// With the tool off in it, such a headland leaves nothing to do: that is said, in place of an empty path.
TEST(Headland, WithTheToolOffItMustLeaveRoomForLanes) {
  const Problem p(Map{"square", box_region({0, 0}, {4.4, 4.4}), "", ""}, disc(0.2, 0.4), Point(0.2, 0.2));
  for (const char* planner : {"boustrophedon", "trapezoid", "zigzag", "field", "oarp"})
    EXPECT_THROW(plan(planner, p, {{"headland", std::int64_t{100}}, {"headland_tool", text("off")}}), Infeasible)
        << planner;
}

TEST(Laps, AloneAreTheSame) {
  const Problem p(generate("clutter", {{"width", 8.0}, {"height", 6.0}}, 1), {});
  const double width = p.robot().tool_width;
  const Laps laps = laps_of(p, width, Context(1)), alone = laps_alone(p, width, Context(1));
  EXPECT_FALSE(laps.between.empty());
  EXPECT_TRUE(alone.between.empty());
  EXPECT_EQ(laps.outermost, alone.outermost);
  EXPECT_EQ(laps.depth_m, alone.depth_m);
  ASSERT_EQ(laps.all.size(), alone.all.size());
  for (std::size_t k = 0; k < laps.all.size(); ++k) {
    EXPECT_EQ(laps.all[k].ring, alone.all[k].ring);
    EXPECT_EQ(laps.all[k].inner, alone.all[k].inner);
  }
}

}  // namespace
}  // namespace oxturn

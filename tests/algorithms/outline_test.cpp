// Laps along walls, links between lanes, and what becomes of vertices close to each other.
#include "algorithms/lanes/outline.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/transit/short_segments.hpp"
#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"
#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kPixel = 0.05;

/// As read from an image: the pixels inside the region.
Map traced(const Region& region) {
  const Box box = bounding_box(region);
  const int columns = static_cast<int>(box.size().x() / kPixel) + 1;
  const int rows = static_cast<int>(box.size().y() / kPixel) + 1;
  return {"traced", trace(rasterise(region, box.low, kPixel, columns, rows, CellRule::inside)), "", ""};
}

// A slanted hall is a staircase in an image. Its lap must not turn at every step.
TEST(Outline, LapsRunStraightAlongTracedWalls) {
  const Region hall = transformed(box_region({0, 0}, {60, 40}), kPi / 4, {100, 100});
  const Problem drawn(Map{"hall", hall, "", ""}, Robot{}), image(traced(hall), Robot{});
  for (const char* planner : {"boustrophedon", "zigzag", "hyun"}) {
    const Score exact = score(drawn, plan(planner, drawn)), pixels = score(image, plan(planner, image));
    EXPECT_EQ(pixels.flaw, "") << planner;
    EXPECT_GT(*pixels.value("coverage"), 0.9995) << planner;
    EXPECT_LT(*pixels.value("turns"), 1.5 * *exact.value("turns") + 50) << planner;
  }
}

TEST(Outline, StraightenedSpaceLiesInsideAndMissesLittle) {
  std::size_t before = 0, after = 0;
  for (const auto seed : seeds(4))
    for (const double tool : {0.2, 0.4, 0.8}) {
      SCOPED_TRACE(fmt::format("seed {}, tool {}", seed, tool));
      const Problem image(traced(generate("cave", {{"width", 9.0}, {"height", 8.0}}, seed).free), disc(0.15, tool));
      const Region& space = image.configuration_space();
      const Region straight = straightened_space(image);
      before += vertex_count(space);
      after += vertex_count(straight);
      EXPECT_LE(area(straight), (1 + 1e-12) * area(space));
      const Region missed = subtract(image.target(), dilate(straight, tool / 2, tool / 5000, Bound::inside));
      EXPECT_LE(area(missed), 5.1e-4 * area(image.target()));
      for_each_edge(straight, [&](const Point& a, const Point& b) { EXPECT_TRUE(image.walls().contains(a, b)); });
    }
  EXPECT_LT(after, before);
}

// Walls that are no staircases are followed, but for arcs.
TEST(Outline, DrawnWallsStayAsTheyAre) {
  for (const Problem& p : sample_problems(3)) {
    EXPECT_EQ(vertex_count(straightened_space(p)), vertex_count(coarser_space(p))) << p.map().source;
    EXPECT_LE(vertex_count(coarser_space(p)), vertex_count(p.configuration_space())) << p.map().source;
  }
}

Polyline only_leg(const Path& path) {
  Polyline all;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points)
      if (all.empty() || all.back() != p) all.push_back(p);
  return all;
}

// Two lanes of different length: the robot turns where the longer one ends.
TEST(Strips, TurnSquareInTheOpenAndStraightAlongWalls) {
  const Problem hall(Map{"hall", box_region({0, 0}, {20, 20}), "", ""}, Robot{}, Point(5, 5));
  const Connector connector(hall);
  Context context;
  const auto path_of = [&](const LaneEnds& a, const LaneEnds& b) {
    return only_leg(drive_strips(hall, {Strip{{a, b}}}, StripOrder::given, connector, context));
  };
  const Polyline up = path_of({{5, 5}, {5, 10}}, {{5.4, 5}, {5.4, 11}});
  EXPECT_EQ(up, (Polyline{{5, 5}, {5, 10}, {5, 11}, {5.4, 11}, {5.4, 5}}));
  const Polyline down = path_of({{5, 5}, {5, 11}}, {{5.4, 5}, {5.4, 10}});
  EXPECT_EQ(down, (Polyline{{5, 5}, {5, 11}, {5.4, 11}, {5.4, 10}, {5.4, 5}}));
  const Polyline at_wall = path_of({{5, 5}, {5, 19.5}}, {{5.4, 5}, {5.4, 19.7}});
  EXPECT_EQ(at_wall, (Polyline{{5, 5}, {5, 19.5}, {5.4, 19.7}, {5.4, 5}}));
}

TEST(ShortSegments, AreDroppedWhereTheShortcutIsFree) {
  Robot robot;
  robot.radius = 0.2;
  const Problem hall(Map{"hall", box_region({0, 0}, {20, 20}), "", ""}, robot, Point(1, 1));
  const Path path{{{true, {{1, 1}, {5, 1}, {5.0005, 1.0005}, {5.001, 1.001}, {5.001, 9}, {5.0012, 9}}}}};
  const Path short_of_it = without_short_segments(path, hall);
  ASSERT_EQ(short_of_it.legs.size(), 1u);
  EXPECT_EQ(short_of_it.legs[0].points, (Polyline{{1, 1}, {5, 1}, {5.0012, 9}}));
}

// No vertex nearer to the one before than a hundredth of the radius, unless a wall or a change of the tool is between.
// Two vertices within rounding at the end, the second one just around a corner from the vertex before them.
TEST(ShortSegments, AtTheEndDoNotEatThePathBefore) {
  Region free = box_region({0, 0}, {10, 10});
  free.polygons[0].holes.push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}});
  const Problem hall(Map{"hall", free, "", ""}, Robot{}, Point(1, 1));
  const Ring hole = hall.configuration_space().polygons[0].holes[0];
  for (std::size_t k = 0; k < hole.size(); ++k) {
    const Point &before = hole[k], &corner = hole[(k + 1) % hole.size()], &after = hole[(k + 2) % hole.size()];
    Polyline line{{1, 1}};
    for (int j = 0; j < 200; ++j) line.push_back({1 + 8 * (j % 2), 1 + 0.01 * j});
    const Polyline link = Connector(hall).path(line.back(), before);
    line.insert(line.end(), link.begin() + 1, link.end());
    line.push_back(corner);
    line.push_back(corner + 2e-6 * (after - corner).normalized());
    const Path path{{Leg{true, line}}};
    EXPECT_NEAR(without_short_segments(path, hall).length(), path.length(), 0.05) << k;
  }
}

TEST(ShortSegments, PolygonPlannersAndHabitsLeaveNone) {
  for (const auto seed : seeds(3))
    for (const Problem& p : sample_problems(seed))
      for (const char* planner :
           {"boustrophedon", "zigzag", "hyun", "random-walk", "spiral-out", "wall-follow", "vacuum-mix"}) {
        SCOPED_TRACE(p.map().source + " " + planner);
        const Path path = plan(planner, p);
        const Connector connector(p);
        int avoidable = 0;
        for (const Leg& leg : path.legs)
          for (std::size_t i = 1; i + 1 < leg.points.size(); ++i)
            if (distance(leg.points[i - 1], leg.points[i]) < p.robot().radius / 100 &&
                connector.straight(leg.points[i - 1], leg.points[i + 1]))
              ++avoidable;
        EXPECT_EQ(avoidable, 0);
      }
}

}  // namespace
}  // namespace oxturn

// Strokes whose area the others cover are taken out, and no others.
#include "algorithms/smoothing/needless_strokes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/lanes/uncovered.hpp"
#include "algorithms/smoothing/strokes.hpp"
#include "geometry/overlay/boolean.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Robot car(double turn, bool reverse) {
  Robot robot;
  robot.radius = 1, robot.tool_width = 2, robot.min_turn_radius = turn, robot.reverse = reverse;
  return robot;
}

std::vector<LinkedStroke> linked(const std::vector<Polyline>& lines, const CarSpace& space, const Point& start) {
  std::vector<LinkedStroke> all;
  Pose at{start, 0};
  for (const Polyline& line : lines) {
    if (const auto link = space.simple_link(at, first_pose(line))) {
      all.push_back({*link, line, false});
      at = last_pose(line);
    }
  }
  return all;
}

Path planned(const Problem& problem) {
  Context context;
  return brief_built_in().find("boustrophedon").make({}, brief_built_in())->plan(problem, context);
}

double uncovered_area(const Problem& problem, const Path& path) {
  return area(uncovered(problem.target(), path, problem.robot()));
}

double cost(const std::vector<LinkedStroke>& strokes, const CarSpace& space) {
  double sum = 0;
  for (const LinkedStroke& s : strokes) sum += space.cost(s.link) + length(s.stroke);
  return sum;
}

TEST(NeedlessStrokes, ThoseDrivenTwiceAreTakenOut) {
  for (const bool reverse : {false, true}) {
    const Problem problem(Map{"plain", box_region({0, 0}, {40, 30}), "test", "test"}, car(2, reverse));
    const CarSpace space(problem);
    const Polyline a{{6, 6}, {34, 6}}, b{{34, 14}, {6, 14}}, c{{6, 22}, {34, 22}}, part{{20, 14}, {30, 14}};
    const Context context;
    std::size_t tries = 0;
    const auto driven = linked({a, part, b, c, part}, space, problem.start());
    ASSERT_EQ(driven.size(), 5u);
    const auto rest = without_needless_strokes(driven, problem.target(), 2, space, context, &tries);
    ASSERT_EQ(rest.size(), 3u);
    EXPECT_EQ(rest[0].stroke, a);
    EXPECT_EQ(rest[1].stroke, b);
    EXPECT_EQ(rest[2].stroke, c);
    EXPECT_LE(tries, 3 * driven.size());
    EXPECT_EQ(without_needless_strokes(rest, problem.target(), 2, space, context).size(), 3u);
  }
}

// On generated problems: no longer, still drivable, and nothing is lost but what lies between the points of the raster.
TEST(NeedlessStrokes, NothingIsLost) {
  std::size_t taken_out = 0;
  for (const std::string generator : {"clutter", "cave", "field"})
    for (const auto seed : seeds(1))
      for (const bool reverse : {false, true}) {
        SCOPED_TRACE(fmt::format("{} {}, reverse {}", generator, seed, reverse));
        Robot robot;
        robot.radius = 0.2, robot.tool_width = 0.4, robot.min_turn_radius = 0.3, robot.reverse = reverse;
        const Problem problem(generate(generator, {{"width", 8.0}, {"height", 7.0}}, 700 + seed), robot);
        const CarSpace space(problem);
        std::vector<Polyline> lines;
        for (const Stroke& stroke : strokes_of(planned(problem.turning_on_the_spot()), problem, space))
          lines.push_back(stroke.points);
        const std::size_t once = lines.size();
        for (std::size_t i = 0; i < once; i += 2) lines.push_back(lines[i]);
        const auto driven = linked(lines, space, problem.start());
        const Context context;
        std::size_t tries = 0;
        const auto rest = without_needless_strokes(driven, problem.target(), robot.tool_width, space, context, &tries);
        taken_out += driven.size() - rest.size();
        EXPECT_LE(tries, 3 * driven.size());
        EXPECT_LE(cost(rest, space), cost(driven, space) + 1e-9);
        const Path before = path_of(driven, problem.start(), space.chord_error());
        const Path path = path_of(rest, problem.start(), space.chord_error());
        const Score s = score(problem, path);
        EXPECT_EQ(s.flaw, "");
        EXPECT_EQ(s.value("curvature_violations"), 0);
        EXPECT_LE(uncovered_area(problem, path), uncovered_area(problem, before) + 1e-3 * area(problem.target()));
      }
  EXPECT_GT(taken_out, 6u);
}

}  // namespace
}  // namespace oxturn

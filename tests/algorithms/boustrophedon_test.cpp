#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/polygon/cell_strips.hpp"
#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/trace.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

double lanes_needed(const Problem& p) { return area(p.target()) / p.robot().tool_width; }

void expect_complete(const Problem& problem, const Settings& settings = {}, double bound = 0) {
  const Path path = plan("boustrophedon", problem, settings);
  expect_valid(problem, path);
  EXPECT_EQ(uncovered_share(problem, path, 1500), 0);
  if (bound > 0) { EXPECT_LT(path.length(), bound * lanes_needed(problem)); }
}

// Where a lane is on an upright step of the boundary, the link from it goes up the step, not straight past its corner.
TEST(Boustrophedon, LinksClimbAStepAtALane) {
  const Problem p(Map{"room", box_region({-1, -1}, {5, 4}), "", ""}, disc(0.2, 2));
  const LaneField field(p, 90, 2);
  BoustrophedonCell cell;
  cell.lower = {{0, 0}, {2, 0}, {2, 1}, {4, 1}};
  cell.upper = {{0, 3}, {2, 3}, {2, 2}, {4, 2}};
  Context context(1);
  const Strip strip = cell_strips(field, {cell}, LaneFit::spaced, context).front();
  ASSERT_EQ(strip.lanes.size(), 3U);
  ASSERT_EQ(strip.low_links.size(), 2U);
  const auto expect_link = [&](const Polyline& link, const Polyline& expected) {
    ASSERT_EQ(link.size(), expected.size());
    for (std::size_t i = 0; i < link.size(); ++i)
      EXPECT_LT(distance(link[i], field.frame.to_world(expected[i])), 2 * field.margin) << i;
  };
  expect_link(strip.low_links[0], {{0, 0}, {2, 0}});
  expect_link(strip.low_links[1], {{2, 0}, {2, 1}, {4, 1}});
  expect_link(strip.high_links[0], {{0, 3}, {2, 3}});
  expect_link(strip.high_links[1], {{2, 3}, {2, 2}, {4, 2}});
}

TEST(Boustrophedon, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(4))
    for (const Problem& p : sample_problems(seed)) {
      SCOPED_TRACE(p.map().source);
      expect_complete(p, {}, 2.4);
    }
}

TEST(Boustrophedon, EverySettingWithOutlineCoversWhole) {
  for (const Problem& p : sample_problems(9)) {
    SCOPED_TRACE(p.map().source);
    expect_complete(p, {{"cells", std::string("exact")}});
    expect_complete(p, {{"cells", std::string("exact")}, {"order", std::string("dfs")}, {"spacing", 0.8}});
    expect_complete(p, {{"order", std::string("nearest")}, {"sweep", std::string("given")}, {"angle", 33.0}});
  }
}

// As in the paper: seams along walls may stay uncovered, but the path is valid and covers most.
TEST(Boustrophedon, WithoutOutlineIsValidAndCoversMost) {
  for (const Problem& p : sample_problems(2))
    for (const char* cells : {"exact", "slab"}) {
      SCOPED_TRACE(p.map().source + " " + cells);
      const Path path = plan("boustrophedon", p, {{"outline", false}, {"cells", std::string(cells)}});
      expect_valid(p, path);
      EXPECT_LT(uncovered_share(p, path, 1000), std::string(cells) == "exact" ? 0.25 : 0.4);
    }
}

TEST(Boustrophedon, FieldOfThePublishedSizeIsNearTheLeastLength) {
  for (const auto seed : seeds(3)) {
    const Problem p(generate("field", {}, seed), disc(0.5, 1));
    EXPECT_LT(plan("boustrophedon", p).length(), 1.35 * lanes_needed(p)) << seed;
  }
}

// A rectangle by hand: the outline of C, and lanes 0.4 apart in R.
TEST(Boustrophedon, EmptyRectangleTakesItsOutlineAndItsLanes) {
  const Problem p(Map{"hall", box_region({0, 0}, {6, 4.4}), "", ""}, disc(0.2, 0.4));
  const Path path = plan("boustrophedon", p);
  // C is 5.6 x 4, R is 5.2 x 3.6: 9 lanes of 5.2, 8 links of 0.4, once round C, from the start to a vertex of R, and
  // to the wall and back.
  const double work = 9 * 5.2 + 8 * 0.4 + 2 * (5.6 + 4);
  EXPECT_GT(path.length(), work - 0.01);
  EXPECT_LT(path.length(), work + 3.4 + 2 * 0.4);
}

TEST(Boustrophedon, ShiftedRotatedAndMirroredMapsTakeTheSameLength) {
  for (const char* name : {"field", "clutter"}) {
    const Map map = generate(name, {{"width", 16.0}, {"height", 11.0}}, 3);
    const Problem base(map, Robot{});
    const double length = plan("boustrophedon", base).length();
    const auto length_of = [&](Region region, Point start) {
      return plan("boustrophedon", Problem(Map{"transformed", std::move(region), "", ""}, Robot{}, start)).length();
    };
    const Point s = base.start(), shift(1e4, -3e4);
    EXPECT_NEAR(length_of(transformed(map.free, 0, shift), s + shift) / length, 1, 0.05) << name;
    for (const double degrees : {90.0, 180.0, 37.0})
      EXPECT_NEAR(
          length_of(transformed(map.free, degrees * kPi / 180, {0, 0}), rotated(s, degrees * kPi / 180)) / length, 1,
          0.07)
          << name << " " << degrees;
    EXPECT_NEAR(length_of(mirrored(map.free), {-s.x(), s.y()}) / length, 1, 0.07) << name;
  }
}

TEST(Boustrophedon, SameProblemSamePath) {
  const Problem p(generate("clutter", {{"width", 8.0}, {"height", 8.0}}, 5), Robot{});
  const Path a = plan("boustrophedon", p), b = plan("boustrophedon", p);
  ASSERT_EQ(a.legs.size(), b.legs.size());
  for (std::size_t i = 0; i < a.legs.size(); ++i) EXPECT_EQ(a.legs[i].points, b.legs[i].points);
}

TEST(Boustrophedon, CorridorsWhereOnlyTheWallsAreDriven) {
  for (const double width : {0.41, 0.5, 0.75, 0.79, 0.8, 0.81, 1.21}) {
    SCOPED_TRACE(width);
    Region frame = box_region({0, 0}, {5, 4});
    Ring hole = box_region({width, width}, {5 - width, 4 - width}).polygons[0].outer;
    std::reverse(hole.begin(), hole.end());
    frame.polygons[0].holes.push_back(hole);
    expect_complete(Problem(Map{"ring", frame, "", ""}, disc(0.2, 0.4), Point(2.5, width / 2)));
  }
}

TEST(Boustrophedon, DegenerateMaps) {
  // One cell with hardly any room; a pillar smaller than the tool; walls that touch in a corner; two rooms and a door.
  expect_complete(drawn({"."}, {.cell = 0.41}));
  expect_complete(drawn({"."}, {.cell = 0.8}));
  expect_complete(drawn({"....", ".#..", "....", "...."}, {.cell = 0.3, .robot = disc(0.05, 0.5)}));
  expect_complete(drawn({"....", "..#.", ".#..", "...."}));
  expect_complete(drawn({".....#.....", ".....#.....", "...........", ".....#.....", ".....#....."}, {.cell = 0.45}));
  // A robot without size; tools narrower and wider than the robot.
  expect_complete(drawn({"...", ".#.", "..."}, {.robot = disc(0, 0.3)}));
  expect_complete(drawn({"...", ".#.", "..."}, {.robot = disc(0.4, 0.2)}));
  expect_complete(drawn({"...", ".#.", "..."}, {.robot = disc(0.1, 0.9)}));
}

TEST(Boustrophedon, FarAndTinyCoordinates) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const Region region = drawn_region({"....", ".#..", "..#.", "...."}, scale);
    const Point shift = 1e6 * scale * Point(1, -1);
    expect_complete(Problem(Map{"far", transformed(region, 0, shift), "", ""}, disc(0.2 * scale, 0.4 * scale)));
  }
}

TEST(Boustrophedon, OtherComponentsOfFreeSpaceAreNotVisited) {
  const Problem p = drawn({"S..#...", "...#...", "...#..."});
  const Path path = plan("boustrophedon", p);
  expect_valid(p, path);
  for (const Leg& leg : path.legs)
    for (const Point& q : leg.points) EXPECT_LT(q.x(), 3);
}

TEST(Boustrophedon, ACancelledRunReturnsAValidBeginning) {
  const Problem p(generate("clutter", {{"width", 8.0}, {"height", 8.0}}, 5), Robot{});
  Context context(1);
  context.cancel();
  const Path path = built_in_planner("boustrophedon")->plan(p, context);
  EXPECT_LT(path.length(), plan("boustrophedon", p).length());
}

TEST(Boustrophedon, TracesWhatItDrives) {
  const Problem p = drawn({"....", ".#..", "...."});
  std::vector<std::string> names;
  Context::Sinks sinks;
  sinks.trace = [&](const Trace& t) { names.push_back(t.name); };
  Context context(1, 1e9, sinks);
  built_in_planner("boustrophedon", {{"cells", std::string("exact")}})->plan(p, context);
  EXPECT_THAT(names, testing::ElementsAre("cells", "lanes"));
}

// What is left of a narrow room beside its walls takes one lane along it, not many short ones across.
TEST(Boustrophedon, ANarrowRoomTakesOneLane) {
  const Region free =
      unite({box_region({0, 0}, {8, 4}), box_region({2, 4}, {2.6, 4.5}), box_region({2, 4.5}, {2.9, 8})});
  const Problem p(Map{"annex", free, "", ""}, disc(0.2, 0.4), Point(4, 2));
  std::vector<Polyline> lanes;
  Context::Sinks sinks;
  sinks.trace = [&](const Trace& t) { lanes = t.lines; };
  Context context(1, 1e9, sinks);
  const Path path =
      built_in_planner("boustrophedon", {{"sweep", std::string("given")}, {"angle", 0.0}})->plan(p, context);
  EXPECT_EQ(uncovered_share(p, path, 1500), 0);
  int in_annex = 0;
  for (const Polyline& lane : lanes) in_annex += lane.front().y() > 4.4 ? 1 : 0;
  EXPECT_EQ(in_annex, 1);
}

TEST(Boustrophedon, AnUnknownOrderIsOneSentence) {
  EXPECT_THAT(
      [] {
        built_in_planner("boustrophedon", {{"order", std::string("random")}});
      },
      testing::ThrowsMessage<std::invalid_argument>(HasSubstr("order")));
}

TEST(Trapezoid, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(3))
    for (const Problem& p : sample_problems(seed)) {
      SCOPED_TRACE(p.map().source);
      const Path path = plan("trapezoid", p);
      expect_valid(p, path);
      EXPECT_EQ(uncovered_share(p, path, 1500), 0);
    }
}

}  // namespace
}  // namespace oxturn

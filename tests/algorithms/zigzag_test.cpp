#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/polygon/parts.hpp"
#include "coverage_oracle.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

double lanes_needed(const Problem& p) { return area(p.target()) / p.robot().tool_width; }
std::string text(const char* s) { return s; }

void expect_complete(const Problem& problem, const Settings& settings = {}, double bound = 0) {
  const Path path = plan("zigzag", problem, settings);
  expect_valid(problem, path);
  EXPECT_EQ(uncovered_share(problem, path, 1500), 0);
  if (bound > 0) { EXPECT_LT(path.length(), bound * lanes_needed(problem)); }
}

TEST(Zigzag, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(4))
    for (const Problem& p : sample_problems(seed)) {
      SCOPED_TRACE(p.map().source);
      expect_complete(p, {}, 3);
    }
}

TEST(Zigzag, EveryPartitionCoversWhole) {
  for (const Problem& p : sample_problems(11))
    for (const char* partition : {"approximate", "monotone", "trapezoid", "none"}) {
      SCOPED_TRACE(p.map().source + " " + partition);
      expect_complete(p, {{"partition", text(partition)}});
      expect_complete(p, {{"partition", text(partition)}, {"sweep", text("given")}, {"angle", 20.0}, {"margin", 0.1}});
    }
}

// The source's lines leave gaps, but the path never leaves configuration space.
TEST(Zigzag, LiteralIsValidAndCoversMost) {
  for (const Problem& p : sample_problems(5)) {
    SCOPED_TRACE(p.map().source);
    for (const char* small : {"merge", "drop"}) {
      const Path path =
          plan("zigzag", p, {{"fit", text("literal")}, {"partition", text("auto")}, {"small_parts", text(small)}});
      expect_valid(p, path);
      EXPECT_LT(uncovered_share(p, path, 1000), 0.25);
    }
  }
}

// The source's figure, by hand: vertical lines in a square of 3.2 inside the margin, 0.4 apart, the first 0.2 inside.
TEST(Zigzag, LiteralLinesInASquare) {
  const Problem p(Map{"square", box_region({0, 0}, {4, 4}), "", ""}, disc(0.2, 0.4));
  const Path path =
      plan("zigzag", p, {{"fit", text("literal")}, {"sweep", text("given")}, {"angle", 90.0}, {"outline", false}});
  std::vector<double> lines;
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; leg.tool && i < leg.points.size(); ++i)
      if (std::abs(leg.points[i].y() - leg.points[i - 1].y()) > 3) lines.push_back(leg.points[i].x());
  std::sort(lines.begin(), lines.end());
  ASSERT_EQ(lines.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(lines[k], 0.6 + 0.4 * static_cast<double>(k), 0.01);
}

TEST(Zigzag, TooManyVerticesForTheOptimalPartitionIsOneSentence) {
  const Problem p(generate("clutter", {{"width", 20.0}, {"height", 20.0}}, 1), Robot{});
  EXPECT_THAT(
      [&] {
        plan("zigzag", p, {{"partition", text("convex")}});
      },
      ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("150 vertices"), HasSubstr("approximate"))));
}

TEST(Zigzag, TheOptimalPartitionOfSmallMaps) {
  expect_complete(drawn({"...", ".#.", "..."}), {{"partition", text("convex")}});
  expect_complete(drawn({"...", "..#", "..."}), {{"partition", text("convex")}});
}

TEST(Zigzag, DegenerateMaps) {
  expect_complete(drawn({"."}, {.cell = 0.41}));
  expect_complete(drawn({"."}, {.cell = 0.8}));
  expect_complete(drawn({"....", ".#..", "....", "...."}, {.cell = 0.3, .robot = disc(0.05, 0.5)}));
  expect_complete(drawn({"....", "..#.", ".#..", "...."}));
  expect_complete(drawn({"...", ".#.", "..."}, {.robot = disc(0, 0.3)}));
  expect_complete(drawn({"...", ".#.", "..."}, {.robot = disc(0.4, 0.2)}));
}

TEST(Zigzag, SaysThatNoLaneKeepsSoFarOffTheWalls) {
  const Problem aisle(Map{"aisle", box_region({0, 0}, {9, 3}), "", ""}, Robot{});
  EXPECT_THAT(([&] {
                plan("zigzag", aisle, {{"margin", 1.5}, {"outline", text("false")}});
              }),
              ThrowsMessage<Infeasible>(HasSubstr("no lane lies 1.5 m off the walls")));
  EXPECT_FALSE(plan("zigzag", aisle, {{"margin", 1.2}, {"outline", text("false")}}).legs.empty());
}

TEST(Zigzag, ShiftedRotatedAndMirroredMapsTakeAboutTheSameLength) {
  const Map map = generate("field", {{"width", 16.0}, {"height", 11.0}, {"ponds", std::int64_t{4}}}, 3);
  const Problem base(map, Robot{});
  const double length = plan("zigzag", base).length();
  const auto length_of = [&](Region region, Point start) {
    return plan("zigzag", Problem(Map{"transformed", std::move(region), "", ""}, Robot{}, start)).length();
  };
  const Point s = base.start();
  // Rotation decides ties of the triangulation differently, so parts and lengths may differ a little.
  EXPECT_NEAR(length_of(transformed(map.free, 0, {5, 9}), s + Point(5, 9)) / length, 1, 0.15);
  EXPECT_NEAR(length_of(transformed(map.free, kPi / 2, {0, 0}), rotated(s, kPi / 2)) / length, 1, 0.15);
  EXPECT_NEAR(length_of(mirrored(map.free), {-s.x(), s.y()}) / length, 1, 0.15);
}

// Trapezoids turn with the lanes, so that a room that lies askew takes no more lanes than one that does not.
TEST(Zigzag, ARoomAskewTakesNoMoreLanes) {
  const Region room = box_region({0, 0}, {10, 7});
  const auto length_of = [](Region region, Point start) {
    return plan("zigzag", Problem(Map{"askew", std::move(region), "", ""}, disc(0.2, 0.4), start)).length();
  };
  const double length = length_of(room, {5, 3});
  for (const double degrees : {17.0, 45.0, 70.0}) {
    const double turn = degrees * kPi / 180;
    EXPECT_NEAR(length_of(transformed(room, turn, {0, 0}), rotated({5, 3}, turn)) / length, 1, 0.02) << degrees;
  }
}

TEST(Parts, PartsMakeUpTheRegion) {
  for (const auto seed : seeds(5)) {
    const Region region = generate("polygon", {}, seed).free;
    for (const Partition partition :
         {Partition::approximate, Partition::monotone, Partition::trapezoid, Partition::none}) {
      double sum = 0;
      for (const Part& p : cut_into_parts(region, partition, 30)) sum += p.area;
      EXPECT_NEAR(sum / area(region), 1, 1e-6) << static_cast<int>(partition) << " " << seed;
    }
  }
}

TEST(Parts, SliversAreMergedWithTheNeighbourThatSharesTheMostBoundary) {
  const auto box = [](double x0, double y0, double x1, double y1) {
    const Ring ring = box_region({x0, y0}, {x1, y1}).polygons[0].outer;
    return Part{{ring}, (x1 - x0) * (y1 - y0)};
  };
  // A sliver between a small part (1 m of common boundary) and a large one (3 m, as two edges).
  const std::vector<Part> parts{box(0, 1.01, 1, 2), box(0, 1, 3, 1.01), box(0, 0, 3, 1)};
  const std::vector<Part> merged = with_slivers_merged(parts, 1);
  ASSERT_EQ(merged.size(), 2u);
  EXPECT_NEAR(merged[0].area, 0.99, 1e-12);
  EXPECT_NEAR(merged[1].area, 3.03, 1e-12);
  EXPECT_EQ(merged[1].rings.size(), 2u);
  EXPECT_EQ(without_slivers(parts, 1).size(), 2u);
}

}  // namespace
}  // namespace oxturn

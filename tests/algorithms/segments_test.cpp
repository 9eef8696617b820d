// Zigzag with a direction and a fill for each part, and smooth spirals in parts.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "algorithms/polygon/island_cuts.hpp"
#include "algorithms/polygon/segment_fill.hpp"
#include "algorithms/polygon/wave_tree.hpp"
#include "coverage_oracle.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr int kSamples = 700;
constexpr double kSeams = 2e-3;  // see laps_test.cpp

std::string text(const char* s) { return s; }

/// Metres of work in a box, by whole degrees of its direction, [0, 180).
std::vector<double> work_by_direction(const Path& path, const Box& box) {
  std::vector<double> metres(180, 0);
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; leg.tool && i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      if (!box.contains(Point((a + b) / 2)) || a == b) continue;
      const double degrees = std::atan2(b.y() - a.y(), b.x() - a.x()) * 180 / kPi;
      metres[static_cast<std::size_t>(std::lround(degrees) + 360) % 180] += distance(a, b);
    }
  return metres;
}

/// The direction with the most metres.
std::size_t main_direction(const Path& path, const Box& box) {
  const std::vector<double> metres = work_by_direction(path, box);
  return static_cast<std::size_t>(std::ranges::max_element(metres) - metres.begin());
}

/// An L: an arm of 12 m x 4 m to the right and one of 4 m x 12 m upwards.
Problem l_shape() {
  const Region l{{{{{0, 0}, {12, 0}, {12, 4}, {4, 4}, {4, 12}, {0, 12}}, {}}}};
  return Problem(Map{"L", l, "", ""}, disc(0.2, 0.4), Point(1, 1));
}
const Box kRight{{5, 0.7}, {11.3, 3.3}}, kUp{{0.7, 5}, {3.3, 11.3}};

TEST(ZigzagSegments, EachPartIsDrivenAlongItself) {
  const Path path = plan("zigzag", l_shape(), {{"directions", text("own")}});
  expect_valid(l_shape(), path);
  EXPECT_EQ(main_direction(path, kRight), 0u);
  EXPECT_EQ(main_direction(path, kUp), 90u);
}

TEST(ZigzagSegments, APersonChoosesDirectionsAndFills) {
  const Problem p = l_shape();
  const Path path = plan("zigzag", p, {{"segments", text("8 2 30; 2, 8, -40")}, {"partition", text("convex")}});
  expect_valid(p, path);
  EXPECT_LE(uncovered_share(p, path, kSamples), 0);
  EXPECT_EQ(main_direction(path, kRight), 30u);
  EXPECT_EQ(main_direction(path, kUp), 140u);
  const Path spiral = plan("zigzag", p, {{"segments", text("8 2 spiral;")}, {"partition", text("convex")}});
  expect_valid(p, spiral);
  EXPECT_LE(uncovered_share(p, spiral, kSamples), kSeams);
  const std::vector<double> right = work_by_direction(spiral, {{5, 0.3}, {11.7, 3.7}});
  EXPECT_GT(right[0], 10);
  EXPECT_GT(right[90], 2) << "laps turn at the end of the arm";
}

TEST(ZigzagSegments, EveryFamilyIsCoveredWhole) {
  for (const Problem& p : sample_problems(4))
    for (const char* partition : {"trapezoid", "none"})
      for (const Settings& settings : {Settings{{"directions", text("own")}}, Settings{{"fill", text("spiral")}},
                                       Settings{{"fill", text("spiral")}, {"headland", std::int64_t{1}}}}) {
        SCOPED_TRACE(p.map().source + " " + partition + " " + to_text(settings));
        Settings all = settings;
        all["partition"] = text(partition);
        const Path path = plan("zigzag", p, all);
        expect_valid(p, path);
        EXPECT_LE(uncovered_share(p, path, kSamples), kSeams);
      }
}

TEST(ZigzagSegments, WhatCannotBeReadIsOneSentence) {
  const auto with = [](const char* segments) {
    return [segments] { plan("zigzag", l_shape(), {{"segments", text(segments)}}); };
  };
  EXPECT_THAT(with("8 2 spril"), ThrowsMessage<std::invalid_argument>(HasSubstr("'8 2 spril' of planner 'zigzag'")));
  EXPECT_THAT(with("8 2 400"), ThrowsMessage<std::invalid_argument>(HasSubstr("-360 to 360")));
  EXPECT_THAT(with("8 2"), ThrowsMessage<std::invalid_argument>(HasSubstr("'x y degrees'")));
  EXPECT_THAT(with("8 nan 20"), ThrowsMessage<std::invalid_argument>(HasSubstr("'x y degrees'")));
  EXPECT_THAT(with("9 9 spiral"), ThrowsMessage<Infeasible>(HasSubstr("no part holds (9, 9)")));
}

// By hand: in a square the wave travels a to the sides while it travels a sqrt 2 to the vertices.
TEST(IslandCuts, StepVariationOfASquare) {
  std::vector<WaveTree> trees = wave_trees(medial_axis(box_region({0, 0}, {6, 6}), 0.01));
  ASSERT_EQ(trees.size(), 1u);
  trees[0].root_at_centre();
  EXPECT_NEAR(trees[0].step_variation(1e300), std::sqrt(2), 1e-6);
}

TEST(IslandCuts, PartsMakeUpTheRegionAndHaveNoHoles) {
  for (const auto seed : seeds(2)) {
    SCOPED_TRACE(seed);
    const Region region = generate("field", {{"width", 20.0}, {"height", 14.0}}, seed).free;
    Context context;
    const Region parts = decomposed(region, {1e-4, 1e-2, 1.5}, context);
    EXPECT_NEAR(area(parts), area(region), 0.02);
    for (const Polygon& part : parts.polygons) EXPECT_TRUE(part.holes.empty());
    EXPECT_GE(parts.polygons.size(), bridged(region, 1e-4).polygons.size());
  }
}

/// The greatest step between laps over the least one, of the most uneven part.
double worst_variation(const Region& parts) {
  double worst = 1;
  for (WaveTree& tree : wave_trees(medial_axis(parts, 1e-2))) {
    tree.root_at_centre();
    worst = std::max(worst, tree.step_variation(1.5 * tree.greatest_clearance()));
  }
  return worst;
}

TEST(IslandCuts, LapsAreMoreEvenThanWithBridgesAlone) {
  int more_even = 0;
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(seed);
    const Region region = generate("field", {{"width", 30.0}, {"height", 20.0}}, seed).free;
    Context context;
    const Region one = bridged(region, 1e-3), parts = decomposed(region, {1e-3, 1e-2, 1.5}, context);
    const double gain = worst_variation(one) - worst_variation(parts);
    const auto cuts = static_cast<double>(parts.polygons.size() - one.polygons.size());
    EXPECT_GE(gain, 0.8 * cuts) << "what a part costs";
    more_even += gain > 1;
  }
  EXPECT_GE(more_even, 1);
}

TEST(SmoothSpiral, PartsCoverToo) {
  const Problem p(generate("field", {{"width", 10.0}, {"height", 7.0}}, 2), Robot{});
  const Path path = plan("smooth-spiral", p, {{"islands", text("decompose")}});
  expect_valid(p, path);
  EXPECT_LE(uncovered_share(p, path, 300), kSeams);
}

}  // namespace
}  // namespace oxturn
